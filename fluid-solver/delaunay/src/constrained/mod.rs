//! Triangulations that have edges, in space faces, that Delaunay's may lack.

mod plane;
mod space;

pub use plane::{Constrained, Obstacle};
pub use space::Recovery;

use crate::HULL;

/// Finds some cell of each point, [`HULL`] if it has none.
fn find_incident<const N: usize>(cells: &[[u32; N]], points: usize, incident: &mut Vec<u32>) {
    incident.clear();
    incident.resize(points, HULL);
    for (index, cell) in cells.iter().enumerate() {
        cell.iter().for_each(|corner| incident[*corner as usize] = index as u32);
    }
}
