//! Walls, at rest or in prescribed motion, made of simple surfaces and of facets (triangles in 3D, segments in 2D).

mod bins;
mod impulse;
mod poses;
mod servo;
mod shape;

use crate::vector::Vector;
pub use bins::Bins;
pub use impulse::{Received, WallImpulse};
pub use poses::Poses;
pub use servo::{Servo, Slide, drift};
pub use shape::{Cylinder, Disc, Facet, Nearest, Piece, Plane, Shape, Side, Sphere, Tube};
pub use surface::motion::{Motion, Pose, Table, TableRow};

/// A wall about to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<const D: usize> {
    /// Name in messages and in the ledger.
    pub name: String,
    /// Index of its material.
    pub material: u32,
    /// Its surfaces, at t = 0.
    pub shapes: Vec<Shape<D>>,
    /// Its motion, if it moves as prescribed.
    pub motion: Option<Motion<D>>,
    /// What pushes it, if it slides under a force.
    pub servo: Option<Servo<D>>,
    /// The point about which its torque is told \[m\].
    pub torque_about: Vector<D>,
}

impl<const D: usize> Wall<D> {
    /// A wall at rest, its torque told about the origin.
    pub fn new(name: &str, material: u32, shapes: Vec<Shape<D>>) -> Self {
        Self { name: name.into(), material, shapes, motion: None, servo: None, torque_about: Vector::zeros() }
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

    /// The wall under this force.
    pub fn pushed(self, servo: Servo<D>) -> Self {
        Self { servo: Some(servo), ..self }
    }
}

/// A piece of a wall, and the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<const D: usize> {
    /// Index of the wall.
    pub wall: u32,
    /// The piece.
    pub shape: Shape<D>,
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
    /// What pushes those that slide, by wall.
    pub servos: Vec<Option<Servo<D>>>,
    /// Points about which torques are told, by wall \[m\].
    pub torque_about: Vec<Vector<D>>,
    /// All pieces at t = 0: first those that enclose, then other simple ones, then the facets wall by wall.
    pub surfaces: Vec<Surface<D>>,
    /// How many of them enclose.
    enclosing: usize,
    /// How many of them are no facets.
    simple: usize,
    facets: Vec<Facets<D>>,
}

impl<const D: usize> Walls<D> {
    /// These walls.
    pub fn new(walls: Vec<Wall<D>>) -> Self {
        let all = || {
            let walls = walls.iter().enumerate();
            walls.flat_map(|(wall, Wall { shapes, .. })| {
                shapes.iter().map(move |&shape| Surface { wall: wall as u32, shape })
            })
        };
        let is_facet = |surface: &Surface<D>| matches!(surface.shape, Shape::Facet(_));
        let mut surfaces: Vec<_> = all().filter(|surface| surface.shape.encloses()).collect();
        let enclosing = surfaces.len();
        surfaces.extend(all().filter(|surface| !surface.shape.encloses() && !is_facet(surface)));
        let simple = surfaces.len();
        surfaces.extend(all().filter(is_facet));
        let mut facets = Vec::new();
        let mut first = simple as u32;
        for of_wall in surfaces[simple..].chunk_by(|a, b| a.wall == b.wall) {
            let boxes: Vec<_> = of_wall.iter().filter_map(|surface| surface.shape.bounds()).collect();
            facets.extend(Bins::new(&boxes).map(|bins| Facets { wall: of_wall[0].wall, first, bins }));
            first += of_wall.len() as u32;
        }
        Self {
            names: walls.iter().map(|wall| wall.name.clone()).collect(),
            materials: walls.iter().map(|wall| wall.material).collect(),
            motions: walls.iter().map(|wall| wall.motion.clone()).collect(),
            servos: walls.iter().map(|wall| wall.servo).collect(),
            torque_about: walls.iter().map(|wall| wall.torque_about).collect(),
            surfaces,
            enclosing,
            simple,
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
            None => surface.shape.nearest(centre),
            Some(pose) => {
                let Nearest { distance, normal } = surface.shape.nearest(&pose.unmoved(centre));
                Nearest { distance, normal: pose.turned(&normal) }
            }
        }
    }

    /// Appends the enclosing surfaces (planes, insides of cylinders and spheres) nearer than `reach`, and those that tilt
    /// whatever their distance, as indices of surfaces, ascending.
    pub fn planes_near(&self, centre: &Vector<D>, reach: f64, poses: &Poses<D>, found: &mut Vec<u32>) {
        self.simple_near(0..self.enclosing, centre, reach, poses, found);
    }

    /// Appends the other surfaces, of which images across periodic boundaries are felt too, nearer than `reach`, as indices
    /// of surfaces, ascending.
    pub fn facets_near(&self, centre: &Vector<D>, reach: f64, poses: &Poses<D>, found: &mut Vec<u32>) {
        self.simple_near(self.enclosing..self.simple, centre, reach, poses, found);
        for Facets { wall, first, bins } in &self.facets {
            let begin = found.len();
            let seen = poses.of(*wall).map_or(*centre, |pose| pose.unmoved(centre));
            bins.visit(&seen, reach, |facet| found.push(first + facet));
            found[begin..].sort_unstable();
            let mut last = None;
            let mut kept = begin;
            for k in begin..found.len() {
                let index = found[k];
                let near = || self.surfaces[index as usize].shape.nearest(&seen).distance < reach;
                if last != Some(index) && near() {
                    found[kept] = index;
                    kept += 1;
                }
                last = Some(index);
            }
            found.truncate(kept);
        }
    }

    fn simple_near(
        &self,
        range: std::ops::Range<usize>,
        centre: &Vector<D>,
        reach: f64,
        poses: &Poses<D>,
        found: &mut Vec<u32>,
    ) {
        let near =
            |&index: &u32| self.tilts(index as usize) || self.nearest(index, centre, poses).distance < reach;
        found.extend((range.start as u32..range.end as u32).filter(near));
    }

    /// The smallest box around all surfaces at t = 0 that have ends, if there are any.
    pub fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        let of_simple = self.surfaces[..self.simple].iter().filter_map(|surface| surface.shape.bounds());
        let of_facets = self.facets.iter().map(|facets| facets.bins.bounds());
        of_simple.chain(of_facets).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
    }
}
