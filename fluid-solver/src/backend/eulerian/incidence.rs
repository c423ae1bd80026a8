//! Assembly by rows: every row gathers from the cells around its node, so rows may be filled by any thread.

use crate::mesh::Mesh;
use linear::Pattern;
use rayon::prelude::*;

/// Rows per unit of parallel work; fixed, so that nothing depends on the number of threads.
pub const ROWS: usize = 256;

/// A cell seen from one of its corners.
#[derive(Debug, Clone, Copy)]
pub struct Corner<const N: usize> {
    /// The cell.
    pub cell: u32,
    /// Which of its corners the node is.
    pub local: u32,
    /// Where the entries of the cell's nodes are in the row of the node.
    pub entries: [u32; N],
}

/// The cells around every node, in ascending order, and the pattern of matrices on the nodes.
pub struct Incidence<const N: usize> {
    first: Vec<u32>,
    corners: Vec<Corner<N>>,
}

impl<const N: usize> Incidence<N> {
    /// Links a mesh to the pattern of its nodes.
    pub fn new<const D: usize>(mesh: &Mesh<D, N>, pattern: &Pattern) -> Self {
        let mut first = vec![0u32; mesh.node_count() + 1];
        let cells = 0..mesh.cells().len();
        for cell in cells.clone() {
            mesh.cell_nodes(cell).iter().for_each(|&node| first[node as usize + 1] += 1);
        }
        for node in 0..mesh.node_count() {
            first[node + 1] += first[node];
        }
        let mut next = first.clone();
        let mut corners = vec![Corner { cell: 0, local: 0, entries: [0; N] }; cells.len() * N];
        for cell in cells {
            let nodes = mesh.cell_nodes(cell);
            for (local, &node) in nodes.iter().enumerate() {
                let row = pattern.row(node as usize);
                let entry = |column: u32| row.partition_point(|&other| other < column) as u32;
                let place = &mut next[node as usize];
                corners[*place as usize] =
                    Corner { cell: cell as u32, local: local as u32, entries: nodes.map(entry) };
                *place += 1;
            }
        }
        Self { first, corners }
    }

    /// The corners at a node.
    pub fn of(&self, node: usize) -> &[Corner<N>] {
        &self.corners[self.first[node] as usize..self.first[node + 1] as usize]
    }
}

/// Entries of consecutive rows, in one array or in several.
pub trait Entries: Send + Sized {
    /// The first `count` and the rest.
    fn split(self, count: usize) -> (Self, Self);
}

impl<T: Send> Entries for &mut [T] {
    fn split(self, count: usize) -> (Self, Self) {
        self.split_at_mut(count)
    }
}

/// Calls `work(row, entries of the row, value of the row)` for every row of a matrix and a vector.
pub fn for_each_row<E: Entries, R: Send>(
    pattern: &Pattern,
    entries: E,
    values: &mut [R],
    work: impl Fn(usize, E, &mut R) + Sync,
) {
    let (mut rest, mut chunks) = (entries, Vec::with_capacity(values.len().div_ceil(ROWS)));
    for (index, values) in values.chunks_mut(ROWS).enumerate() {
        let first = index * ROWS;
        let count = pattern.slots(first + values.len() - 1).end - pattern.slots(first).start;
        let (own, after) = rest.split(count);
        chunks.push((first, own, values));
        rest = after;
    }
    chunks.into_par_iter().for_each(|(first, mut own, values)| {
        for (row, value) in (first..).zip(values) {
            let (entries, after) = own.split(pattern.slots(row).len());
            work(row, entries, value);
            own = after;
        }
    });
}
