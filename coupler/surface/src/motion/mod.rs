//! Prescribed motion of a wall.

mod pose;
mod table;

use std::f64::consts::TAU;

use crate::vector::{Spin, Vector};

pub use pose::{Pose, Travel};
pub use table::{Table, TableRow};

/// Rigid motion: the point X of the wall at t = 0 is at x(t) = p(t) + R(ωt + nθ(t))(X - p₀), where the axis goes along
/// with p(t) = p₀ + V t + A sin 2πft + d(t); d and θ are a table's.
#[derive(Clone, Debug, PartialEq)]
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
    /// Displacement d and angle θ about its axis n by a table, if any.
    pub table: Option<Table<D>>,
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
            table: None,
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

    /// Motion by a table, its angle about an axis through `point`.
    pub fn by_table(point: [f64; D], table: Table<D>) -> Self {
        Self { point: point.into(), table: Some(table), ..Self::none() }
    }

    /// Axes about which it turns the wall.
    pub fn axes(&self) -> impl Iterator<Item = Spin> {
        [self.angular_velocity].into_iter().chain(self.table.iter().map(|table| table.axis))
    }

    /// Where it has put the wall at a time \[s\], and how fast the wall is.
    pub fn pose(&self, time: f64) -> Pose<D> {
        let rate = TAU * self.frequency;
        let (sine, cosine) = (rate * time).sin_cos();
        let point = self.point + self.translation * time + self.amplitude * sine;
        let velocity = self.translation + self.amplitude * (rate * cosine);
        let (turn, spin) = (self.angular_velocity * time, self.angular_velocity);
        match &self.table {
            None => Pose::new(self.point, (point, velocity), (turn, spin)),
            Some(table) => {
                let (row, slope) = table.at(time);
                let place = (point + row.displacement, velocity + slope.displacement);
                let turn = (turn + table.axis * row.angle, spin + table.axis * slope.angle);
                Pose::new(self.point, place, turn)
            }
        }
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
            table: None,
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
