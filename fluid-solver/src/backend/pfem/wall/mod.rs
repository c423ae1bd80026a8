//! Walls are geometry: nodes are on them only where they are wet, and slide.

mod contacts;
mod plane;

pub use contacts::Contacts;
pub use plane::Plane;

use crate::element::simplex::Vector;

/// How a wall stands to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<const D: usize> {
    /// Signed distance (m), positive where the fluid may be.
    pub gap: f64,
    /// Unit normal towards the fluid at the nearest place.
    pub normal: Vector<D>,
    /// Velocity of the wall there (m/s).
    pub velocity: Vector<D>,
}

/// Whether the fluid sticks to a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// v·n = 0, no shear.
    Slip,
    /// v = 0 of all but the nodes of the contact line, which slide.
    NoSlip,
}

/// Shapes of walls.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// A half space.
    Plane(Plane<D>),
}

/// A wall.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<const D: usize> {
    /// Its name in messages.
    pub name: String,
    /// Its shape.
    pub shape: Shape<D>,
    /// Whether the fluid sticks.
    pub grip: Grip,
}

impl<const D: usize> Wall<D> {
    /// How the wall stands to a point at a time (s).
    pub fn touch(&self, x: &Vector<D>, _time: f64) -> Touch<D> {
        match &self.shape {
            Shape::Plane(plane) => plane.touch(x),
        }
    }
}
