//! Exact check of a triangulation.

use crate::predicate::{collinear, conflict, orientation};
use crate::{Error, HULL, Triangulation, points};
use std::collections::{BTreeMap, BTreeSet};

/// How often each property of a Delaunay triangulation is violated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// Corners out of range, faces that differ between the two neighbours or are shared by more.
    pub adjacency: usize,
    /// Cells that are flat or turned inside out.
    pub orientation: usize,
    /// Corners inside the perturbed circumsphere of a neighbour.
    pub delaunay: usize,
    /// Edges or faces where the hull is not convex, not closed, or covers itself.
    pub hull: usize,
    /// Points that are no corner and no twin, and twins that are none.
    pub points: usize,
}

impl Faults {
    /// Whether there are none.
    pub fn none(&self) -> bool {
        *self == Self::default()
    }
}

/// Checks with exact arithmetic that a triangulation is the Delaunay triangulation of points and ranks.
///
/// # Errors
/// Coordinates that are not finite, more than 10⁸ points.
pub fn check<const D: usize, const N: usize>(
    points: &[[f64; D]],
    rank: &[u32],
    triangulation: &Triangulation<N>,
) -> Result<Faults, Error> {
    if rank.len() != points.len() {
        return Err(Error::Ranks { points: points.len(), ranks: rank.len() });
    }
    let mut scaled = vec![];
    points::scale(points, &mut scaled)?;
    let check = Check { points: &scaled, rank, triangulation };
    let mut faults = Faults { points: check.points(), adjacency: check.adjacency(), ..Faults::default() };
    if faults.none() {
        faults.orientation = check.orientation();
        faults.delaunay = check.delaunay();
        faults.hull = check.hull();
    }
    Ok(faults)
}

struct Check<'a, const D: usize, const N: usize> {
    points: &'a [[f64; D]],
    rank: &'a [u32],
    triangulation: &'a Triangulation<N>,
}

impl<'a, const D: usize, const N: usize> Check<'a, D, N> {
    fn places(&self, cell: usize) -> [&'a [f64; D]; N] {
        self.triangulation.cells[cell].map(|corner| &self.points[corner as usize])
    }

