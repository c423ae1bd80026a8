//! Rotations by a rotation vector.

use crate::vector::Vector;

/// Angles squared below which the series are used; their remainder is below 3e-18.
const SMALL: f64 = 0.01;

/// The rotation by θ = |t| about t: R v = v + (sin θ/θ) t × v + ((1 - cos θ)/θ²) t × (t × v).
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    vector: Vector<3>,
    sine: f64,
    versine: f64,
}

impl Turn {
    /// By this rotation vector t \[rad\].
    pub fn new(vector: Vector<3>) -> Self {
        let square = vector.norm_squared();
        let (sine, versine) = if square < SMALL {
            // The turns of a step: neither root nor division.
            let next = |inner: f64, divisor: f64| 1.0 - square * (1.0 / divisor) * inner;
            let sine = next(next(next(next(1.0, 72.0), 42.0), 20.0), 6.0);
            let versine = 0.5 * next(next(next(next(1.0, 90.0), 56.0), 30.0), 12.0);
            (sine, versine)
        } else {
            let angle = square.sqrt();
            (angle.sin() / angle, (1.0 - angle.cos()) / square)
        };
        Self { vector, sine, versine }
    }

    /// R v.
    pub fn apply(&self, vector: &Vector<3>) -> Vector<3> {
        let once = self.vector.cross(vector);
        vector + once * self.sine + self.vector.cross(&once) * self.versine
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;

    #[test]
    fn small_turns_and_large_ones_are_rotations() {
        let (axis, vector) = (Vector::from([0.48, 0.64, 0.6]), Vector::from([1.0, -2.0, 0.5]));
        for angle in [0.0, 1e-9, 1e-3, 0.099, 0.0999999, 0.1000001, 1.0, 3.0, 6.0] {
            let expected = Rotation3::new(axis * angle) * vector;
            let found = Turn::new(axis * angle).apply(&vector);
            assert!((found - expected).norm() < 2e-15, "{angle}: {found} instead of {expected}");
        }
    }
}
