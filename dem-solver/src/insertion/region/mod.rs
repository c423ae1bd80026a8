//! Regions of space that grains are put into or taken from.

mod ball;
mod cuboid;
mod rod;
mod surface;

use super::random::Random;
use crate::domain::Domain;
use crate::vector::Vector;

pub use ball::SphereRegion;
pub use cuboid::BoxRegion;
pub use rod::CylinderRegion;
pub use surface::SurfaceRegion;

/// A region of space.
pub trait Space<const D: usize> {
    /// Corners of the smallest box around it \[m\].
    fn bounds(&self) -> (Vector<D>, Vector<D>);

    /// Its volume \[m³\], in 2D its area \[m²\].
    fn volume(&self) -> f64;

    /// Whether a point is in it.
    fn holds(&self, point: &Vector<D>) -> bool;

    /// A uniformly random centre of a grain of this radius \[m\] that lies in it as a whole; nothing if it is too narrow.
    fn place(&self, domain: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>>;
}

/// One of the regions.
#[derive(Clone, Debug, PartialEq)]
pub enum Region<const D: usize> {
    /// A box.
    Box(BoxRegion<D>),
    /// A sphere (2D: a circle).
    Sphere(SphereRegion<D>),
    /// A cylinder with ends (3D).
    Cylinder(CylinderRegion<D>),
    /// The inside of a closed surface (3D).
    Surface(SurfaceRegion<D>),
}

impl<const D: usize> Space<D> for Region<D> {
    fn bounds(&self) -> (Vector<D>, Vector<D>) {
        match self {
            Self::Box(region) => region.bounds(),
            Self::Sphere(region) => region.bounds(),
            Self::Cylinder(region) => region.bounds(),
            Self::Surface(region) => region.bounds(),
        }
    }

    fn volume(&self) -> f64 {
        match self {
            Self::Box(region) => region.volume(),
            Self::Sphere(region) => region.volume(),
            Self::Cylinder(region) => region.volume(),
            Self::Surface(region) => region.volume(),
        }
    }

    fn holds(&self, point: &Vector<D>) -> bool {
        match self {
            Self::Box(region) => region.holds(point),
            Self::Sphere(region) => region.holds(point),
            Self::Cylinder(region) => region.holds(point),
            Self::Surface(region) => region.holds(point),
        }
    }

    fn place(&self, domain: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>> {
        match self {
            Self::Box(region) => region.place(domain, radius, random),
            Self::Sphere(region) => region.place(domain, radius, random),
            Self::Cylinder(region) => region.place(domain, radius, random),
            Self::Surface(region) => region.place(domain, radius, random),
        }
    }
}

/// A uniformly random vector in the unit ball.
fn in_unit_ball<const D: usize>(random: &mut Random) -> Vector<D> {
    loop {
        let point = Vector::<D>::from_fn(|_, _| random.between(-1.0, 1.0));
        if point.norm_squared() <= 1.0 {
            return point;
        }
    }
}
