//! Segments (2D) or triangles (3D) that meet at flat or convex edges only: a point touches such a surface once.

use super::Touch;
use crate::element::closest_point::on_facet;
use crate::element::simplex::{Vector, difference, distance, dot};
use crate::mesh::bins::{Bins, bounds};

/// What is at a side of a facet: a vertex of a segment, an edge of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Another facet of the patch.
    Joined,
    /// A facet of another patch of the same surface, across a concave edge.
    Concave,
    /// Nothing: the surface ends.
    Rim,
}

/// A facet; the fluid is on the left of a segment, and on the side from which a triangle's vertices go round anticlockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facet<const D: usize> {
    pub vertices: [Vector<D>; D],
    /// Unit normal towards the fluid.
    pub normal: Vector<D>,
    /// What is at the side opposite to each vertex.
    pub sides: [Side; D],
}

/// Facets without a concave edge between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch<const D: usize> {
    facets: Vec<Facet<D>>,
    /// Whether the surface that it is a part of ends somewhere.
    pub(super) is_open: bool,
    bins: Bins<D>,
    /// Size of the surface, for round-off (m).
    extent: f64,
}

/// Through a corner a point is pushed at most this many times farther than it is behind a facet of it.
const BEYOND: f64 = 3.0;

/// And at most this far beyond the edge, in parts of the extent: what is deep behind a patch but far from it is elsewhere.
const CORNER: f64 = 0.15;

/// Of the bins of a flat surface, in parts of its extent.
const THICKNESS: f64 = 1e-3;

/// Distances that differ by less, in parts of the extent, are one.
const ONE: f64 = 1e-10;

impl<const D: usize> Patch<D> {
    pub(super) fn new(facets: Vec<Facet<D>>, is_open: bool) -> Self {
        let around = bounds(facets.iter().flat_map(|facet| &facet.vertices));
        let extent = distance(&around.0, &around.1);
        // A flat surface has bins of some thickness too.
        let around = (around.0.map(|c| c - THICKNESS * extent), around.1.map(|c| c + THICKNESS * extent));
        let bins = Bins::new(around, facets.len(), facets.len(), |k| bounds(&facets[k].vertices));
        Self { facets, is_open, bins, extent }
    }

    /// Where the surface ends: the vertices of each side of a facet that has nothing beyond it.
    pub fn ends(&self) -> impl Iterator<Item = Vec<Vector<D>>> {
        self.facets.iter().flat_map(|facet| {
            let ends = facet.sides.iter().enumerate().filter(|(_, side)| **side == Side::Rim);
            ends.map(move |(k, _)| (1..D).map(|step| facet.vertices[(k + step) % D]).collect())
        })
    }

    /// How it stands to a point x: with the nearest point c of the facet whose gap n·(x − c) is the largest of those equally
    /// near, which at a convex edge is the one that faces x.
    ///
    /// Off the end of the surface the gap is |x − c|. At a concave edge the facet goes on behind the other patch, where x is
    /// not much farther beyond the edge than behind the facet: what was pushed out through the corner is behind both.
    pub(super) fn touch(&self, x: &Vector<D>) -> Touch<D> {
        let off = |facet: &Facet<D>| difference(x, &on_facet(&facet.vertices, x));
        let squared = |k: u32| {
            let d = off(&self.facets[k as usize]);
            dot(&d, &d)
        };
        let Some(nearest) = self.bins.nearest(x, squared) else { unreachable!("a patch has a facet") };
        let least = squared(nearest).sqrt();
        let mut chosen = &self.facets[nearest as usize];
        let mut place = on_facet(&chosen.vertices, x);
        let mut gap = dot(&chosen.normal, &difference(x, &place));
        if gap.abs() >= least - ONE * self.extent {
            return Touch { gap, normal: chosen.normal, velocity: [0.0; D] };
        }
        let around = |shift: f64| place.map(|c| c + shift * ONE * self.extent);
        let (low, high) = (self.bins.index(&around(-1.0)), self.bins.index(&around(1.0)));
        crate::mesh::bins::for_each_index(&low, &high, |index| {
            for facet in self.bins.bin(index).iter().map(|&k| &self.facets[k as usize]) {
                let d = off(facet);
                let found = dot(&facet.normal, &d);
                if dot(&d, &d).sqrt() <= least + ONE * self.extent && found > gap {
                    (chosen, gap) = (facet, found);
                }
            }
        });
        place = on_facet(&chosen.vertices, x);
        let ends = match self.end_at(chosen, &place) {
            Side::Joined => false,
            Side::Concave => least > BEYOND * -gap || least > CORNER * self.extent,
            Side::Rim => true,
        };
        if ends && least > 0.0 {
            let away = difference(x, &place).map(|c| c / least);
            return Touch { gap: least, normal: away, velocity: [0.0; D] };
        }
        Touch { gap, normal: chosen.normal, velocity: [0.0; D] }
    }

    /// Whether what is nearest to x is an edge where the surface goes on as another patch.
    pub(super) fn is_nearest_at_corner(&self, x: &Vector<D>) -> bool {
        let place = |k: u32| on_facet(&self.facets[k as usize].vertices, x);
        let squared = |k: u32| distance(x, &place(k)).powi(2);
        let nearest = self.bins.nearest(x, squared);
        nearest.is_some_and(|k| self.end_at(&self.facets[k as usize], &place(k)) == Side::Concave)
    }

    /// What is at the place of a facet's side.
    fn end_at(&self, facet: &Facet<D>, place: &Vector<D>) -> Side {
        let mut met = Side::Joined;
        for (k, side) in facet.sides.iter().enumerate() {
            if distance(&on_side(&facet.vertices, k, place), place) <= ONE * self.extent {
                met = match (met, side) {
                    (Side::Rim, _) | (_, Side::Rim) => Side::Rim,
                    (Side::Concave, _) | (_, Side::Concave) => Side::Concave,
                    _ => Side::Joined,
                };
            }
        }
        met
    }
}

/// The point nearest to x of the side opposite to vertex k.
fn on_side<const D: usize>(vertices: &[Vector<D>; D], k: usize, x: &Vector<D>) -> Vector<D> {
    let a = vertices[(k + 1) % D];
    if D == 2 {
        return a;
    }
    let along = difference(&vertices[(k + 2) % D], &a);
    let share = (dot(&difference(x, &a), &along) / dot(&along, &along)).clamp(0.0, 1.0);
    std::array::from_fn(|i| a[i] + share * along[i])
}
