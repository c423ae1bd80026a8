//! Where a moving wall is, and how it moves.

use nalgebra::{Rotation3, SMatrix};

use crate::vector::{Spin, Vector, spin_velocity};

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
    /// What was at `origin` at t = 0 is at `point`, with this velocity \[m/s\]; the wall is turned about it by a
    /// rotation vector \[rad\], with this angular velocity \[rad/s\].
    pub(super) fn new(
        origin: Vector<D>,
        (point, velocity): (Vector<D>, Vector<D>),
        (turn, angular_velocity): (Spin, Spin),
    ) -> Self {
        let turn = Rotation3::new(turn);
        let turn = SMatrix::from_fn(|row, column| turn[(row, column)]);
        Self { origin, point, turn, velocity, angular_velocity }
    }

    /// That of a wall which stays where it was at t = 0.
    pub fn rest() -> Self {
        Self::new(Vector::zeros(), (Vector::zeros(), Vector::zeros()), (Spin::zeros(), Spin::zeros()))
    }

    /// The pose slid on by a displacement \[m\] at a velocity \[m/s\].
    pub fn slid(self, displacement: &Vector<D>, velocity: &Vector<D>) -> Self {
        Self { point: self.point + displacement, velocity: self.velocity + velocity, ..self }
    }

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

/// The way of a wall from one pose to another.
#[derive(Clone, Copy, Debug)]
pub struct Travel<'a, const D: usize> {
    /// Where it was.
    pub before: &'a Pose<D>,
    /// Where it is.
    pub after: &'a Pose<D>,
}

impl<const D: usize> Travel<'_, D> {
    /// Displacement of the point of the wall that was at `start` at t = 0 \[m\].
    pub fn of_point(&self, start: &Vector<D>) -> Vector<D> {
        self.after.moved(start) - self.before.moved(start)
    }

    /// Change of the unit vector that was `start` at t = 0.
    pub fn of_direction(&self, start: &Vector<D>) -> Vector<D> {
        self.after.turned(start) - self.before.turned(start)
    }
}
