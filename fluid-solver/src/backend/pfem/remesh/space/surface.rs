//! The surface of the fluid: faces of cells without a neighbour.

use super::super::draft::Draft;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};

/// Corners of the face opposite to each corner, turning left seen from outside.
const OUTWARD: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Writes the faces of the surface and the nodes on it to the draft.
pub fn read(cloud: &Cloud<3, 4>, draft: &mut Draft<3>) {
    draft.edges.clear();
    draft.exposed.clear();
    draft.exposed.resize(cloud.place.len(), false);
    for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
        for i in (0..4).filter(|&i| around[i] == OUTSIDE) {
            let face = OUTWARD[i].map(|k| cell[k]);
            face.iter().for_each(|&node| draft.exposed[node as usize] = true);
            draft.edges.push(face);
        }
    }
}
