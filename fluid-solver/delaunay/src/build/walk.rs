//! Finding a cell that a point conflicts with.

use super::mesh::{Cell, GHOST, Mesh};
use crate::predicate::{conflict, in_circumsphere, orientation, rough_side};

/// Steps after which a walk by rounded signs is taken to go round in circles.
const LONGEST_ROUGH_WALK: usize = 10_000;

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// A cell that a point conflicts with, near to the cell `from`, which is no ghost.
    ///
    /// The walk goes by rounded signs: where they mislead it, the cell at its end is in no conflict, and it goes on by
    /// exact ones.
    pub fn find(&self, from: u32, point: u32) -> u32 {
        let place = self.point(point);
        let rough = |cell: &Cell<N>, at: usize| rough_side(self.places(cell), at, place) < 0.0;
        let cell = self.walk(from, LONGEST_ROUGH_WALK, rough);
        if self.conflicts(cell, point) {
            return cell;
        }
        self.find_around(self.behind_ghost(cell).unwrap_or(cell), place)
    }

    /// The cell that a place lies in or on, or the ghost behind a face of the hull that it lies beyond; `from` is no ghost.
    pub fn find_around(&self, from: u32, place: &[f64; D]) -> u32 {
        let exact = |cell: &Cell<N>, at: usize| {
            let mut corners = self.places(cell);
            corners[at] = place;
            orientation(corners) < 0.0
        };
        self.walk(from, usize::MAX, exact)
    }

    /// Steps across faces that the point lies beyond, until there is none or the cell is a ghost.
    #[inline(always)]
    fn walk(&self, mut cell: u32, longest: usize, beyond: impl Fn(&Cell<N>, usize) -> bool) -> u32 {
        let mut last = u32::MAX;
        'step: for step in 0..longest {
            let this = self.cell(cell);
            if this.corners.contains(&GHOST) {
                return cell;
            }
            // The face to begin with turns, lest the walk drift to one side.
            for k in 0..N {
                let at = (step + k) % N;
                let next = this.neighbours[at].cell();
                if next != last && beyond(this, at) {
                    last = cell;
                    cell = next;
                    continue 'step;
                }
            }
            return cell;
        }
        cell
    }

    /// Whether a point conflicts with a cell: lies inside its circumsphere; of a ghost, lies beyond the face that it stands
    /// behind, or on the plane of that face and in conflict with the cell before it.
    #[inline(always)]
    pub fn conflicts(&self, cell: u32, point: u32) -> bool {
        self.conflicts_from(self.cell(cell).corners[D], cell, point)
    }

    /// The same if the last corner of the cell is at hand.
    #[inline(always)]
    pub fn conflicts_from(&self, origin: u32, cell: u32, point: u32) -> bool {
        let sign = in_circumsphere(&self.cell(cell).sphere, self.point(origin), self.point(point));
        if sign != 0.0 { sign > 0.0 } else { self.conflicts_exactly(cell, point) }
    }

    #[cold]
    #[inline(never)]
    fn conflicts_exactly(&self, cell: u32, point: u32) -> bool {
        let place = self.point(point);
        let this = self.cell(cell);
        let Some(before) = self.behind_ghost(cell) else {
            let ranks = this.corners.map(|corner| self.ranks[corner as usize]);
            return conflict(self.places(this), place, ranks, self.ranks[point as usize]);
        };
        let side = orientation(this.corners.map(|k| if k == GHOST { place } else { self.point(k) }));
        if side != 0.0 { side > 0.0 } else { self.conflicts_exactly(before, point) }
    }

    /// The cell on the other side of the face that a ghost stands behind; none if the cell is no ghost.
    fn behind_ghost(&self, cell: u32) -> Option<u32> {
        let this = self.cell(cell);
        let at = this.corners.iter().position(|corner| *corner == GHOST)?;
        Some(this.neighbours[at].cell())
    }
}
