//! Uniform by number.

use super::Distribution;
use crate::insertion::Random;

/// Radii uniform by number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform {
    /// Smallest radius \[m\].
    pub smallest: f64,
    /// Largest radius \[m\].
    pub largest: f64,
}

impl Distribution for Uniform {
    fn smallest(&self) -> f64 {
        self.smallest
    }

    fn largest(&self) -> f64 {
        self.largest
    }

    fn draw(&self, random: &mut Random) -> f64 {
        random.between(self.smallest, self.largest)
    }
}
