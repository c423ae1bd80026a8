//! The pieces of walls, as they are at t = 0.

mod cylinder;
mod disc;
mod facet;
mod plane;
mod side;
mod sphere;
mod tube;

use crate::vector::{Spin, Vector};
use surface::motion::Travel;

pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use side::Side;
pub use sphere::Sphere;
pub use surface::Facet;
pub use tube::Tube;

/// The point of a surface that is nearest to a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const D: usize> {
    /// Distance \[m\]; negative behind a surface that has one side only.
    pub distance: f64,
    /// Unit normal from the centre to the wall; zero if the centre lies in a surface, or on the axis of a round one.
    pub normal: Vector<D>,
}

/// A surface that grains touch.
pub trait Piece<const D: usize> {
    /// The nearest point of the surface.
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D>;

    /// Corners of the smallest box around a surface that has ends and that grains may be around.
    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)>;

    /// Whether all its grains are on one side, so that no image of them across a periodic boundary may see it.
    fn encloses(&self) -> bool;

    /// Whether a turn about this axis takes distant parts of the surface anywhere.
    fn tilts(&self, axis: &Spin) -> bool;

    /// The surface comes nearer to nothing by more than this \[m\] while it travels; one that tilts is not asked.
    fn approach(&self, travel: &Travel<D>) -> f64;
}

/// A piece of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// A half-space.
    Plane(Plane<D>),
    /// A cylinder without ends.
    Cylinder(Cylinder<D>),
    /// A sphere (2D: a circle).
    Sphere(Sphere<D>),
    /// The shell of a cylinder with ends.
    Tube(Tube<D>),
    /// A circular disc (3D).
    Disc(Disc<D>),
    /// A triangle (2D: a segment).
    Facet(Facet<D>),
}

impl<const D: usize> Piece<D> for Shape<D> {
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        match self {
            Self::Plane(piece) => piece.nearest(centre),
            Self::Cylinder(piece) => piece.nearest(centre),
            Self::Sphere(piece) => piece.nearest(centre),
            Self::Tube(piece) => piece.nearest(centre),
            Self::Disc(piece) => piece.nearest(centre),
            Self::Facet(piece) => piece.nearest(centre),
        }
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        match self {
            Self::Plane(piece) => piece.bounds(),
            Self::Cylinder(piece) => piece.bounds(),
            Self::Sphere(piece) => piece.bounds(),
            Self::Tube(piece) => piece.bounds(),
            Self::Disc(piece) => piece.bounds(),
            Self::Facet(piece) => piece.bounds(),
        }
    }

    fn encloses(&self) -> bool {
        match self {
            Self::Plane(piece) => piece.encloses(),
            Self::Cylinder(piece) => piece.encloses(),
            Self::Sphere(piece) => piece.encloses(),
            Self::Tube(piece) => piece.encloses(),
            Self::Disc(piece) => piece.encloses(),
            Self::Facet(piece) => piece.encloses(),
        }
    }

    fn tilts(&self, axis: &Spin) -> bool {
        match self {
            Self::Plane(piece) => piece.tilts(axis),
            Self::Cylinder(piece) => piece.tilts(axis),
            Self::Sphere(piece) => piece.tilts(axis),
            Self::Tube(piece) => piece.tilts(axis),
            Self::Disc(piece) => piece.tilts(axis),
            Self::Facet(piece) => piece.tilts(axis),
        }
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        match self {
            Self::Plane(piece) => piece.approach(travel),
            Self::Cylinder(piece) => piece.approach(travel),
            Self::Sphere(piece) => piece.approach(travel),
            Self::Tube(piece) => piece.approach(travel),
            Self::Disc(piece) => piece.approach(travel),
            Self::Facet(piece) => piece.approach(travel),
        }
    }
}

/// The axial coordinate of a place above `base`, and its radial vector from the axis.
#[inline]
fn axial_and_radial<const D: usize>(
    place: &Vector<D>,
    base: &Vector<D>,
    axis: &Vector<D>,
) -> (f64, Vector<D>) {
    let from_base = place - base;
    let axial = from_base.dot(axis);
    (axial, from_base - axis * axial)
}

/// Corners of the smallest box around a circle of this radius about `centre`, normal to `axis`.
fn circle_bounds<const D: usize>(
    centre: &Vector<D>,
    axis: &Vector<D>,
    radius: f64,
) -> (Vector<D>, Vector<D>) {
    let half = axis.map(|a| radius * (1.0 - a * a).max(0.0).sqrt());
    (centre - half, centre + half)
}
