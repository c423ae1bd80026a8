//! The normal distribution, cut off.

use super::Distribution;
use crate::insertion::Random;

/// Radii of number density ∝ exp(-(r - m)²/2s²) between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normal {
    /// Mean m of the distribution before it is cut off \[m\].
    pub mean: f64,
    /// Standard deviation s before it is cut off \[m\].
    pub deviation: f64,
    /// Smallest radius \[m\].
    pub smallest: f64,
    /// Largest radius \[m\].
    pub largest: f64,
}

impl Distribution for Normal {
    fn smallest(&self) -> f64 {
        self.smallest
    }

    fn largest(&self) -> f64 {
        self.largest
    }

    /// By rejection, from a uniform draw: no tail is too far out for it.
    fn draw(&self, random: &mut Random) -> f64 {
        let exponent = |r: f64| 0.5 * ((r - self.mean) / self.deviation).powi(2);
        let likeliest = exponent(self.mean.clamp(self.smallest, self.largest));
        loop {
            let r = random.between(self.smallest, self.largest);
            if random.between(0.0, 1.0) < (likeliest - exponent(r)).exp() {
                return r;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_have_the_moments_of_the_distribution_and_stay_between_its_ends() {
        let moments = |sizes: Normal| {
            let mut random = Random::new(5);
            let draws: Vec<f64> = (0..100_000).map(|_| sizes.draw(&mut random)).collect();
            assert!(draws.iter().all(|r| *r >= sizes.smallest && *r <= sizes.largest));
            let mean = draws.iter().sum::<f64>() / 1e5;
            (mean, (draws.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / 1e5).sqrt())
        };
        let (mean, deviation) = moments(Normal { mean: 3.0, deviation: 0.2, smallest: 2.0, largest: 4.0 });
        assert!((mean - 3.0).abs() < 2e-3 && (deviation - 0.2).abs() < 2e-3, "{mean} {deviation}");
        // Far out the tail is an exponential of decay length s²/(end - m), here 0.04/2.
        let (mean, _) = moments(Normal { mean: 3.0, deviation: 0.2, smallest: 5.0, largest: 6.0 });
        assert!((mean - 5.02).abs() < 5e-4, "{mean}");
    }
}
