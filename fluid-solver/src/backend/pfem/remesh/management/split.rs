//! Long edges of the surface get a node in their middle.

use super::super::draft::Draft;
use super::collapse::onto_wall;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::distance;

/// Splits edges longer than 1.4 h; those of a wall get a node of the wall.
pub fn split_long_edges(cloud: &mut Cloud<2, 3>, draft: &mut Draft, walls: &[Wall<2>], time: f64) {
    for index in 0..draft.edges.len() {
        let [a, b] = draft.edges[index];
        let length = distance(&cloud.place[a as usize], &cloud.place[b as usize]);
        if length > super::LONGEST * draft.size_between(a, b) {
            let contacts = cloud.contacts[a as usize].common(cloud.contacts[b as usize]);
            let middle = draft.add_between(cloud, a, b, contacts);
            cloud.place[middle as usize] = onto_wall(contacts, cloud.place[middle as usize], walls, time);
            draft.edges[index] = [a, middle];
            draft.edges.push([middle, b]);
        }
    }
}
