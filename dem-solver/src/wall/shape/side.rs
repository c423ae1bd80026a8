//! On which side of a round wall grains are.

use super::Nearest;
use crate::vector::Vector;

/// On which side of a round wall grains are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Between the axis, or the centre, and the wall.
    Inside,
    /// Around the wall.
    Outside,
}

impl Side {
    /// The nearest point of a round wall of this radius \[m\] to a centre at `radial` from its axis: distance
    /// ±(R - |ρ|); on the other side it is negative and still pushes back.
    #[inline]
    pub(super) fn nearest<const D: usize>(self, radial: &Vector<D>, radius: f64) -> Nearest<D> {
        let off_axis = radial.norm();
        let outwards = if off_axis > 0.0 { radial / off_axis } else { Vector::zeros() };
        match self {
            Self::Inside => Nearest { distance: radius - off_axis, normal: outwards },
            Self::Outside => Nearest { distance: off_axis - radius, normal: -outwards },
        }
    }
}
