//! Simplicial meshes: triangles in the plane, tetrahedra in space.
//!
//! A mesh has *points*, the corners of its cells, and *nodes*, the carriers of unknowns. Without periodic axes the two
//! are the same. A periodic image of a node is a point but no node: the nodes are the first points, the images follow,
//! and [`Mesh::node_of`] says whose image a point is. So a field has one value per node and cannot disagree with itself
//! across a periodic side.

pub mod bins;
mod build;
pub mod case;
mod corners;
mod error;
pub mod generate;
pub mod gmsh;
pub mod locate;
mod particles;
mod periodicity;
mod scale;
mod surface;
mod topology;

pub use build::{MeshParts, PeriodicPairs};
pub use corners::Corners;
pub use error::{MeshError, Place};
pub use particles::Linked;
pub use periodicity::{Period, Periodicity};

use crate::element::simplex::Vector;

/// What lies behind a face of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Neighbour {
    /// A cell that shares the face.
    Cell(u32),
    /// A cell that shares the face's periodic image.
    Periodic(u32),
    /// Nothing: the boundary face of this index.
    Boundary(u32),
}

/// A face of the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundaryFace<const D: usize> {
    /// Its corners, as points.
    pub points: [u32; D],
    /// The cell it belongs to.
    pub cell: u32,
    /// The corner of that cell it lies opposite to.
    pub opposite: u8,
    /// Its physical group, an index into [`Mesh::groups`].
    pub group: u32,
}

/// A mesh with positive cells and a fully named boundary, checked and connected unless it is of particles; `N = D + 1`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh<const D: usize, const N: usize> {
    points: Vec<Vector<D>>,
    node_of: Vec<u32>,
    node_count: usize,
    cells: Vec<[u32; N]>,
    neighbours: Vec<[Neighbour; N]>,
    boundary: Vec<BoundaryFace<D>>,
    groups: Vec<String>,
    periodicity: Periodicity<D>,
    volumes: Vec<f64>,
    gradients: Vec<[Vector<D>; N]>,
    measure: Vec<f64>,
    size: Vec<f64>,
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Positions of all points (m): the nodes first, then their periodic images.
    pub fn points(&self) -> &[Vector<D>] {
        &self.points
    }

    /// Positions of the nodes (m).
    pub fn nodes(&self) -> &[Vector<D>] {
        &self.points[..self.node_count]
    }

    /// Number of nodes, the length of every nodal field.
    pub fn node_count(&self) -> usize {
        self.node_count
    }

    /// The node a point carries or is the periodic image of.
    pub fn node_of(&self, point: u32) -> u32 {
        self.node_of[point as usize]
    }

    /// Corners of the cells, as points.
    pub fn cells(&self) -> &[[u32; N]] {
        &self.cells
    }

    /// Corners of a cell, as nodes.
    pub fn cell_nodes(&self, cell: usize) -> [u32; N] {
        self.cells[cell].map(|point| self.node_of(point))
    }

    /// Positions of the corners of a cell (m).
    pub fn vertices(&self, cell: usize) -> [Vector<D>; N] {
        self.cells[cell].map(|point| self.points[point as usize])
    }

    /// What lies behind the faces of a cell; face `i` lies opposite to corner `i`.
    pub fn neighbours(&self, cell: usize) -> &[Neighbour; N] {
        &self.neighbours[cell]
    }

    /// Volumes of the cells (m³; areas in m² in 2D).
    pub fn volumes(&self) -> &[f64] {
        &self.volumes
    }

    /// Gradients (1/m) of the shape functions of each cell, one per corner.
    pub fn gradients(&self) -> &[[Vector<D>; N]] {
        &self.gradients
    }

    /// Lumped measure of the nodes `|N_a| = ∫ N_a` (m³; m² in 2D), periodic images summed.
    pub fn measure(&self) -> &[f64] {
        &self.measure
    }

    /// Mesh size at the nodes (m): the mean of `(D! V_e)^{1/D}` over the cells around, weighted by volume; infinite
    /// for a node of no cell.
    pub fn size(&self) -> &[f64] {
        &self.size
    }

    /// The boundary faces, corners ordered so that the normal points outward; periodic sides are not among them.
    pub fn boundary(&self) -> &[BoundaryFace<D>] {
        &self.boundary
    }

    /// Positions of the corners of a boundary face (m).
    pub fn face_vertices(&self, face: &BoundaryFace<D>) -> [Vector<D>; D] {
        face.points.map(|point| self.points[point as usize])
    }

    /// Outward area vector of a boundary face (m²; m in 2D): `-D V ∇N` of the corner opposite.
    pub fn area_vector(&self, face: &BoundaryFace<D>) -> Vector<D> {
        let cell = face.cell as usize;
        let factor = -(D as f64) * self.volumes[cell];
        self.gradients[cell][usize::from(face.opposite)].map(|slope| factor * slope)
    }

    /// Names of the physical groups.
    pub fn groups(&self) -> &[String] {
        &self.groups
    }

    /// The physical group of a name.
    pub fn group(&self, name: &str) -> Option<u32> {
        self.groups.iter().position(|group| group == name).map(|index| index as u32)
    }

    /// The periodic axes.
    pub fn periodicity(&self) -> &Periodicity<D> {
        &self.periodicity
    }

    /// Smallest box, parallel to the axes, around the mesh: lower and upper corner (m).
    pub fn bounds(&self) -> (Vector<D>, Vector<D>) {
        bins::bounds(&self.points)
    }

    /// Value of a nodal field at the barycentric coordinates of a cell.
    pub fn interpolate(&self, field: &[f64], cell: usize, coordinates: &[f64; N]) -> f64 {
        let nodes = self.cell_nodes(cell);
        (0..N).map(|i| coordinates[i] * field[nodes[i] as usize]).sum()
    }
}
