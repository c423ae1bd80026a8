//! Whatever finds the mesh between moved nodes.

use super::cloud::Cloud;
use super::remesh::{Books, Events, Spent, TargetSize};
use super::wall::Wall;

/// Finds the mesh at t_{n+1} between nodes that moved.
pub trait Renewal<const D: usize, const N: usize>: Send {
    /// The mesh of a cloud whose nodes were moved: on entry its cells are those before the move.
    ///
    /// Σ m_i v_i over cells and drops (m_i an N-th of the cells around a node) is kept to round-off, but for what nodes that
    /// land on a wall give to it.
    ///
    /// # Errors
    /// A place that is not finite.
    fn remesh(
        &mut self,
        cloud: &mut Cloud<D, N>,
        walls: &[Wall<D>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<D>,
    ) -> Result<Events, delaunay::Error>;

    /// Processor time since the start.
    fn spent(&self) -> Spent;
}
