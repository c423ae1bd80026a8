//! A sphere, in 2D a circle.

use std::f64::consts::PI;

use super::{Space, in_unit_ball};
use crate::domain::Domain;
use crate::insertion::Random;
use crate::vector::Vector;

/// A sphere, in 2D a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereRegion<const D: usize> {
    /// Centre \[m\].
    pub centre: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
}

impl<const D: usize> Space<D> for SphereRegion<D> {
    fn bounds(&self) -> (Vector<D>, Vector<D>) {
        (self.centre.add_scalar(-self.radius), self.centre.add_scalar(self.radius))
    }

    fn volume(&self) -> f64 {
        let unit = if D == 2 { PI } else { 4.0 / 3.0 * PI };
        unit * self.radius.powi(D as i32)
    }

    fn holds(&self, point: &Vector<D>) -> bool {
        (point - self.centre).norm() <= self.radius
    }

    fn place(&self, _: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>> {
        let room = self.radius - radius;
        (room >= 0.0).then(|| self.centre + in_unit_ball::<D>(random) * room)
    }
}
