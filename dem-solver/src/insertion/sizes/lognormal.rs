//! The lognormal distribution, cut off.

use super::{Distribution, Normal};
use crate::insertion::Random;

/// Radii whose logarithm is normal by number, between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lognormal {
    logarithm: Normal,
}

impl Lognormal {
    /// Of this median \[m\] and standard deviation of ln r before it is cut off at the smallest and the largest radius \[m\].
    pub fn new(median: f64, deviation: f64, smallest: f64, largest: f64) -> Self {
        let logarithm =
            Normal { mean: median.ln(), deviation, smallest: smallest.ln(), largest: largest.ln() };
        Self { logarithm }
    }
}

impl Distribution for Lognormal {
    fn smallest(&self) -> f64 {
        self.logarithm.smallest.exp()
    }

    fn largest(&self) -> f64 {
        self.logarithm.largest.exp()
    }

    fn draw(&self, random: &mut Random) -> f64 {
        self.logarithm.draw(random).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_draws_are_below_the_median_and_the_mean_is_above() {
        let (sizes, mut random) = (Lognormal::new(1e-3, 0.5, 1e-5, 1e-1), Random::new(2));
        let draws: Vec<f64> = (0..100_000).map(|_| sizes.draw(&mut random)).collect();
        let below = draws.iter().filter(|r| **r < 1e-3).count() as f64 / 1e5;
        let mean = draws.iter().sum::<f64>() / 1e5;
        assert!((below - 0.5).abs() < 5e-3, "{below}");
        assert!((mean / (1e-3 * (0.125_f64).exp()) - 1.0).abs() < 5e-3, "{mean}");
    }
}
