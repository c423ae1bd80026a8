//! Cohesion of bodies that touch.

mod sjkr;
mod sjkr2;

use crate::lanes::Lanes;

pub use sjkr::Sjkr;
pub use sjkr2::Sjkr2;

/// A law for the area A over which two bodies attract each other: F = -k A with k the pair's density of cohesive energy
/// \[J/m³\]. It counts among the normal forces that friction and resistance to rolling follow.
pub trait Cohesion {
    /// Of two spheres at this distance \[m²\].
    fn area_of_spheres<L: Lanes>(radius_i: L, radius_j: L, distance: L) -> L;

    /// Of a sphere at this distance from a wall \[m²\].
    fn area_on_wall<L: Lanes>(radius: L, distance: L) -> L;
}

/// The laws of cohesion that a case can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CohesionLaw {
    /// `"sjkr"`: [`Sjkr`].
    Sjkr,
    /// `"sjkr2"`: [`Sjkr2`].
    Sjkr2,
}

impl CohesionLaw {
    /// Area of two spheres at this distance \[m²\].
    #[inline(always)]
    pub fn area_of_spheres<L: Lanes>(self, radius_i: L, radius_j: L, distance: L) -> L {
        match self {
            Self::Sjkr => Sjkr::area_of_spheres(radius_i, radius_j, distance),
            Self::Sjkr2 => Sjkr2::area_of_spheres(radius_i, radius_j, distance),
        }
    }

    /// Area of a sphere at this distance from a wall \[m²\].
    #[inline(always)]
    pub fn area_on_wall<L: Lanes>(self, radius: L, distance: L) -> L {
        match self {
            Self::Sjkr => Sjkr::area_on_wall(radius, distance),
            Self::Sjkr2 => Sjkr2::area_on_wall(radius, distance),
        }
    }
}
