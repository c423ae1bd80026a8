//! Whether a hull that is convex across each of its ridges is the hull, once.

use super::mesh::{GHOST, Mark, Mesh};
use crate::predicate::orientation;

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Whether the faces that ghosts stand behind, convex across each ridge, bound one convex set: some point lies beneath
    /// all of them, and a ray from it meets one only. Rounding and ties are answered by no.
    ///
    /// Source: Mehlhorn, Näher, Seel, Seidel, Schilz, Schirra & Uhrig, *Checking geometric programs or verification of
    /// geometric structures*, Comput. Geom. 12 (1999) 85.
    pub fn hull_is_covered_once(&self) -> bool {
        let ghosts = || {
            let open = (0..self.cells.len()).filter(|cell| self.marks[*cell] != Mark::Free);
            open.map(|cell| self.cells[cell].corners).filter(|corners| corners.contains(&GHOST))
        };
        let (Some(cell), Some(face)) = (self.any_cell(), ghosts().next()) else { return false };
        let (inside, ahead) = (self.middle(&self.cell(cell).corners), self.middle(&face));
        let mut met = 0;
        for corners in ghosts() {
            let cone = corners.map(|corner| if corner == GHOST { &inside } else { self.point(corner) });
            if orientation(cone) >= 0.0 {
                return false;
            }
            let within = |k: usize| {
                let mut turned = cone;
                turned[k] = &ahead;
                orientation(turned) <= 0.0
            };
            met += usize::from((0..N).filter(|k| corners[*k] != GHOST).all(within));
        }
        met == 1
    }

    /// The mean of some points, the ghost apart.
    fn middle(&self, corners: &[u32; N]) -> [f64; D] {
        let real = || corners.iter().filter(|corner| **corner != GHOST).map(|corner| self.point(*corner));
        let count = real().count() as f64;
        std::array::from_fn(|k| real().map(|place| place[k]).sum::<f64>() / count)
    }
}
