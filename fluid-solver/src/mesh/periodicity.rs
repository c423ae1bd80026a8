//! Periodic axes of a mesh.

use crate::element::simplex::Vector;

/// One period of an axis: `[lower, lower + length)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Period {
    /// Where it begins (m).
    pub lower: f64,
    /// Its length (m).
    pub length: f64,
}

/// The period of each axis, `None` where the mesh is not periodic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Periodicity<const D: usize>(pub [Option<Period>; D]);

impl<const D: usize> Periodicity<D> {
    /// The image of `x` that lies in the mesh's own period.
    pub fn wrap(&self, x: &Vector<D>) -> Vector<D> {
        std::array::from_fn(|k| match self.0[k] {
            Some(period) => period.wrap(x[k]),
            None => x[k],
        })
    }
}

impl Period {
    fn wrap(&self, x: f64) -> f64 {
        let offset = x - self.lower;
        if (0.0..self.length).contains(&offset) {
            return x;
        }
        let wrapped = self.lower + offset.rem_euclid(self.length);
        // A tiny negative offset rounds up to a whole period.
        if wrapped - self.lower >= self.length { self.lower } else { wrapped }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_lands_inside_the_period_and_leaves_inner_points_alone() {
        let period = Period { lower: -0.3, length: 1.1 };
        for x in [-0.3, 0.0, 0.1, 0.799] {
            assert_eq!(period.wrap(x), x);
        }
        for x in [-0.3 - 1e-18, -1e9, 1e9, 0.8, 3.3, -1e-300] {
            let wrapped = period.wrap(x);
            assert!((0.0..1.1).contains(&(wrapped + 0.3)), "{x} → {wrapped}");
        }
        assert!((period.wrap(2.0) - 0.9 + 1.1).abs() < 1e-15);
        assert!(period.wrap(f64::NAN).is_nan());
    }
}
