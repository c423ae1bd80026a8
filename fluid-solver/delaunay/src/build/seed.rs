//! The first simplex and the ghosts around it.

use super::mesh::{Cell, Face, GHOST, Mark, Mesh};
use crate::predicate::{circumsphere, collinear, orientation};

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Brings the first points that span a simplex to the front and makes the simplex.
    ///
    /// Returns whether there is one: points on one plane (in 2D: line) span none.
    pub fn plant(&mut self) -> bool {
        for found in 2..N {
            let spans = |point: &usize| self.spans(found, *point as u32);
            let Some(point) = (found + 1..self.points.len()).find(spans) else {
                return false;
            };
            self.points.swap(found + 1, point);
            self.ranks.swap(found + 1, point);
            self.names.swap(found + 1, point);
        }
        let mut corners: [u32; N] = std::array::from_fn(|k| k as u32 + 1);
        if orientation(corners.map(|corner| self.point(corner))) < 0.0 {
            corners.swap(0, 1);
        }
        self.enclose(corners);
        true
    }

    /// Whether a point lies off the line or plane of the first `found` points.
    fn spans(&self, found: usize, point: u32) -> bool {
        if found < D {
            return !collinear([self.point(1), self.point(2), self.point(point)]);
        }
        let corner = |k: usize| if k < D { k as u32 + 1 } else { point };
        orientation(std::array::from_fn::<_, N, _>(|k| self.point(corner(k)))) != 0.0
    }

    /// Makes a cell and the ghosts behind its faces.
    fn enclose(&mut self, corners: [u32; N]) {
        let cell = |corners, sphere| Cell { corners, neighbours: [Face::default(); N], sphere };
        let sphere = circumsphere(corners.map(|corner| self.point(corner)));
        self.cells.clear();
        self.cells.push(cell(corners, sphere));
        for k in 0..N {
            let mut ghost = corners;
            ghost[k] = GHOST;
            // Seen from behind, the face turns the other way round.
            ghost.swap((k + 1) % N, (k + 2) % N);
            self.cells.push(cell(ghost, [f64::NAN; N]));
        }
        self.marks.clear();
        self.marks.resize(N + 1, Mark::Open);
        // Where the ghost behind face k has corner j.
        let place = |k: usize, j: usize| match (j + N - k) % N {
            1 => (k + 2) % N,
            2 => (k + 1) % N,
            _ => j,
        };
        let ghost = |k: usize, opposite: usize| Face::new(k as u32 + 1, opposite);
        for k in 0..N {
            self.join(Face::new(0, k), ghost(k, k));
            for j in 0..k {
                self.join(ghost(k, place(k, j)), ghost(j, place(j, k)));
            }
        }
    }
}
