//! Walls at rest: planes, and surfaces of facets (triangles in 3D, segments in 2D).

mod bins;
mod facet;
mod plane;
pub mod stl;

use crate::vector::Vector;
use bins::Bins;

pub use facet::Facet;
pub use plane::Plane;

/// A wall about to be built.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<const D: usize> {
    /// Name in messages and in the ledger.
    pub name: String,
    /// Index of its material.
    pub material: u32,
    /// Its surfaces.
    pub shapes: Vec<Shape<D>>,
}

impl<const D: usize> Wall<D> {
    /// A wall that is one plane through `point`, its `normal` towards the grains.
    pub fn plane(name: &str, material: u32, point: [f64; D], normal: [f64; D]) -> Self {
        let plane = Plane { point: point.into(), normal: Vector::from(normal).normalize() };
        Self { name: name.into(), material, shapes: vec![Shape::Plane(plane)] }
    }

    /// A wall of facets.
    pub fn facets(name: &str, material: u32, facets: Vec<Facet<D>>) -> Self {
        Self { name: name.into(), material, shapes: facets.into_iter().map(Shape::Facet).collect() }
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

/// All walls of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Walls<const D: usize> {
    /// Names, by wall.
    pub names: Vec<String>,
    /// Materials, by wall.
    pub materials: Vec<u32>,
    /// All pieces: the planes first.
    pub surfaces: Vec<Surface<D>>,
    planes: usize,
    bins: Option<Bins<D>>,
}

impl<const D: usize> Walls<D> {
    /// These walls.
    pub fn new(walls: Vec<Wall<D>>) -> Self {
        let pieces = |planes: bool| {
            walls.iter().enumerate().flat_map(move |(index, wall)| {
                let chosen =
                    wall.shapes.iter().filter(move |shape| matches!(shape, Shape::Plane(_)) == planes);
                chosen.map(move |&shape| Surface { wall: index as u32, shape })
            })
        };
        let planes = pieces(true).count();
        let surfaces: Vec<_> = pieces(true).chain(pieces(false)).collect();
        let facets: Vec<_> = surfaces
            .iter()
            .filter_map(|surface| match surface.shape {
                Shape::Facet(facet) => Some(facet),
                Shape::Plane(_) => None,
            })
            .collect();
        Self {
            names: walls.iter().map(|wall| wall.name.clone()).collect(),
            materials: walls.iter().map(|wall| wall.material).collect(),
            surfaces,
            planes,
            bins: Bins::new(&facets),
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

    /// Appends the planes nearer than `reach`, as indices of surfaces, ascending.
    pub fn planes_near(&self, centre: &Vector<D>, reach: f64, found: &mut Vec<u32>) {
        let near = |index: &u32| self.surfaces[*index as usize].nearest(centre).distance < reach;
        found.extend((0..self.planes as u32).filter(near));
    }

    /// Appends the facets nearer than `reach`, as indices of surfaces, ascending.
    pub fn facets_near(&self, centre: &Vector<D>, reach: f64, found: &mut Vec<u32>) {
        let Some(bins) = &self.bins else { return };
        let begin = found.len();
        bins.visit(centre, reach, |facet| found.push((self.planes + facet as usize) as u32));
        found[begin..].sort_unstable();
        let mut last = None;
        let mut kept = begin;
        for k in begin..found.len() {
            let index = found[k];
            if last != Some(index) && self.surfaces[index as usize].nearest(centre).distance < reach {
                found[kept] = index;
                kept += 1;
            }
            last = Some(index);
        }
        found.truncate(kept);
    }

    /// The smallest box around all facets, if there are any.
    pub fn facet_bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        self.bins.as_ref().map(Bins::bounds)
    }
}
