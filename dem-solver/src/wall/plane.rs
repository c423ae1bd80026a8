//! A half-space.

use super::Nearest;
use crate::vector::Vector;

/// An infinite plane; grains are on the side of its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<const D: usize> {
    /// A point of the plane \[m\].
    pub point: Vector<D>,
    /// Unit normal, towards the grains.
    pub normal: Vector<D>,
}

impl<const D: usize> Plane<D> {
    /// Distance (x - p)·n; behind the plane it is negative and still pushes out.
    #[inline]
    pub fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        Nearest { distance: (centre - self.point).dot(&self.normal), normal: -self.normal }
    }
}
