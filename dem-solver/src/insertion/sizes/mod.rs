//! Size distributions of grains.

mod classes;
mod lognormal;
mod normal;
mod uniform;

use super::random::Random;

pub use classes::{Class, Classes};
pub use lognormal::Lognormal;
pub use normal::Normal;
pub use uniform::Uniform;

/// A distribution of radii between two ends.
pub trait Distribution {
    /// Smallest radius \[m\].
    fn smallest(&self) -> f64;

    /// Largest radius \[m\].
    fn largest(&self) -> f64;

    /// The next radius \[m\].
    fn draw(&self, random: &mut Random) -> f64;
}

/// The radii of an insertion.
#[derive(Clone, Debug, PartialEq)]
pub enum Sizes {
    /// One radius \[m\].
    All(f64),
    /// Uniform by number.
    Uniform(Uniform),
    /// Normal by number, cut off.
    Normal(Normal),
    /// Lognormal by number, cut off.
    Lognormal(Lognormal),
    /// Classes with stated shares of the mass.
    Classes(Classes),
}

impl Distribution for Sizes {
    fn smallest(&self) -> f64 {
        match self {
            Self::All(radius) => *radius,
            Self::Uniform(sizes) => sizes.smallest(),
            Self::Normal(sizes) => sizes.smallest(),
            Self::Lognormal(sizes) => sizes.smallest(),
            Self::Classes(sizes) => sizes.smallest(),
        }
    }

    fn largest(&self) -> f64 {
        match self {
            Self::All(radius) => *radius,
            Self::Uniform(sizes) => sizes.largest(),
            Self::Normal(sizes) => sizes.largest(),
            Self::Lognormal(sizes) => sizes.largest(),
            Self::Classes(sizes) => sizes.largest(),
        }
    }

    fn draw(&self, random: &mut Random) -> f64 {
        match self {
            Self::All(radius) => *radius,
            Self::Uniform(sizes) => sizes.draw(random),
            Self::Normal(sizes) => sizes.draw(random),
            Self::Lognormal(sizes) => sizes.draw(random),
            Self::Classes(sizes) => sizes.draw(random),
        }
    }
}
