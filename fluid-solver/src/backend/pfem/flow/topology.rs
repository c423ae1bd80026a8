//! The cells around every node, and the pattern of matrices on the nodes.

use linear::Pattern;
use std::sync::Arc;

/// A cell seen from one of its corners.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corner {
    /// The cell.
    pub cell: u32,
    /// Which of its corners the node is.
    pub local: u32,
}

/// Kept from step to step while the cells are the same.
#[derive(Clone, Debug)]
pub struct Topology<const N: usize> {
    nodes: usize,
    cells: Vec<[u32; N]>,
    first: Vec<u32>,
    corners: Vec<Corner>,
    pattern: Arc<Pattern>,
}

impl<const N: usize> Topology<N> {
    /// Of these cells.
    ///
    /// # Errors
    /// A node that is not there; more entries than 32 bits count.
    pub fn new(nodes: usize, cells: &[[u32; N]]) -> Result<Self, linear::Error> {
        let pattern = Arc::new(Pattern::from_elements(nodes, cells)?);
        let mut first = vec![0u32; nodes + 1];
        for &node in cells.as_flattened() {
            first[node as usize + 1] += 1;
        }
        for node in 0..nodes {
            first[node + 1] += first[node];
        }
        let mut next = first.clone();
        let mut corners = vec![Corner::default(); cells.len() * N];
        for (cell, nodes) in cells.iter().enumerate() {
            for (local, &node) in nodes.iter().enumerate() {
                let place = &mut next[node as usize];
                corners[*place as usize] = Corner { cell: cell as u32, local: local as u32 };
                *place += 1;
            }
        }
        Ok(Self { nodes, cells: cells.to_vec(), first, corners, pattern })
    }

    /// Whether it is that of these cells.
    pub fn is_of(&self, nodes: usize, cells: &[[u32; N]]) -> bool {
        self.nodes == nodes && self.cells == cells
    }

    /// The corners at a node, by ascending cell; none at a drop.
    #[inline]
    pub fn corners(&self, node: usize) -> &[Corner] {
        &self.corners[self.first[node] as usize..self.first[node + 1] as usize]
    }

    /// Whether the node belongs to no cell.
    pub fn is_drop(&self, node: usize) -> bool {
        self.first[node] == self.first[node + 1]
    }

    /// The nodes of each cell.
    pub fn cells(&self) -> &[[u32; N]] {
        &self.cells
    }

    /// Which nodes share a cell.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }
}
