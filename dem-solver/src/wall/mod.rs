//! Walls, at rest or in prescribed motion: planes, and surfaces of facets (triangles in 3D, segments in 2D).

mod bins;
mod facet;
mod impulse;
mod motion;
mod plane;
mod poses;
pub mod stl;

use crate::vector::Vector;
use bins::Bins;

pub use facet::Facet;
pub use impulse::{Received, WallImpulse};
pub use motion::{Motion, Pose};
pub use plane::Plane;
pub use poses::Poses;

/// A wall about to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<const D: usize> {
    /// Name in messages and in the ledger.
    pub name: String,
    /// Index of its material.
    pub material: u32,
    /// Its surfaces, at t = 0.
    pub shapes: Vec<Shape<D>>,
    /// Its motion, if it moves.
    pub motion: Option<Motion<D>>,
    /// The point about which its torque is told \[m\].
    pub torque_about: Vector<D>,
}

impl<const D: usize> Wall<D> {
    /// A wall at rest, its torque told about the origin.
    pub fn new(name: &str, material: u32, shapes: Vec<Shape<D>>) -> Self {
        Self { name: name.into(), material, shapes, motion: None, torque_about: Vector::zeros() }
    }

    /// A wall that is one plane through `point`, its `normal` towards the grains.
    pub fn plane(name: &str, material: u32, point: [f64; D], normal: [f64; D]) -> Self {
        let plane = Plane { point: point.into(), normal: Vector::from(normal).normalize() };
        Self::new(name, material, vec![Shape::Plane(plane)])
    }

    /// A wall of facets.
    pub fn facets(name: &str, material: u32, facets: Vec<Facet<D>>) -> Self {
        Self::new(name, material, facets.into_iter().map(Shape::Facet).collect())
    }

    /// The wall in this motion.
    pub fn moving(self, motion: Motion<D>) -> Self {
        Self { motion: Some(motion), ..self }
    }
}

/// A piece of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// A half-space.
    Plane(Plane<D>),
    /// A triangle (2D: a segment).
    Facet(Facet<D>),
}

/// A piece of a wall, and the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<const D: usize> {
    /// Index of the wall.
    pub wall: u32,
    /// The piece.
    pub shape: Shape<D>,
}

/// The point of a surface that is nearest to a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const D: usize> {
    /// Distance \[m\]; negative behind a plane.
    pub distance: f64,
    /// Unit normal from the centre to the wall; zero if the centre lies in a facet.
    pub normal: Vector<D>,
}

impl<const D: usize> Surface<D> {
    /// The nearest point of the surface.
    #[inline]
    pub fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        match &self.shape {
            Shape::Plane(plane) => plane.nearest(centre),
            Shape::Facet(facet) => facet.nearest(centre),
        }
    }
}

/// The facets of one wall.
#[derive(Clone, Debug, PartialEq)]
struct Facets<const D: usize> {
    wall: u32,
    /// Index of the first one among the surfaces.
    first: u32,
    bins: Bins<D>,
}

/// All walls of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Walls<const D: usize> {
    /// Names, by wall.
    pub names: Vec<String>,
    /// Materials, by wall.
    pub materials: Vec<u32>,
    /// Motions, by wall.
    pub motions: Vec<Option<Motion<D>>>,
    /// Points about which torques are told, by wall \[m\].
    pub torque_about: Vec<Vector<D>>,
    /// All pieces at t = 0: the planes first, then the facets wall by wall.
    pub surfaces: Vec<Surface<D>>,
    planes: usize,
    facets: Vec<Facets<D>>,
}

impl<const D: usize> Walls<D> {
    /// These walls.
    pub fn new(walls: Vec<Wall<D>>) -> Self {
        let mut surfaces = Vec::new();
        for (index, wall) in walls.iter().enumerate() {
            let planes = wall.shapes.iter().filter(|shape| matches!(shape, Shape::Plane(_)));
            surfaces.extend(planes.map(|&shape| Surface { wall: index as u32, shape }));
        }
        let planes = surfaces.len();
        let mut facets = Vec::new();
        for (index, wall) in walls.iter().enumerate() {
            let of_wall: Vec<Facet<D>> = wall
                .shapes
                .iter()
                .filter_map(|shape| match shape {
                    Shape::Facet(facet) => Some(*facet),
                    Shape::Plane(_) => None,
                })
                .collect();
            let (wall, first) = (index as u32, surfaces.len() as u32);
            facets.extend(Bins::new(&of_wall).map(|bins| Facets { wall, first, bins }));
            surfaces.extend(of_wall.into_iter().map(|facet| Surface { wall, shape: Shape::Facet(facet) }));
        }
        Self {
            names: walls.iter().map(|wall| wall.name.clone()).collect(),
            materials: walls.iter().map(|wall| wall.material).collect(),
            motions: walls.iter().map(|wall| wall.motion).collect(),
            torque_about: walls.iter().map(|wall| wall.torque_about).collect(),
            surfaces,
            planes,
            facets,
        }
    }

    /// Number of walls.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// The nearest point of a surface, by its index, where the walls are in these poses.
    #[inline]
    pub fn nearest(&self, surface: u32, centre: &Vector<D>, poses: &Poses<D>) -> Nearest<D> {
        let surface = &self.surfaces[surface as usize];
        match poses.of(surface.wall) {
            None => surface.nearest(centre),
            Some(pose) => {
                let Nearest { distance, normal } = surface.nearest(&pose.unmoved(centre));
                Nearest { distance, normal: pose.turned(&normal) }
            }
        }
    }

    /// Appends the planes nearer than `reach`, and those that tilt whatever their distance, as indices of surfaces, ascending.
    pub fn planes_near(&self, centre: &Vector<D>, reach: f64, poses: &Poses<D>, found: &mut Vec<u32>) {
        let near =
            |&index: &u32| self.tilts(index as usize) || self.nearest(index, centre, poses).distance < reach;
        found.extend((0..self.planes as u32).filter(near));
    }

    /// Appends the facets nearer than `reach`, as indices of surfaces, ascending.
    pub fn facets_near(&self, centre: &Vector<D>, reach: f64, poses: &Poses<D>, found: &mut Vec<u32>) {
        for Facets { wall, first, bins } in &self.facets {
            let begin = found.len();
            let seen = poses.of(*wall).map_or(*centre, |pose| pose.unmoved(centre));
            bins.visit(&seen, reach, |facet| found.push(first + facet));
            found[begin..].sort_unstable();
            let mut last = None;
            let mut kept = begin;
            for k in begin..found.len() {
                let index = found[k];
                let near = || self.surfaces[index as usize].nearest(&seen).distance < reach;
                if last != Some(index) && near() {
                    found[kept] = index;
                    kept += 1;
                }
                last = Some(index);
            }
            found.truncate(kept);
        }
    }

    /// The smallest box around all facets at t = 0, if there are any.
    pub fn facet_bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        let boxes = self.facets.iter().map(|facets| facets.bins.bounds());
        boxes.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
    }
}
