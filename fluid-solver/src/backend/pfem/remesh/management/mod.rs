//! Nodes come and go so that neighbours stand about h apart.

mod collapse;
mod interior;
mod split;

use super::draft::Draft;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;

/// Manages the nodes of the moved cloud: first those of the surface, then those inside.
pub fn manage(cloud: &mut Cloud<2, 3>, draft: &mut Draft, walls: &[Wall<2>], time: f64) {
    collapse::collapse_short_edges(cloud, draft, walls, time);
    interior::remove_close_nodes(cloud, draft);
    split::split_long_edges(cloud, draft, walls, time);
    interior::insert_between_far_nodes(cloud, draft);
}

/// Edges shorter than this share of h on the surface become a node.
pub const SHORTEST: f64 = 0.5;
/// Edges longer than this share of h on the surface are split.
pub const LONGEST: f64 = 1.4;
/// Inner nodes closer than this share of h to another inner node go.
pub const CLOSEST: f64 = 0.6;
/// Inner nodes closer than this share of h to a node or an edge of the surface go.
pub const CLOSEST_TO_SURFACE: f64 = 0.4;
/// Inner edges longer than this share of h get a node.
pub const FARTHEST: f64 = 1.6;
