//! Walls are geometry: nodes are on them only where they are wet, and slide.

mod case;
mod contacts;
mod cut;
mod inflow;
mod patch;
mod plane;
mod round;

pub use case::{flat_boundary, refuse_gaps, walls};
pub use contacts::Contacts;
pub use cut::patches;
pub use inflow::{Inflow, inlet_of, inlet_velocity};
pub use patch::Patch;
pub use plane::Plane;
pub use round::Round;

use crate::element::simplex::{Vector, dot};
use surface::motion::Motion;

/// Planes whose normals have a cosine nearer to 1 than this are parallel.
const PARALLEL: f64 = 1e-9;

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
    /// v·n = 0, and the shear of a law of the wall.
    WallFunction,
}

/// Shapes of walls, as they are at t = 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// A half space.
    Plane(Plane<D>),
    /// A circle, a sphere, or a cylinder without ends.
    Round(Round<D>),
    /// Segments or triangles without a concave edge between them.
    Patch(Patch<D>),
}

/// A wall.
#[derive(Clone, Debug)]
pub struct Wall<const D: usize> {
    /// Its name in messages.
    pub name: String,
    /// Its shape.
    pub shape: Shape<D>,
    /// Whether the fluid sticks.
    pub grip: Grip,
    /// What it lets in: then it is an inlet, which nodes are in from the start, or never.
    pub inflow: Option<Inflow<D>>,
    /// How it moves.
    motion: Option<Motion<D>>,
}

impl<const D: usize> Wall<D> {
    /// A wall at rest.
    pub fn new(name: impl Into<String>, shape: Shape<D>, grip: Grip) -> Self {
        Self { name: name.into(), shape, grip, inflow: None, motion: None }
    }

    /// An inlet in a plane.
    pub fn inlet(name: impl Into<String>, plane: Plane<D>, inflow: Inflow<D>) -> Self {
        Self { inflow: Some(inflow), ..Self::new(name, Shape::Plane(plane), Grip::Slip) }
    }

    /// The wall, moving.
    pub fn moving(self, motion: Motion<D>) -> Self {
        Self { motion: Some(motion), ..self }
    }

    /// Whether it moves.
    pub fn moves(&self) -> bool {
        self.motion.is_some()
    }

    /// Whether it is a plane at rest, other than an inlet, that nothing in front of it passes on the way to a plane of the same
    /// direction `near` it (m) or behind.
    pub fn hides(&self, plane: &Plane<D>, near: f64) -> bool {
        let Shape::Plane(own) = &self.shape else { return false };
        let is_held = self.motion.is_none() && self.inflow.is_none();
        is_held && dot(&own.normal, &plane.normal) > 1.0 - PARALLEL && own.touch(&plane.point).gap <= near
    }

    /// Whether it is a surface of facets that a node at x, which goes this far (m) in a step, is too far from to cross: where it
    /// then is behind, it went round an edge.
    pub fn is_out_of_reach(&self, x: &Vector<D>, time: f64, way: f64, length: f64) -> bool {
        matches!(self.shape, Shape::Patch(_)) && {
            let touch = self.touch(x, time);
            touch.gap.abs() > way + length * dot(&touch.velocity, &touch.velocity).sqrt()
        }
    }

    /// Whether it is a surface that ends somewhere.
    pub fn is_open(&self) -> bool {
        matches!(self.shape, Shape::Patch(Patch { is_open: true, .. }))
    }

    /// Whether what of it is nearest to x is an edge where it goes on as another wall.
    pub fn is_nearest_at_corner(&self, x: &Vector<D>, time: f64) -> bool {
        let Shape::Patch(patch) = &self.shape else { return false };
        match &self.motion {
            Some(motion) => patch.is_nearest_at_corner(&motion.pose(time).unmoved(&(*x).into()).into()),
            None => patch.is_nearest_at_corner(x),
        }
    }

    /// How far a point is from being stopped at a time (m): infinitely by an inlet.
    pub fn gap(&self, x: &Vector<D>, time: f64) -> f64 {
        if self.inflow.is_some() { f64::INFINITY } else { self.touch(x, time).gap }
    }

    /// How the wall stands to a point at a time (s).
    pub fn touch(&self, x: &Vector<D>, time: f64) -> Touch<D> {
        let Some(motion) = &self.motion else { return self.shape.touch(x) };
        let pose = motion.pose(time);
        let at_start = self.shape.touch(&pose.unmoved(&(*x).into()).into());
        let normal: Vector<D> = pose.turned(&at_start.normal.into()).into();
        let place: Vector<D> = std::array::from_fn(|k| x[k] - at_start.gap * normal[k]);
        Touch { gap: at_start.gap, normal, velocity: pose.velocity_at(&place.into()).into() }
    }
}

impl<const D: usize> Shape<D> {
    fn touch(&self, x: &Vector<D>) -> Touch<D> {
        match self {
            Self::Plane(plane) => plane.touch(x),
            Self::Round(round) => round.touch(x),
            Self::Patch(patch) => patch.touch(x),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_moving_wall_takes_along_its_gap_and_its_velocity() {
        let floor = Plane { point: [0.0, 0.0], normal: [0.0, 1.0] };
        let lift = Motion::translation([0.5, 2.0]);
        let wall = Wall::new("lift", Shape::Plane(floor), Grip::Slip).moving(lift);
        let touch = wall.touch(&[3.0, 5.0], 1.5);
        assert_eq!((touch.gap, touch.normal, touch.velocity), (2.0, [0.0, 1.0], [0.5, 2.0]));
        let turn = Motion::rotation([0.0, 0.0], [0.0, 0.0, TAU / 4.0]);
        let wheel = Wall::new("wheel", Shape::Plane(floor), Grip::NoSlip).moving(turn);
        // A quarter turn later what was the floor is a wall on the right, and the fluid on its left.
        let touch = wheel.touch(&[-3.0, 2.0], 1.0);
        assert!((touch.gap - 3.0).abs() < 1e-12);
        assert!((touch.normal[0] + 1.0).abs() < 1e-12 && touch.normal[1].abs() < 1e-12);
        let expected = [-TAU / 4.0 * 2.0, 0.0];
        assert!((0..2).all(|k| (touch.velocity[k] - expected[k]).abs() < 1e-12), "{touch:?}");
    }
}
