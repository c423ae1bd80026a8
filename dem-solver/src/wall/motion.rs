//! Prescribed motion of a wall, and where it puts the wall.

use std::f64::consts::TAU;

use nalgebra::{Rotation3, SMatrix};

use crate::vector::{Spin, Vector, spin_velocity};

/// Rigid motion: the point X of the wall at t = 0 is at x(t) = p(t) + R(ωt)(X - p₀), where the axis goes along with
/// p(t) = p₀ + V t + A sin 2πft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Velocity V of the translation \[m/s\].
    pub translation: Vector<D>,
    /// Amplitude A of the oscillation, with its direction \[m\].
    pub amplitude: Vector<D>,
    /// Frequency f of the oscillation \[1/s\].
    pub frequency: f64,
    /// Point p₀ of the axis at t = 0 \[m\].
    pub point: Vector<D>,
    /// Angular velocity ω \[rad/s\].
    pub angular_velocity: Spin,
}

impl<const D: usize> Motion<D> {
    /// No motion.
    pub fn none() -> Self {
        Self {
            translation: Vector::zeros(),
            amplitude: Vector::zeros(),
            frequency: 0.0,
            point: Vector::zeros(),
            angular_velocity: Spin::zeros(),
        }
    }

    /// Translation at this velocity \[m/s\].
    pub fn translation(velocity: [f64; D]) -> Self {
        Self { translation: velocity.into(), ..Self::none() }
    }

    /// Rotation about an axis through `point` at this angular velocity \[rad/s\].
    pub fn rotation(point: [f64; D], angular_velocity: [f64; 3]) -> Self {
        Self { point: point.into(), angular_velocity: angular_velocity.into(), ..Self::none() }
    }

    /// Oscillation of this amplitude, with its direction \[m\], and frequency \[1/s\].
    pub fn oscillation(amplitude: [f64; D], frequency: f64) -> Self {
        Self { amplitude: amplitude.into(), frequency, ..Self::none() }
    }

    /// Where it has put the wall at a time \[s\], and how fast the wall is.
    pub fn pose(&self, time: f64) -> Pose<D> {
        let rate = TAU * self.frequency;
        let (sine, cosine) = (rate * time).sin_cos();
        let turn = Rotation3::new(self.angular_velocity * time);
        Pose {
            origin: self.point,
            point: self.point + self.translation * time + self.amplitude * sine,
            turn: SMatrix::from_fn(|row, column| turn[(row, column)]),
            velocity: self.translation + self.amplitude * (rate * cosine),
            angular_velocity: self.angular_velocity,
        }
    }
}

/// Where a moving wall is, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<const D: usize> {
    origin: Vector<D>,
    point: Vector<D>,
    turn: SMatrix<f64, D, D>,
    velocity: Vector<D>,
    angular_velocity: Spin,
}

impl<const D: usize> Pose<D> {
    /// Where the point of the wall that was at `start` at t = 0 is now.
    pub fn moved(&self, start: &Vector<D>) -> Vector<D> {
        self.point + self.turn * (start - self.origin)
    }

    /// The place at t = 0 of what goes along with the wall and is at `place` now.
    #[inline]
    pub fn unmoved(&self, place: &Vector<D>) -> Vector<D> {
        self.origin + self.turn.tr_mul(&(place - self.point))
    }

    /// The direction now of what had `direction` at t = 0.
    #[inline]
    pub fn turned(&self, direction: &Vector<D>) -> Vector<D> {
        self.turn * direction
    }

    /// Velocity of the wall at a place \[m/s\].
    #[inline]
    pub fn velocity_at(&self, place: &Vector<D>) -> Vector<D> {
        self.velocity + spin_velocity(&self.angular_velocity, &(place - self.point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_velocity_is_the_rate_of_the_place_and_unmoving_undoes_moving() {
        let motion = Motion {
            translation: Vector::from([0.3, -0.2, 0.1]),
            amplitude: Vector::from([0.0, 0.02, 0.01]),
            frequency: 3.0,
            point: Vector::from([0.5, 0.1, -0.2]),
            angular_velocity: Spin::from([1.0, 2.0, -0.5]),
        };
        let (start, time, h) = (Vector::from([1.0, 2.0, 3.0]), 0.7, 1e-5);
        let pose = motion.pose(time);
        let place = pose.moved(&start);
        let rate = (motion.pose(time + h).moved(&start) - motion.pose(time - h).moved(&start)) / (2.0 * h);
        assert!((pose.velocity_at(&place) - rate).norm() < 1e-7);
        assert!((pose.unmoved(&place) - start).norm() < 1e-14);
        assert_eq!(motion.pose(0.0).moved(&start), start);
    }

    #[test]
    fn in_2d_the_wall_turns_anticlockwise() {
        let quarter = Motion::<2>::rotation([1.0, 0.0], [0.0, 0.0, TAU / 4.0]).pose(1.0);
        assert!((quarter.moved(&Vector::from([2.0, 0.0])) - Vector::from([1.0, 1.0])).norm() < 1e-15);
    }
}
