//! Whatever finds the mesh between moved nodes.

use super::cloud::Cloud;
use super::remesh::{Books, Events, Remesher, TargetSize};
use super::wall::Wall;

/// Finds the mesh at t_{n+1} between nodes that moved.
pub trait Renewal<const D: usize, const N: usize>: Send {
    /// On entry the cells are those before the move.
    ///
    /// # Errors
    /// Places that are not finite.
    fn renew(
        &mut self,
        cloud: &mut Cloud<D, N>,
        walls: &[Wall<D>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<D>,
    ) -> Result<Events, delaunay::Error>;
}

impl Renewal<2, 3> for Remesher<2, 3> {
    fn renew(
        &mut self,
        cloud: &mut Cloud<2, 3>,
        walls: &[Wall<2>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<2>,
    ) -> Result<Events, delaunay::Error> {
        self.remesh(cloud, walls, time, size, books)
    }
}
