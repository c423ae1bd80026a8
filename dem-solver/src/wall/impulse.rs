//! What walls receive from grains.

use std::ops::{AddAssign, Sub};

use crate::vector::{Spin, Vector, moment};

/// Impulse that grains gave to a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallImpulse<const D: usize> {
    /// Impulse ∫F dt \[N s\].
    pub linear: Vector<D>,
    /// Angular impulse about the origin ∫x × F dt \[N m s\].
    pub angular: Spin,
}

impl<const D: usize> WallImpulse<D> {
    /// Nothing.
    pub fn zero() -> Self {
        Self { linear: Vector::zeros(), angular: Spin::zeros() }
    }

    /// An impulse \[N s\] that acts at `place`.
    #[inline]
    pub fn at(place: &Vector<D>, impulse: Vector<D>) -> Self {
        Self { linear: impulse, angular: moment(place, &impulse) }
    }

    /// Angular impulse about a point \[N m s\].
    pub fn about(&self, point: &Vector<D>) -> Spin {
        self.angular - moment(point, &self.linear)
    }
}

impl<const D: usize> AddAssign for WallImpulse<D> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.linear += other.linear;
        self.angular += other.angular;
    }
}

impl<const D: usize> Sub for WallImpulse<D> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

/// What each wall received since some time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Received<const D: usize> {
    /// Since this time \[s\].
    pub since: f64,
    /// By wall; nothing before the first window.
    pub impulse: Vec<WallImpulse<D>>,
}

impl<const D: usize> Received<D> {
    /// Adds what each wall received in a window.
    pub fn add(&mut self, window: &[WallImpulse<D>]) {
        self.impulse.resize(window.len(), WallImpulse::zero());
        self.impulse.iter_mut().zip(window).for_each(|(sum, &impulse)| *sum += impulse);
    }

    /// Begins anew at this time \[s\].
    pub fn restart(&mut self, time: f64) {
        self.since = time;
        self.impulse.clear();
    }

    /// Memory that is already here takes the state of `other`.
    pub fn copy_from(&mut self, other: &Self) {
        self.since = other.since;
        self.impulse.clone_from(&other.impulse);
    }
}
