//! Which cells share which faces.

use super::{MeshError, Neighbour};
use rayon::slice::ParallelSliceMut;

/// A face of a cell: its sorted corners (the key), the cell, and the corner opposite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Face<const D: usize> {
    /// Corners in ascending order.
    pub key: [u32; D],
    /// The cell.
    pub cell: u32,
    /// The corner of the cell opposite to the face.
    pub opposite: u8,
}

/// The corners of the face opposite to corner `opposite`, ordered so that the normal of a positive cell points outward.
pub fn outward<const D: usize, const N: usize>(cell: &[u32; N], opposite: usize) -> [u32; D] {
    let mut points: [u32; D] = std::array::from_fn(|k| cell[if k < opposite { k } else { k + 1 }]);
    if opposite % 2 == 1 {
        points.swap(0, 1);
    }
    points
}

fn faces<const D: usize, const N: usize>(cells: &[[u32; N]]) -> Vec<Face<D>> {
    let mut faces = Vec::with_capacity(N * cells.len());
    for (c, cell) in cells.iter().enumerate() {
        for opposite in 0..N {
            let mut key: [u32; D] = outward(cell, opposite);
            key.sort_unstable();
            faces.push(Face { key, cell: c as u32, opposite: opposite as u8 });
        }
    }
    faces.par_sort_unstable();
    faces
}

/// Faces that belong to one cell only, sorted by key.
pub fn exposed_faces<const D: usize, const N: usize>(cells: &[[u32; N]]) -> Vec<Face<D>> {
    let faces = faces::<D, N>(cells);
    faces.chunk_by(|a, b| a.key == b.key).filter(|group| group.len() == 1).map(|group| group[0]).collect()
}

/// Links between the cells, and the faces on the boundary, sorted by key.
pub struct Topology<const D: usize, const N: usize> {
    /// Neighbours of each cell; those on the boundary refer to `boundary`.
    pub neighbours: Vec<[Neighbour; N]>,
    /// Faces with nothing behind.
    pub boundary: Vec<Face<D>>,
    /// Faces linked to a periodic image, sorted by key.
    pub periodic: Vec<Face<D>>,
}

impl<const D: usize, const N: usize> Topology<D, N> {
    /// Matches faces by their points, and what is left by the nodes these are images of.
    pub fn new(cells: &[[u32; N]], node_of: &[u32]) -> Result<Self, MeshError> {
        let folded = |cell: &[u32; N]| (0..N).any(|i| (0..i).any(|j| same_node(node_of, cell[i], cell[j])));
        if let Some(cell) = cells.iter().position(folded) {
            return Err(MeshError::PeriodicCell { cell, points: cells[cell].to_vec() });
        }
        let mut neighbours = vec![[Neighbour::Boundary(0); N]; cells.len()];
        let mut link = |a: &Face<D>, b: &Face<D>, wrap: fn(u32) -> Neighbour| {
            neighbours[a.cell as usize][usize::from(a.opposite)] = wrap(b.cell);
            neighbours[b.cell as usize][usize::from(b.opposite)] = wrap(a.cell);
        };
        let mut exposed = Vec::new();
        for group in faces::<D, N>(cells).chunk_by(|a, b| a.key == b.key) {
            match group {
                [single] => exposed.push(*single),
                [a, b] => link(a, b, Neighbour::Cell),
                _ => return Err(shared(group)),
            }
        }
        let by_node = |face: &Face<D>| {
            let mut key = face.key.map(|point| node_of[point as usize]);
            key.sort_unstable();
            key
        };
        let mut ordered: Vec<_> = exposed.iter().map(|face| (by_node(face), *face)).collect();
        ordered.sort_unstable();
        let (mut boundary, mut periodic) = (Vec::new(), Vec::new());
        for group in ordered.chunk_by(|a, b| a.0 == b.0) {
            match group {
                [(_, single)] => boundary.push(*single),
                [(_, a), (_, b)] if !a.key.iter().any(|point| b.key.contains(point)) => {
                    link(a, b, Neighbour::Periodic);
                    periodic.extend([*a, *b]);
                }
                _ => return Err(too_few_cells(group[0].1, group[1].1)),
            }
        }
        boundary.sort_unstable();
        periodic.sort_unstable();
        for (index, face) in boundary.iter().enumerate() {
            neighbours[face.cell as usize][usize::from(face.opposite)] = Neighbour::Boundary(index as u32);
        }
        Ok(Self { neighbours, boundary, periodic })
    }

    /// Fails if some cell cannot be reached from cell 0.
    pub fn check_connected(&self, cells: &[[u32; N]]) -> Result<(), MeshError> {
        let mut reached = vec![false; cells.len()];
        let mut front = vec![0];
        reached[0] = true;
        while let Some(cell) = front.pop() {
            for neighbour in &self.neighbours[cell as usize] {
                let (Neighbour::Cell(next) | Neighbour::Periodic(next)) = *neighbour else { continue };
                if !reached[next as usize] {
                    reached[next as usize] = true;
                    front.push(next);
                }
            }
        }
        match reached.iter().position(|&seen| !seen) {
            None => Ok(()),
            Some(cell) => Err(MeshError::Disconnected {
                cell,
                points: cells[cell].to_vec(),
                reached: reached.iter().filter(|&&seen| seen).count(),
                cells: cells.len(),
            }),
        }
    }
}

fn same_node(node_of: &[u32], a: u32, b: u32) -> bool {
    node_of[a as usize] == node_of[b as usize]
}

fn shared<const D: usize>(group: &[Face<D>]) -> MeshError {
    MeshError::FaceShared {
        points: group[0].key.to_vec(),
        cells: group.iter().map(|face| face.cell).collect(),
    }
}

fn too_few_cells<const D: usize>(a: Face<D>, b: Face<D>) -> MeshError {
    MeshError::PeriodicFaces { first: a.key.to_vec(), second: b.key.to_vec() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_faces_of_a_triangle_run_counter_clockwise() {
        assert_eq!(outward::<2, 3>(&[7, 8, 9], 0), [8, 9]);
        assert_eq!(outward::<2, 3>(&[7, 8, 9], 1), [9, 7]);
        assert_eq!(outward::<2, 3>(&[7, 8, 9], 2), [7, 8]);
    }
}
