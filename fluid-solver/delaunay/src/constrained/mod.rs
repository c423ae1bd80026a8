//! Triangulations that have edges, in space faces, that Delaunay's may lack.

mod plane;
mod space;

pub use plane::{Constrained, Obstacle};
pub use space::Recovery;
