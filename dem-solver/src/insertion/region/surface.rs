//! The inside of a closed surface of triangles.

use super::Space;
use crate::domain::Domain;
use crate::insertion::Random;
use crate::vector::{Vector, embed, restrict};
use crate::wall::{Bins, Facet, Piece};

/// A region is too narrow for a grain when so many places in a row have no room.
const MOST_MISSES: u32 = 100_000;

/// The inside of a closed surface of triangles that all face outwards (3D).
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceRegion<const D: usize> {
    facets: Vec<Facet<3>>,
    bins: Bins<3>,
}

impl<const D: usize> SurfaceRegion<D> {
    /// The inside of this surface, as [`crate::wall::triangles::read_closed`] gives it; nothing if it is empty.
    pub fn new(facets: Vec<Facet<3>>) -> Option<Self> {
        let boxes: Vec<_> = facets.iter().filter_map(Piece::bounds).collect();
        Some(Self { bins: Bins::new(&boxes)?, facets })
    }

    /// Whether a point is inside: of three rays from it, one along each axis, two or three cut the surface an odd number
    /// of times. A ray that slips between two triangles whose vertices are a rounding apart is outvoted.
    fn holds_point(&self, point: &Vector<3>) -> bool {
        (0..3).filter(|&axis| self.crossings(point, axis) % 2 == 1).count() >= 2
    }

    /// How often the ray from a point along an axis cuts the surface.
    fn crossings(&self, point: &Vector<3>, axis: usize) -> usize {
        let mut end = *point;
        end[axis] = self.bins.bounds().1[axis];
        let mut near = Vec::new();
        self.bins.visit_box(point, &end, |facet| near.push(facet));
        near.sort_unstable();
        near.dedup();
        near.into_iter().filter(|&facet| cuts(&self.facets[facet as usize], point, axis)).count()
    }

    fn has_room(&self, centre: &Vector<3>, radius: f64) -> bool {
        let mut has_room = true;
        self.bins.visit(centre, radius, |facet| {
            has_room &= self.facets[facet as usize].nearest(centre).distance >= radius;
        });
        has_room
    }
}

impl<const D: usize> Space<D> for SurfaceRegion<D> {
    fn bounds(&self) -> (Vector<D>, Vector<D>) {
        let (lower, upper) = self.bins.bounds();
        (restrict(&lower), restrict(&upper))
    }

    /// Σ a·(b × c)/6 over the triangles, by Gauss' theorem.
    fn volume(&self) -> f64 {
        // From a corner: far from the origin digits would cancel.
        let from = self.bins.bounds().0;
        let sixfold = |facet: &Facet<3>| {
            let [a, b, c] = facet.vertices.map(|vertex| vertex - from);
            a.dot(&b.cross(&c))
        };
        (self.facets.iter().map(sixfold).sum::<f64>() / 6.0).abs()
    }

    fn holds(&self, point: &Vector<D>) -> bool {
        self.holds_point(&embed(point))
    }

    fn place(&self, _: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>> {
        let (lower, upper) = self.bins.bounds();
        (0..MOST_MISSES).find_map(|_| {
            let centre = Vector::from_fn(|axis, _| random.between(lower[axis], upper[axis]));
            let fits = self.has_room(&centre, radius) && self.holds_point(&centre);
            fits.then(|| restrict(&centre))
        })
    }
}

/// Whether the ray from a point along an axis cuts a triangle, as seen along that axis: of an edge that two triangles share
/// one has the point to its left, whichever way rounding goes, so that a ray through the edge cuts one of them.
fn cuts(facet: &Facet<3>, point: &Vector<3>, axis: usize) -> bool {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let [a, b, c] = &facet.vertices;
    let inside =
        [[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| is_left_of(point, a, b, u, v)).count() % 2 == 1;
    let normal = (b - a).cross(&(c - a));
    // Along the ray the plane is (a - p)·n/n_axis away.
    inside && (a - point).dot(&normal) * normal[axis] > 0.0
}

/// Whether the edge, which holds its lower end and not its upper one, passes the point on the side of larger u.
fn is_left_of(point: &Vector<3>, a: &Vector<3>, b: &Vector<3>, u: usize, v: usize) -> bool {
    // The same bits for both directions of the edge.
    let (low, high) = if a[v] < b[v] { (a, b) } else { (b, a) };
    let spans = low[v] <= point[v] && point[v] < high[v];
    spans && (high[u] - low[u]) * (point[v] - low[v]) > (point[u] - low[u]) * (high[v] - low[v])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A ring of radius 2 about z, of a round section of radius 0.5, in n by n pairs of triangles.
    fn ring(n: usize) -> SurfaceRegion<3> {
        let turn = |k: usize| 2.0 * PI * (k % n) as f64 / n as f64;
        let at = |i: usize, j: usize| {
            let from_axis = 2.0 + 0.5 * turn(j).cos();
            [from_axis * turn(i).cos(), from_axis * turn(i).sin(), 0.5 * turn(j).sin()]
        };
        let pairs = (0..n * n).flat_map(|k| {
            let (i, j) = (k / n, k % n);
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [Facet::new([a, b, c]), Facet::new([a, c, d])]
        });
        SurfaceRegion::new(pairs.collect()).unwrap()
    }

    #[test]
    fn a_ring_has_the_volume_of_pappus_and_holds_what_is_in_it() {
        let ring = ring(60);
        let volume = 2.0 * PI * 2.0 * PI * 0.25;
        assert!((ring.volume() / volume - 1.0).abs() < 0.01, "{}", ring.volume());
        let mut random = Random::new(3);
        for _ in 0..20_000 {
            let p = Vector::from([(); 3].map(|()| random.between(-3.0, 3.0)));
            let from_core = (p.x.hypot(p.y) - 2.0).hypot(p.z);
            // Between the flat sides and the round ones either may be.
            if !(0.495..=0.5).contains(&from_core) {
                assert_eq!(ring.holds(&p), from_core < 0.495, "{p}");
            }
        }
    }

    #[test]
    fn rays_through_edges_and_corners_do_not_miscount() {
        // Each of these looks along axes straight at vertices and edges.
        let ring = ring(60);
        for p in [[2.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, -2.0, 0.0], [2.25, 0.0, 0.0]] {
            assert!(ring.holds(&Vector::from(p)), "{p:?}");
        }
        for p in [[0.0; 3], [3.0, 0.0, 0.0], [-3.0, 0.0, 0.0], [0.0, 0.0, 0.25], [0.0, -1.0, 0.0]] {
            assert!(!ring.holds(&Vector::from(p)), "{p:?}");
        }
    }

    #[test]
    fn places_have_room_and_what_is_too_wide_finds_none() {
        let (ring, mut random) = (ring(60), Random::new(4));
        for _ in 0..1000 {
            let p = ring.place(&Domain::unbounded(), 0.3, &mut random).unwrap();
            assert!((p.x.hypot(p.y) - 2.0).hypot(p.z) < 0.2);
        }
        assert!(ring.place(&Domain::unbounded(), 0.6, &mut random).is_none());
    }
}
