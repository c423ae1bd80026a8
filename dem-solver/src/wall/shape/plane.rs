//! A half-space.

use super::{Nearest, Piece};
use crate::vector::{Spin, Vector, embed};
use surface::motion::Travel;

/// An infinite plane; grains are on the side of its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<const D: usize> {
    /// A point of the plane \[m\].
    pub point: Vector<D>,
    /// Unit normal, towards the grains.
    pub normal: Vector<D>,
}

impl<const D: usize> Piece<D> for Plane<D> {
    /// Distance (x - p)·n; behind the plane it is negative and still pushes out.
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        Nearest { distance: (centre - self.point).dot(&self.normal), normal: -self.normal }
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        None
    }

    fn encloses(&self) -> bool {
        true
    }

    fn tilts(&self, axis: &Spin) -> bool {
        axis.cross(&embed(&self.normal)).norm_squared() > 0.0
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        travel.of_point(&self.point).dot(&self.normal).abs()
    }
}