    /// Every face: its cell and the corner opposite.
    fn faces(&self) -> impl Iterator<Item = (usize, usize)> + use<'a, D, N> {
        (0..self.triangulation.cells.len()).flat_map(|cell| (0..N).map(move |at| (cell, at)))
    }

    fn points(&self) -> usize {
        let mut uses = vec![0; self.points.len()];
        for corner in self.triangulation.cells.iter().flatten() {
            match uses.get_mut(*corner as usize) {
                Some(uses) => *uses = 1,
                None => return 1,
            }
        }
        let mut faults = 0;
        for [left, kept] in self.triangulation.twins.iter().map(|twin| twin.map(|point| point as usize)) {
            if left.max(kept) >= self.points.len() {
                return 1;
            }
            let order = (self.rank[kept], kept) < (self.rank[left], left);
            faults += usize::from(!order || self.points[left] != self.points[kept]);
            uses[left] += 1;
        }
        if self.triangulation.cells.is_empty() {
            return faults + usize::from(self.span());
        }
        faults + uses.iter().filter(|uses| **uses != 1).count()
    }

    /// Whether the points span a simplex.
    fn span(&self) -> bool {
        let Some((a, rest)) = self.points.split_first() else { return false };
        let Some(b) = rest.iter().find(|b| *b != a) else { return false };
        let Some(c) = rest.iter().find(|c| !collinear([a, b, c])) else { return false };
        let corners = [a, b, c];
        let off =
            |d: &[f64; D]| orientation::<D, N>(std::array::from_fn(|k| *corners.get(k).unwrap_or(&d))) != 0.0;
        D == 2 || rest.iter().any(off)
    }

    /// Corners of a face in rising order.
    fn face(&self, cell: usize, at: usize) -> [u32; N] {
        let mut face = self.triangulation.cells[cell];
        face[at] = HULL;
        face.sort_unstable();
        face
    }

    fn adjacency(&self) -> usize {
        let Triangulation { cells, neighbours, .. } = self.triangulation;
        if cells.len() != neighbours.len()
            || neighbours.iter().flatten().any(|n| *n != HULL && *n as usize >= cells.len())
        {
            return 1;
        }
        let back = |(cell, at): (usize, usize)| {
            let other = neighbours[cell][at];
            let same = |back: usize| {
                neighbours[other as usize][back] as usize == cell
                    && self.face(other as usize, back) == self.face(cell, at)
            };
            other == HULL || (0..N).filter(|back| same(*back)).count() == 1
        };
        let mut known = self.faces().map(|(cell, at)| self.face(cell, at)).collect::<Vec<_>>();
        known.sort_unstable();
        let hull = neighbours.iter().flatten().filter(|n| **n == HULL).count();
        let lone = known.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).count();
        self.faces().filter(|face| !back(*face)).count()
            + lone.abs_diff(hull)
            + known.chunk_by(|a, b| a == b).filter(|same| same.len() > 2).count()
    }

    fn orientation(&self) -> usize {
        (0..self.triangulation.cells.len()).filter(|cell| orientation(self.places(*cell)) <= 0.0).count()
    }

    /// Whether a point lies inside the perturbed circumsphere of a cell.
    fn conflict(&self, cell: usize, point: u32) -> bool {
        let ranks = self.triangulation.cells[cell].map(|corner| self.rank[corner as usize]);
        conflict(self.places(cell), &self.points[point as usize], ranks, self.rank[point as usize])
    }

    fn delaunay(&self) -> usize {
        let Triangulation { cells, neighbours, .. } = self.triangulation;
        let inside = |(cell, at): &(usize, usize)| {
            let other = neighbours[*cell][*at];
            if other == HULL || (other as usize) < *cell {
                return false;
            }
            let apex = cells[other as usize].into_iter().find(|corner| !cells[*cell].contains(corner));
            apex.is_none_or(|apex| self.conflict(*cell, apex))
        };
        self.faces().filter(inside).count()
    }

    /// A closed surface that is convex at every ridge, of one piece and of the genus of a sphere, is convex; in the plane it
    /// must also have a single leftmost point, lest it wind twice.
    fn hull(&self) -> usize {
        let Triangulation { cells, neighbours, .. } = self.triangulation;
        let hull = self.faces().filter(|(cell, at)| neighbours[*cell][*at] == HULL).collect::<Vec<_>>();
        let mut ridges: BTreeMap<Vec<u32>, Vec<(usize, usize)>> = BTreeMap::new();
        let mut lower: BTreeMap<u32, bool> = BTreeMap::new();
        for (cell, at) in &hull {
            let face = (0..N).filter(|k| k != at).map(|k| cells[*cell][k]).collect::<Vec<_>>();
            for a in &face {
                let mut ridge = face.iter().copied().filter(|b| b != a).collect::<Vec<_>>();
                let least = ridge.iter().all(|b| self.points[*a as usize] < self.points[*b as usize]);
                *lower.entry(*a).or_insert(true) &= least;
                ridge.sort_unstable();
                ridges.entry(ridge).or_default().push((*cell, *at));
            }
        }
        let mut faults = usize::from(!hull.is_empty() && lower.values().filter(|least| **least).count() != 1);
        let euler = if D == 2 { lower.len() == hull.len() } else { 2 * lower.len() == hull.len() + 4 };
        faults += usize::from(!hull.is_empty() && !euler);
        faults +=
            ridges.values().filter(|faces| faces.len() != 2 || !self.convex(faces[0], faces[1])).count();
        faults
    }

    /// Whether the hull is convex between two of its faces, or, if they lie on one plane, Delaunay.
    fn convex(&self, (cell, at): (usize, usize), (other, opposite): (usize, usize)) -> bool {
        let corners = self.triangulation.cells[cell];
        let far = (0..N).filter(|k| *k != opposite).map(|k| self.triangulation.cells[other][k]);
        let far = far.filter(|corner| !corners.iter().enumerate().any(|(k, mine)| k != at && mine == corner));
        far.collect::<BTreeSet<_>>().into_iter().all(|far| {
            let mut places = self.places(cell);
            places[at] = &self.points[far as usize];
            let side = orientation(places);
            side > 0.0 || (side == 0.0 && !self.conflict(cell, far))
        })
    }
}
