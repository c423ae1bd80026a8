//! A circular disc.

use super::{Nearest, Piece, axial_and_radial, circle_bounds};
use crate::vector::{Spin, Vector};
use surface::motion::Travel;

/// A flat circular disc; it pushes to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc<const D: usize> {
    /// Centre \[m\].
    pub centre: Vector<D>,
    /// Unit normal.
    pub axis: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
}

impl<const D: usize> Piece<D> for Disc<D> {
    /// The foot on the disc, beyond its rim the nearest point of that.
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        let (axial, radial) = axial_and_radial(centre, &self.centre, &self.axis);
        let off_axis = radial.norm();
        let beyond = (off_axis - self.radius).max(0.0);
        let inwards = if beyond > 0.0 { radial * (-beyond / off_axis) } else { Vector::zeros() };
        let to_wall = inwards - self.axis * axial;
        let distance = to_wall.norm();
        let normal = if distance > 0.0 { to_wall / distance } else { Vector::zeros() };
        Nearest { distance, normal }
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        Some(circle_bounds(&self.centre, &self.axis, self.radius))
    }

    fn encloses(&self) -> bool {
        false
    }

    fn tilts(&self, _: &Spin) -> bool {
        false
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        travel.of_point(&self.centre).norm() + self.radius * travel.of_direction(&self.axis).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_foot_is_on_the_disc_or_on_its_rim() {
        let disc = Disc::<3> {
            centre: Vector::from([0.0, 0.0, 1.0]),
            axis: Vector::from([0.0, 0.0, 1.0]),
            radius: 2.0,
        };
        let above = disc.nearest(&Vector::from([1.0, 1.0, 1.5]));
        assert_eq!((above.distance, above.normal), (0.5, Vector::from([0.0, 0.0, -1.0])));
        let aside = disc.nearest(&Vector::from([5.0, 0.0, -3.0]));
        assert!((aside.distance - 5.0).abs() < 1e-15);
        assert!((aside.normal - Vector::from([-0.6, 0.0, 0.8])).norm() < 1e-15);
    }
}
