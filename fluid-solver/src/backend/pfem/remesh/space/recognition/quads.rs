//! Pairs of faces of the surface of which the new cells have the other diagonal.

use super::faces::Faces;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::flow::regular_volume;
use crate::element::simplex::{longest_edge, volume_and_areas};

/// Four corners of two faces that hold more than this share of a regular cell of the same longest edge are no flat quadrangle.
const FLAT: f64 = 0.2;

/// Two faces with a common edge, by their places in a list, and the two that the other diagonal makes of them.
struct Quad {
    old: [usize; 2],
    new: [[u32; 3]; 2],
}

/// The pairs, with scratch.
#[derive(Default)]
pub struct Quads {
    /// The faces with the other diagonals.
    pub turned: Vec<[u32; 3]>,
    table: Faces,
    /// Directed edges of faces, with the third corner and the place of the face.
    edges: Vec<([u32; 2], u32, usize)>,
    found: Vec<Quad>,
    taken: Vec<bool>,
}

impl Quads {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.turned.clear();
    }

    /// Whether a face is one that the other diagonal makes, turning as this one does, or the other way round.
    #[inline]
    pub fn side(&self, face: [u32; 3]) -> Option<bool> {
        if self.turned.is_empty() { None } else { self.table.side(face) }
    }

    /// Takes those faces off `missing` that hold a flat quadrangle with another of them and have the other diagonal among the
    /// faces of cells, `present`.
    pub fn turn(
        &mut self,
        cloud: &Cloud<3, 4>,
        missing: &mut Vec<[u32; 3]>,
        present: impl Iterator<Item = [u32; 3]>,
    ) {
        self.find(cloud, missing);
        let Self { turned, table, found, taken, .. } = self;
        turned.extend(found.iter().flat_map(|quad| quad.new));
        table.read(turned);
        present.for_each(|face| {
            table.meet(face);
        });
        turned.clear();
        taken.clear();
        taken.resize(missing.len(), false);
        for Quad { old, new } in &*found {
            if old.iter().all(|&face| !taken[face]) && new.iter().all(|&face| table.was_met(face)) {
                old.iter().for_each(|&face| taken[face] = true);
                turned.extend(new);
            }
        }
        table.read(turned);
        let mut place = 0;
        missing.retain(|_| {
            place += 1;
            !taken[place - 1]
        });
    }

    /// Finds the flat quadrangles.
    fn find(&mut self, cloud: &Cloud<3, 4>, missing: &[[u32; 3]]) {
        let Self { edges, found, .. } = self;
        edges.clear();
        for (place, face) in missing.iter().enumerate() {
            edges.extend((0..3).map(|k| ([face[k], face[(k + 1) % 3]], face[(k + 2) % 3], place)));
        }
        edges.sort_unstable();
        found.clear();
        for &([a, b], d, first) in edges.iter().filter(|([a, b], ..)| a < b) {
            let next = edges.partition_point(|(edge, ..)| *edge < [b, a]);
            let Some(&(edge, c, second)) = edges.get(next) else { continue };
            if edge == [b, a] && c != d && is_flat(cloud, [a, b, c, d]) {
                found.push(Quad { old: [first, second], new: [[c, d, a], [d, c, b]] });
            }
        }
    }
}

fn is_flat(cloud: &Cloud<3, 4>, corners: [u32; 4]) -> bool {
    let vertices = cloud.vertices(&corners);
    volume_and_areas(&vertices).0.abs() < FLAT * regular_volume(3) * longest_edge(&vertices).powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_faces_are_found_with_their_other_diagonal_if_that_is_there() {
        let place = vec![[0.0; 3], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1], [1.0, 0.0, 0.1], [2.0, 1.0, 0.0]];
        let nodes = place.len();
        let cloud = Cloud { place, drop: vec![0.0; nodes], ..Cloud::default() };
        // The diagonal from 0 to 1, and a face beside it.
        let faces = [[0, 1, 2], [1, 0, 3], [4, 1, 3]];
        let mut quads = Quads::default();
        let mut missing = faces.to_vec();
        quads.turn(&cloud, &mut missing, [[2, 3, 0], [1, 2, 3]].into_iter());
        assert_eq!(missing, [[4, 1, 3]]);
        assert_eq!(
            [[3, 2, 0], [2, 3, 0], [3, 2, 1], [2, 3, 1]].map(|face| quads.side(face)),
            [Some(true), Some(false), Some(false), Some(true)]
        );
        quads.clear();
        let mut missing = faces.to_vec();
        quads.turn(&cloud, &mut missing, [[2, 3, 0]].into_iter());
        assert_eq!((missing.len(), quads.side([2, 3, 0])), (3, None));
    }
}
