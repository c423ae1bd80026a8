//! Which cell holds a point.
//!
//! From a remembered cell the search walks through faces towards the point; where there is none, or the walk hits the
//! boundary, it asks a grid of bins. The answer depends on the point alone, never on the remembered cell, so that a
//! restarted run repeats the bits: a point on a face belongs to the lowest of the cells that share it, and the walk
//! leaves points that close to a face to the bins.

use super::bins::{Bins, bounds};
use super::{Mesh, Neighbour};
use crate::element::closest_point;
use crate::element::simplex::{Vector, barycentric, difference, distance, dot};

/// A cell holds a point if no barycentric coordinate is below this: the round-off of their computation.
const INSIDE: f64 = -1e-12;
/// The walk answers only if all barycentric coordinates exceed this.
const CLEAR_OF_FACES: f64 = 1e-7;
/// Steps after which the walk gives up.
const LONGEST_WALK: usize = 64;
/// Cells and boundary faces per bin.
const PER_BIN: usize = 6;

/// Where a point is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Location<const N: usize> {
    /// In a cell.
    Inside {
        /// The cell.
        cell: u32,
        /// Barycentric coordinates in it.
        coordinates: [f64; N],
    },
    /// In no cell.
    Outside {
        /// The nearest boundary face, the lowest of several; `None` if the mesh has no boundary.
        nearest_face: Option<u32>,
    },
    /// Nowhere: a coordinate is not finite.
    NotFinite,
}

/// Search structure over the cells and the boundary of one mesh.
#[derive(Debug, Clone)]
pub struct Locator<const D: usize> {
    cells: Bins<D>,
    faces: Bins<D>,
}

impl<const D: usize> Locator<D> {
    /// Sorts the cells and boundary faces of a mesh into bins.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        let around = mesh.bounds();
        let cells = mesh.cells().len();
        let faces = mesh.boundary().len();
        let cell_box = |cell| inflate(bounds(&mesh.vertices(cell)));
        let face_box = |face: usize| bounds(&mesh.face_vertices(&mesh.boundary()[face]));
        Self {
            cells: Bins::new(around, cells / PER_BIN, cells, cell_box),
            faces: Bins::new(around, faces / PER_BIN, faces, face_box),
        }
    }

    /// Finds the cell that holds `x`; `mesh` is the one the locator was made for, `remembered` a guess.
    ///
    /// On periodic axes `x` may lie in any period.
    pub fn locate<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        x: &Vector<D>,
        remembered: Option<u32>,
    ) -> Location<N> {
        if !x.iter().all(|c| c.is_finite()) {
            return Location::NotFinite;
        }
        let x = mesh.periodicity().wrap(x);
        match self.host(mesh, &x, remembered) {
            Some((cell, coordinates)) => Location::Inside { cell, coordinates },
            None => Location::Outside { nearest_face: self.nearest_face(mesh, &x) },
        }
    }

    /// The cell that holds `x`, a finite point in the mesh's own period, with the barycentric coordinates there.
    pub fn host<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        x: &Vector<D>,
        remembered: Option<u32>,
    ) -> Option<(u32, [f64; N])> {
        let walked = remembered
            .filter(|&cell| (cell as usize) < mesh.cells().len())
            .and_then(|cell| walk(mesh, x, cell));
        walked.or_else(|| self.search(mesh, x))
    }

    /// Calls `visit(face, distance, closest point)` for every boundary face within `reach` of `x`, some of them several times.
    pub fn for_each_face_within<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        x: &Vector<D>,
        reach: f64,
        mut visit: impl FnMut(u32, f64, Vector<D>),
    ) {
        let corner = |sign: f64| self.faces.index(&x.map(|c| c + sign * reach));
        super::bins::for_each_index(&corner(-1.0), &corner(1.0), |index| {
            for &face in self.faces.bin(index) {
                let place = closest_point::on_facet(&mesh.face_vertices(&mesh.boundary()[face as usize]), x);
                let distance = distance(x, &place);
                if distance <= reach {
                    visit(face, distance, place);
                }
            }
        });
    }

    /// The lowest cell that holds `x`.
    fn search<const N: usize>(&self, mesh: &Mesh<D, N>, x: &Vector<D>) -> Option<(u32, [f64; N])> {
        self.cells.bin(&self.cells.index(x)).iter().find_map(|&cell| {
            let coordinates = coordinates_in(mesh, cell, x);
            coordinates.iter().all(|&c| c >= INSIDE).then_some((cell, coordinates))
        })
    }

    /// The boundary face nearest to `x`.
    fn nearest_face<const N: usize>(&self, mesh: &Mesh<D, N>, x: &Vector<D>) -> Option<u32> {
        self.faces.nearest(x, |face| {
            let vertices = mesh.face_vertices(&mesh.boundary()[face as usize]);
            let off = difference(x, &closest_point::on_facet(&vertices, x));
            dot(&off, &off)
        })
    }
}

/// Walks from `cell` towards `x`; `None` if it meets the boundary, a face too close to `x`, or loses its way.
fn walk<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    x: &Vector<D>,
    mut cell: u32,
) -> Option<(u32, [f64; N])> {
    for _ in 0..LONGEST_WALK {
        let coordinates = coordinates_in(mesh, cell, x);
        let lowest =
            (1..N).fold(0, |lowest, i| if coordinates[i] < coordinates[lowest] { i } else { lowest });
        if coordinates[lowest] > CLEAR_OF_FACES {
            return Some((cell, coordinates));
        }
        match mesh.neighbours(cell as usize)[lowest] {
            Neighbour::Cell(next) if coordinates[lowest] < -CLEAR_OF_FACES => cell = next,
            _ => return None,
        }
    }
    None
}

fn coordinates_in<const D: usize, const N: usize>(mesh: &Mesh<D, N>, cell: u32, x: &Vector<D>) -> [f64; N] {
    let cell = cell as usize;
    barycentric(&mesh.gradients()[cell], &mesh.vertices(cell), x)
}

/// Widens a box by more than the round-off that [`INSIDE`] forgives.
fn inflate<const D: usize>((lower, upper): (Vector<D>, Vector<D>)) -> (Vector<D>, Vector<D>) {
    let margin = 1e-10 * distance(&lower, &upper);
    (lower.map(|c| c - margin), upper.map(|c| c + margin))
}
