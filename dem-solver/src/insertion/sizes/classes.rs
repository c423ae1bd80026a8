//! Classes of sizes with stated shares of the mass.

use super::Distribution;
use crate::insertion::Random;

/// Radii between two ends, or of one value, and their share of the mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Class {
    /// Smallest radius \[m\].
    pub smallest: f64,
    /// Largest radius \[m\].
    pub largest: f64,
    /// Share of the mass; only ratios count.
    pub mass: f64,
}

/// A mixture, or a sieve curve: within a class the mass is uniform in ln r, as a straight line between two sieves is on
/// the usual paper.
///
/// Grains of radius r weigh ∝ r^D: a class of mass f has f (a^-D - b^-D)/(D ln b/a) grains, in the limit f a^-D.
#[derive(Clone, Debug, PartialEq)]
pub struct Classes {
    classes: Vec<Class>,
    /// Share of the grains in the classes up to each.
    cumulative: Vec<f64>,
    dimension: f64,
}

impl Classes {
    /// Of grains in `dimension` dimensions.
    pub fn new(classes: Vec<Class>, dimension: usize) -> Self {
        let dimension = dimension as f64;
        let number = |&Class { smallest: a, largest: b, mass }: &Class| {
            let spread = (b / a).ln();
            let mean =
                if spread > 0.0 { (1.0 - (-dimension * spread).exp()) / (dimension * spread) } else { 1.0 };
            mass * a.powf(-dimension) * mean
        };
        let total: f64 = classes.iter().map(number).sum();
        let add = |sum: &mut f64, class| {
            *sum += number(class) / total;
            Some(*sum)
        };
        let cumulative = classes.iter().scan(0.0, add).collect();
        Self { classes, cumulative, dimension }
    }
}

impl Distribution for Classes {
    fn smallest(&self) -> f64 {
        self.classes.iter().map(|class| class.smallest).fold(f64::INFINITY, f64::min)
    }

    fn largest(&self) -> f64 {
        self.classes.iter().map(|class| class.largest).fold(0.0, f64::max)
    }

    fn draw(&self, random: &mut Random) -> f64 {
        let at = random.between(0.0, 1.0);
        let index = self.cumulative.partition_point(|sum| *sum <= at).min(self.classes.len() - 1);
        let Class { smallest: a, largest: b, .. } = self.classes[index];
        if a == b {
            return a;
        }
        let ratio = (b / a).powf(-self.dimension);
        let u = random.between(0.0, 1.0);
        (a * (1.0 - u * (1.0 - ratio)).powf(-1.0 / self.dimension)).clamp(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn masses(classes: &Classes, ends: &[f64]) -> Vec<f64> {
        let mut random = Random::new(11);
        let mut masses = vec![0.0; ends.len()];
        let mut total = 0.0;
        for _ in 0..400_000 {
            let r = classes.draw(&mut random);
            masses[ends.partition_point(|end| *end < r)] += r.powi(3);
            total += r.powi(3);
        }
        masses.into_iter().map(|mass| mass / total).collect()
    }

    #[test]
    fn a_mixture_has_its_shares_of_the_mass() {
        let one = |radius: f64, mass: f64| Class { smallest: radius, largest: radius, mass };
        let mixture = Classes::new(vec![one(1.0, 0.2), one(2.0, 0.5), one(3.0, 0.3)], 3);
        let found = masses(&mixture, &[1.5, 2.5, 3.5]);
        for (found, stated) in found.iter().zip([0.2, 0.5, 0.3]) {
            assert!((found - stated).abs() < 5e-3, "{found} {stated}");
        }
    }

    #[test]
    fn a_sieve_curve_is_met_between_the_sieves_too() {
        let class = |smallest: f64, largest: f64, mass: f64| Class { smallest, largest, mass };
        let curve = Classes::new(vec![class(1.0, 2.0, 0.3), class(2.0, 4.0, 0.7)], 3);
        let middle = 8.0_f64.sqrt();
        let found = masses(&curve, &[2.0_f64.sqrt(), 2.0, middle, 4.0]);
        for (found, stated) in found.iter().zip([0.15, 0.15, 0.35, 0.35]) {
            assert!((found - stated).abs() < 5e-3, "{found} {stated}");
        }
        assert_eq!((curve.smallest(), curve.largest()), (1.0, 4.0));
    }
}
