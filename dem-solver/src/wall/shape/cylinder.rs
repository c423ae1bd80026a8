//! A cylinder without ends.

use super::{Nearest, Piece, Side, axial_and_radial};
use crate::vector::{Spin, Vector, embed};
use surface::motion::Travel;

/// A circular cylinder without ends; grains are on one side of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder<const D: usize> {
    /// A point of the axis \[m\].
    pub point: Vector<D>,
    /// Unit vector along the axis.
    pub axis: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
    /// Where grains are.
    pub side: Side,
}

impl<const D: usize> Piece<D> for Cylinder<D> {
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        let (_, radial) = axial_and_radial(centre, &self.point, &self.axis);
        self.side.nearest(&radial, self.radius)
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        None
    }

    fn encloses(&self) -> bool {
        self.side == Side::Inside
    }

    fn tilts(&self, axis: &Spin) -> bool {
        axis.cross(&embed(&self.axis)).norm_squared() > 0.0
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        let way = travel.of_point(&self.point);
        (way - self.axis * way.dot(&self.axis)).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wall_is_across_the_axis_on_either_side() {
        let drum = Cylinder::<3> {
            point: Vector::from([1.0, 5.0, 0.0]),
            axis: Vector::from([0.0, 1.0, 0.0]),
            radius: 2.0,
            side: Side::Inside,
        };
        let inside = drum.nearest(&Vector::from([2.5, -7.0, 0.0]));
        assert_eq!((inside.distance, inside.normal), (0.5, Vector::from([1.0, 0.0, 0.0])));
        let roller = Cylinder { side: Side::Outside, ..drum };
        let outside = roller.nearest(&Vector::from([1.0, 0.0, -5.0]));
        assert_eq!((outside.distance, outside.normal), (3.0, Vector::from([0.0, 0.0, 1.0])));
    }
}
