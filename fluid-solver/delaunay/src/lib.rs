//! Delaunay triangulations in two and three dimensions: exact, deterministic, reusable from step to step.
//!
//! A triangulation is a function of the points and their ranks alone: points are lifted to (x, |x|²), the lifted
//! coordinate is raised by an infinitesimal that grows beyond all bounds from rank to rank (Edelsbrunner & Mücke 1990),
//! and the lower hull is then unique. So grids, cospherical, coplanar and collinear sets are triangulated like any other;
//! no cell is flat.
//!
//! Points are inserted one by one: the cells whose circumsphere holds the point are removed, their hole is filled with
//! cells from its rim to the point (Bowyer 1981, Watson 1981). The order is random in rounds of eightfold size and runs
//! along a Hilbert curve inside a round (Amenta, Choi & Rote 2003).

mod build;
mod canonical;
mod check;
mod delaunay;
mod edit;
mod error;
mod points;
mod predicate;
mod survivors;

pub use check::{Faults, check};
pub use delaunay::Delaunay;
pub use error::Error;

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
    /// Points that are no corner because they equal another, and which: `[left out, kept]`. The kept one has the lowest rank.
    pub twins: Vec<[u32; 2]>,
}
