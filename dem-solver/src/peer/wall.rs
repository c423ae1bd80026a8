//! Walls in the terms that peers share.

use case_io::document::Case;
use case_io::error::CaseError;

use crate::scene::Scene;
use crate::vector::{Spin, Vector};
use crate::wall::{Facet, Motion, Plane, Shape};

/// A wall.
#[derive(Clone, Debug, PartialEq)]
pub struct PeerWall {
    /// Name, as in `series/walls.csv`.
    pub name: String,
    /// Index of its material.
    pub material: u32,
    /// Its shape at t = 0.
    pub shape: WallShape,
    /// How it moves.
    pub course: Course,
}

/// The shape of a wall.
#[derive(Clone, Debug, PartialEq)]
pub enum WallShape {
    /// A plane.
    Plane(Plane<3>),
    /// Triangles.
    Triangles(Vec<Facet<3>>),
}

/// How a wall moves: what every peer has a command for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Not at all.
    Rest,
    /// At a velocity \[m/s\].
    Translation(Vector<3>),
    /// About an axis through a point \[m\] at an angular velocity \[rad/s\].
    Rotation(Vector<3>, Spin),
    /// By an amplitude with its direction \[m\], times the sine of so many turns in a second \[1/s\].
    Oscillation(Vector<3>, f64),
}

/// Two triangles in place of a plane, for a peer that has planes across an axis only: a square around the box of these
/// corners, four times as wide.
pub fn square(plane: &Plane<3>, (lower, upper): (Vector<3>, Vector<3>)) -> Vec<Facet<3>> {
    let (middle, half) = (0.5 * (lower + upper), 2.0 * (upper - lower).norm());
    let foot = middle - plane.normal * (middle - plane.point).dot(&plane.normal);
    let aside = Vector::ith(plane.normal.iamin(), 1.0);
    let across = plane.normal.cross(&aside).normalize() * half;
    let along = plane.normal.cross(&across);
    let corners = [-across - along, across - along, across + along, along - across].map(|side| foot + side);
    [[0, 1, 2], [0, 2, 3]].map(|triangle| Facet { vertices: triangle.map(|corner| corners[corner]) }).into()
}

impl PeerWall {
    /// A facet where the wall has it at a time \[s\].
    pub fn moved(&self, facet: &Facet<3>, time: f64) -> Facet<3> {
        let motion = match self.course {
            Course::Rest => Motion::none(),
            Course::Translation(velocity) => Motion { translation: velocity, ..Motion::none() },
            Course::Rotation(point, angular_velocity) => Motion { point, angular_velocity, ..Motion::none() },
            Course::Oscillation(amplitude, frequency) => Motion { amplitude, frequency, ..Motion::none() },
        };
        let pose = motion.pose(time);
        Facet { vertices: facet.vertices.map(|vertex| pose.moved(&vertex)) }
    }
}

/// The walls of a scene whose case has told-of shapes only.
///
/// # Errors
/// Motions that are added up.
pub fn walls(case: &Case, scene: &Scene<3>) -> Result<Vec<PeerWall>, CaseError> {
    let walls = scene.walls.names.iter().enumerate().map(|(index, name)| {
        let surfaces = scene.walls.surfaces.iter().filter(|surface| surface.wall as usize == index);
        let (mut planes, mut facets) = (vec![], vec![]);
        for surface in surfaces {
            match surface.shape {
                Shape::Plane(plane) => planes.push(plane),
                Shape::Facet(facet) => facets.push(facet),
                // No peer is told of others.
                _ => {}
            }
        }
        let shape = planes.pop().map_or(WallShape::Triangles(facets), WallShape::Plane);
        let course = scene.walls.motions[index].as_ref().map_or(Some(Course::Rest), course);
        let course = course.ok_or_else(|| {
            let allowed = "one of translation, rotation, oscillation";
            case.error(&format!("wall[{index}].motion"), "a sum of motions", allowed, "leave one of them")
        })?;
        Ok(PeerWall { name: name.clone(), material: scene.walls.materials[index], shape, course })
    });
    walls.collect()
}

/// The one kind of motion; nothing where kinds are added.
fn course(motion: &Motion<3>) -> Option<Course> {
    let translates = motion.translation != Spin::zeros();
    let turns = motion.angular_velocity != Spin::zeros();
    let oscillates = motion.amplitude != Spin::zeros();
    match (translates, turns, oscillates) {
        (false, false, false) => Some(Course::Rest),
        (true, false, false) => Some(Course::Translation(motion.translation)),
        (false, true, false) => Some(Course::Rotation(motion.point, motion.angular_velocity)),
        (false, false, true) => Some(Course::Oscillation(motion.amplitude, motion.frequency)),
        _ => None,
    }
}
