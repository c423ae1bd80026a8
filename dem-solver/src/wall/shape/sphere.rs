//! A sphere.

use super::{Nearest, Piece, Side};
use crate::vector::{Spin, Vector};
use surface::motion::Travel;

/// A sphere, in 2D a circle; grains are on one side of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere<const D: usize> {
    /// Centre \[m\].
    pub centre: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
    /// Where grains are.
    pub side: Side,
}

impl<const D: usize> Piece<D> for Sphere<D> {
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        self.side.nearest(&(centre - self.centre), self.radius)
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        let (low, high) = (self.centre.add_scalar(-self.radius), self.centre.add_scalar(self.radius));
        (self.side == Side::Inside).then_some((low, high))
    }

    fn encloses(&self) -> bool {
        self.side == Side::Inside
    }

    fn tilts(&self, _: &Spin) -> bool {
        false
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        travel.of_point(&self.centre).norm()
    }
}
