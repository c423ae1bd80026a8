//! A plane (2D: a line) at rest.

use super::Touch;
use crate::element::simplex::{Vector, difference, dot};

/// The half space n·(x − o) ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<const D: usize> {
    /// A point o of the plane (m).
    pub point: Vector<D>,
    /// Unit normal n towards the fluid.
    pub normal: Vector<D>,
}

impl<const D: usize> Plane<D> {
    /// How it stands to a point.
    pub fn touch(&self, x: &Vector<D>) -> Touch<D> {
        let gap = dot(&self.normal, &difference(x, &self.point));
        Touch { gap, normal: self.normal, velocity: [0.0; D] }
    }
}
