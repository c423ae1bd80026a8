//! The triangulation of points that have moved, from the one before.

use super::mesh::{Cell, Face, GHOST, Mark, Mesh};
use super::region::Region;
use crate::predicate::{circumsphere, in_circumsphere, orientation};

/// What a violated face costs, in cells built anew.
const FACE: usize = 12;
/// The share of the cells that may be renewed wherever they are.
const SOME: usize = 8;
/// What a cell that is wrong costs, in cells built anew.
const CELL: usize = 2;

/// Finds what is wrong in a triangulation and triangulates it anew.
///
/// A closed mesh of positive cells is the Delaunay triangulation if no face has the corner opposite to it on one side in the
/// (perturbed) circumsphere of the other, the hull included, and if the hull is covered once.
#[derive(Default)]
pub struct Repair<const D: usize, const N: usize> {
    region: Region<D, N>,
    wrong: Vec<u32>,
    doubtful: Vec<Face>,
}

impl<const D: usize, const N: usize> Repair<D, N> {
    /// Makes the mesh the Delaunay triangulation of its points; points that are gone are no corners of it then.
    ///
    /// Returns whether that could be done by few and small steps; if not, the mesh is spoilt.
    pub fn repair(&mut self, mesh: &mut Mesh<D, N>) -> bool {
        if !self.survey(mesh) {
            return false;
        }
        self.region.make_room(mesh.points.len());
        for index in 0..self.wrong.len() {
            let cell = self.wrong[index];
            if mesh.marks[cell as usize] == Mark::Wrong && !self.renew_around(mesh, cell) {
                return false;
            }
        }
        self.settle(mesh) && mesh.hull_is_covered_once()
    }

    /// Takes the corner of a cell that is gone out of a Delaunay triangulation.
    ///
    /// Returns whether that could be done; if not, the mesh is spoilt.
    pub fn remove(&mut self, mesh: &mut Mesh<D, N>, cell: u32) -> bool {
        self.region.make_room(mesh.points.len());
        self.doubtful.clear();
        let done = self.region.renew(mesh, [cell]);
        self.doubtful.extend(&self.region.changed);
        done && self.settle(mesh)
    }

    fn renew_around(&mut self, mesh: &mut Mesh<D, N>, cell: u32) -> bool {
        let around = mesh.cell(cell).neighbours.map(Face::cell);
        let done = self.region.renew(mesh, around);
        self.doubtful.extend(&self.region.changed);
        done
    }

    /// Triangulates across violated faces until none is left.
    fn settle(&mut self, mesh: &mut Mesh<D, N>) -> bool {
        let mut left = mesh.cells.len();
        while let Some(face) = self.doubtful.pop() {
            if !mesh.is_violated(face) {
                continue;
            }
            let other = mesh.cell(face.cell()).neighbours[face.opposite()].cell();
            left -= 1;
            if left == 0 || !self.region.renew(mesh, [face.cell(), other]) {
                return false;
            }
            self.doubtful.extend(&self.region.changed);
        }
        true
    }

    /// Finds cells that are wrong and faces that are violated, and makes all circumspheres; whether there are but few.
    fn survey(&mut self, mesh: &mut Mesh<D, N>) -> bool {
        self.wrong.clear();
        self.doubtful.clear();
        for cell in 0..mesh.cells.len() {
            if mesh.marks[cell] == Mark::Free {
                continue;
            }
            // Too many among the first cells, some apart, foretell too many in all.
            let foretold = mesh.cells.len().min(cell + mesh.cells.len() / SOME);
            if FACE * self.doubtful.len() + CELL * self.wrong.len() > foretold {
                return false;
            }
            let Cell { corners, neighbours, .. } = mesh.cells[cell];
            let sphere = circumsphere(mesh.places(&mesh.cells[cell]));
            mesh.cells[cell].sphere = sphere;
            if sphere[D].is_nan() && mesh.is_wrong(&corners) {
                mesh.marks[cell] = Mark::Wrong;
                self.wrong.push(cell as u32);
                continue;
            }
            let origin = mesh.point(corners[D]);
            for at in 0..N {
                let other = neighbours[at];
                if (other.cell() as usize) < cell {
                    continue;
                }
                let apex = mesh.cell(other.cell()).corners[other.opposite()];
                let inside = in_circumsphere(&sphere, origin, mesh.point(apex));
                if inside > 0.0 || (inside == 0.0 && mesh.is_violated(Face::new(cell as u32, at))) {
                    self.doubtful.push(Face::new(cell as u32, at));
                }
            }
        }
        true
    }
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Whether a cell has a corner that is gone, or is turned over.
    #[cold]
    fn is_wrong(&self, corners: &[u32; N]) -> bool {
        corners.iter().any(|corner| self.is_gone(*corner))
            || (!corners.contains(&GHOST) && orientation(corners.map(|corner| self.point(corner))) <= 0.0)
    }

    /// Whether the corner behind a face of a cell lies in the circumsphere of the cell; of two ghosts, whether the hull is
    /// not convex between them.
    fn is_violated(&self, face: Face) -> bool {
        if self.marks[face.cell() as usize] != Mark::Open {
            return false;
        }
        let Cell { corners, neighbours, .. } = self.cell(face.cell());
        let other = neighbours[face.opposite()];
        let apex = self.cell(other.cell()).corners[other.opposite()];
        // A ghost and the cell before it: that is positive.
        let hull = apex == GHOST || corners[face.opposite()] == GHOST;
        !hull
            && self.marks[other.cell() as usize] == Mark::Open
            && !self.is_gone(apex)
            && self.conflicts(face.cell(), apex)
    }
}
