//! Delaunay triangulations in two and three dimensions: exact, deterministic, reusable from step to step.

pub mod constrained;

/// What lies behind a face of the hull.
pub const HULL: u32 = u32::MAX;

/// Simplices of a triangulation, positively oriented, and how they hang together; `N = D + 1`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangulation<const N: usize> {
    /// Corners, as indices of points.
    pub cells: Vec<[u32; N]>,
    /// Neighbour across the face opposite to each corner, or [`HULL`].
    pub neighbours: Vec<[u32; N]>,
}
