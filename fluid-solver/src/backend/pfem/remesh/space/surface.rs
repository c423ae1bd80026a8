//! The surface of the fluid: faces of cells without a neighbour.

use super::super::draft::{Draft, NONE};
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{cross, difference, dot};

/// Corners of the face opposite to each corner, turning left seen from outside.
pub const OUTWARD: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

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

/// Volume inside of the surface: Σ a × b · c / 6 over its faces, seen from one of its corners.
pub fn enclosed(cloud: &Cloud<3, 4>, draft: &Draft<3>) -> f64 {
    let Some(origin) = draft.edges.first().map(|face| cloud.place[face[0] as usize]) else { return 0.0 };
    let sixfold = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|node| difference(&cloud.place[node as usize], &origin));
        dot(&cross(&a, &b), &c)
    };
    draft.edges.iter().map(sixfold).sum::<f64>() / 6.0
}

/// Nodes of the surface that became one, and edges of it that got a node.
#[derive(Clone, Debug, Default)]
pub struct Edits {
    /// For each node the one that it became, or itself.
    heir: Vec<u32>,
    /// For each node the other end of an edge that was split, and the node between, or [`NONE`].
    split: Vec<[u32; 2]>,
    any: bool,
}

impl Edits {
    /// Nothing yet, of so many nodes.
    pub fn begin(&mut self, nodes: usize) {
        self.heir.clear();
        self.heir.extend(0..nodes as u32);
        self.split.clear();
        self.split.resize(nodes, [NONE; 2]);
        self.any = false;
    }

    /// The node that a node became.
    pub fn heir(&self, node: u32) -> u32 {
        self.heir[node as usize]
    }

    /// One node became another.
    pub fn collapse(&mut self, gone: u32, left: u32) {
        self.heir[gone as usize] = left;
        self.any = true;
    }

    /// A new node lies on an edge. No end of it may be the end of another such edge, or have become another node.
    pub fn split(&mut self, [a, b]: [u32; 2], middle: u32) {
        self.split[a as usize] = [b, middle];
        self.split[b as usize] = [a, middle];
        self.any = true;
    }

    /// Makes the faces those of the new nodes.
    pub fn apply(&self, faces: &mut Vec<[u32; 3]>) {
        if !self.any {
            return;
        }
        faces.iter_mut().flatten().for_each(|node| *node = self.heir[*node as usize]);
        faces.retain(|[a, b, c]| a != b && b != c && c != a);
        for index in 0..faces.len() {
            let face = faces[index];
            let split = |k: &usize| self.split[face[*k] as usize][0] == face[(k + 1) % 3];
            if let Some(k) = (0..3).find(split) {
                let [a, b, c] = [0, 1, 2].map(|i| face[(k + i) % 3]);
                let middle = self.split[a as usize][1];
                faces[index] = [a, middle, c];
                faces.push([middle, b, c]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_split_leaves_the_surface_closed_and_a_collapse_takes_two_faces() {
        // A tetrahedron on top of another.
        let faces = vec![[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
        let closed = |faces: &[[u32; 3]]| {
            let edges = || faces.iter().flat_map(|f| [0, 1, 2].map(|k| [f[k], f[(k + 1) % 3]]));
            edges().all(|[a, b]| edges().filter(|edge| *edge == [b, a]).count() == 1)
        };
        let mut edits = Edits::default();
        edits.begin(5);
        edits.split([0, 3], 5);
        let mut split = faces.clone();
        edits.apply(&mut split);
        assert!(split.len() == 8 && closed(&split), "{split:?}");
        edits.begin(5);
        edits.collapse(3, 0);
        let mut collapsed = faces;
        edits.apply(&mut collapsed);
        assert!(collapsed.len() == 4 && closed(&collapsed), "{collapsed:?}");
    }
}
