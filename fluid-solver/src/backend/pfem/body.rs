//! The fluid at the start: the mesh of the case, and bodies besides it.

use super::cloud::{Cloud, OUTSIDE};
use super::wall::Contacts;
use crate::element::simplex::{Vector, volume_and_gradients};
use crate::mesh::generate::{BoxMesh, Disc};
use crate::mesh::{Mesh, MeshError, Neighbour};
use delaunay::Delaunay;
use std::f64::consts::PI;

/// Places of nodes (m), and the cells between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Body<const D: usize, const N: usize> {
    /// Places.
    pub place: Vec<Vector<D>>,
    /// Corners of the cells.
    pub cells: Vec<[u32; N]>,
    /// Neighbours of the cells, or [`OUTSIDE`].
    pub neighbours: Vec<[u32; N]>,
}

impl<const D: usize, const N: usize> Body<D, N> {
    /// That of a mesh without periodic axes.
    pub fn of_mesh(mesh: &Mesh<D, N>) -> Self {
        let next = |neighbour: Neighbour| match neighbour {
            Neighbour::Cell(cell) => cell,
            Neighbour::Periodic(_) | Neighbour::Boundary(_) => OUTSIDE,
        };
        Self {
            place: mesh.nodes().to_vec(),
            cells: mesh.cells().to_vec(),
            neighbours: (0..mesh.cells().len()).map(|cell| mesh.neighbours(cell).map(next)).collect(),
        }
    }

    /// A box of cells whose edges are at most `size` (m).
    ///
    /// # Errors
    /// More nodes than can be counted.
    pub fn of_box(lower: Vector<D>, upper: Vector<D>, size: f64) -> Result<Self, MeshError> {
        let cells = std::array::from_fn(|k| ((upper[k] - lower[k]) / size - 1e-9).ceil().max(1.0) as usize);
        let mesh: Mesh<D, N> =
            BoxMesh { lower, upper, cells, periodic: [false; D], jitter: None }.generate()?;
        Ok(Self::of_mesh(&mesh))
    }

    /// A sphere (2D: a circle) of nodes about `size` apart (m), in rings or shells; Delaunay's cells fill it, as it is convex.
    ///
    /// # Errors
    /// More nodes than can be triangulated.
    pub fn of_sphere(centre: Vector<D>, radius: f64, size: f64) -> Result<Self, delaunay::Error> {
        let rings = (radius / size).round().max(1.0) as usize;
        let place: Vec<Vector<D>> = if D == 2 {
            let around = Disc::new(radius, rings).points;
            around.iter().map(|x| std::array::from_fn(|k| centre[k] + x[k])).collect()
        } else {
            let around = (1..=rings).flat_map(|ring| shell(radius * ring as f64 / rings as f64, ring));
            [[0.0; 3]].into_iter().chain(around).map(|x| std::array::from_fn(|k| centre[k] + x[k])).collect()
        };
        Self::of_points(place)
    }

    /// The convex hull of points, in Delaunay's cells.
    ///
    /// # Errors
    /// More points than can be triangulated.
    pub fn of_points(place: Vec<Vector<D>>) -> Result<Self, delaunay::Error> {
        let ranks: Vec<u32> = (0..place.len() as u32).collect();
        let mut mesh = Delaunay::<D, N>::new();
        let made = mesh.triangulate(&place, &ranks)?;
        Ok(Self { cells: made.cells.clone(), neighbours: made.neighbours.clone(), place })
    }

    /// The nodes below the top of a box at `upper` (m) moved along the last axis, in proportion to their height above
    /// `lower`, so that the top is at `height`.
    pub fn with_surface(mut self, lower: f64, upper: f64, height: impl Fn(&Vector<D>) -> f64) -> Self {
        for x in &mut self.place {
            x[D - 1] = lower + (x[D - 1] - lower) * (height(x) - lower) / (upper - lower);
        }
        self
    }

    /// All of this and of another.
    pub fn join(&mut self, other: Self) {
        let (nodes, cells) = (self.place.len() as u32, self.cells.len() as u32);
        let shift = |by: u32| move |index: u32| if index == OUTSIDE { OUTSIDE } else { index + by };
        self.place.extend(other.place);
        self.cells.extend(other.cells.into_iter().map(|cell| cell.map(shift(nodes))));
        self.neighbours.extend(other.neighbours.into_iter().map(|around| around.map(shift(cells))));
    }

    /// (D! V̄)^{1/D}, V̄ the mean volume of a cell: the edge of the boxes that such cells divide.
    pub fn mean_size(&self) -> f64 {
        let volumes = self.cells.iter().map(|cell| volume_and_gradients(&self.vertices(cell)).0);
        let mean = volumes.sum::<f64>() / self.cells.len() as f64;
        if D == 2 { (2.0 * mean).sqrt() } else { (6.0 * mean).cbrt() }
    }

    /// Corners of a cell (m).
    pub fn vertices(&self, cell: &[u32; N]) -> [Vector<D>; N] {
        cell.map(|node| self.place[node as usize])
    }

    /// The cloud at rest that touches nothing.
    pub fn cloud(self) -> Cloud<D, N> {
        let nodes = self.place.len();
        Cloud {
            velocity: vec![[0.0; D]; nodes],
            pressure: vec![0.0; nodes],
            contacts: vec![Contacts::default(); nodes],
            drop: vec![0.0; nodes],
            birth: (0..nodes as u32).collect(),
            place: self.place,
            cells: self.cells,
            neighbours: self.neighbours,
        }
    }
}

/// Points of a sphere about a `ring`-th of its radius apart, on Fibonacci's spiral: as many as in a lattice of triangles.
fn shell(radius: f64, ring: usize) -> impl Iterator<Item = [f64; 3]> {
    let count = (4.0 * PI * (ring * ring) as f64 / 0.75_f64.sqrt()).round() as usize;
    (0..count).map(move |k| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let angle = PI * (3.0 - 5.0_f64.sqrt()) * k as f64;
        let across = radius * (1.0 - z * z).sqrt();
        [across * angle.cos(), across * angle.sin(), radius * z]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volume<const D: usize, const N: usize>(body: &Body<D, N>) -> f64 {
        body.cells.iter().map(|cell| volume_and_gradients(&body.vertices(cell)).0).sum()
    }

    #[test]
    fn spheres_and_circles_are_filled_to_their_rims() {
        let circle = Body::<2, 3>::of_sphere([1.0, 2.0], 0.5, 0.05).unwrap();
        // A polygon of 60 sides.
        assert!((volume(&circle) - 30.0 * 0.25 * (PI / 30.0).sin()).abs() < 1e-12);
        let ball = Body::<3, 4>::of_sphere([0.0; 3], 1.0, 0.1).unwrap();
        let short = 1.0 - volume(&ball) / (4.0 / 3.0 * PI);
        assert!(short > 0.0 && short < 0.015, "{short}");
        assert!(ball.cells.iter().all(|cell| volume_and_gradients(&ball.vertices(cell)).0 > 0.0));
    }

    #[test]
    fn bodies_joined_keep_their_neighbours() {
        let mut both = Body::<2, 3>::of_box([0.0; 2], [1.0; 2], 0.5).unwrap();
        let other = Body::<2, 3>::of_box([0.0, 2.0], [1.0, 3.0], 0.25).unwrap();
        let (nodes, cells) = (both.place.len() as u32, both.cells.len() as u32);
        both.join(other.clone());
        assert_eq!(both.cells[cells as usize], other.cells[0].map(|node| node + nodes));
        for (cell, around) in both.neighbours.iter().enumerate() {
            for &next in around.iter().filter(|&&next| next != OUTSIDE) {
                assert!(both.neighbours[next as usize].contains(&(cell as u32)));
            }
        }
    }

    #[test]
    fn a_surface_stated_moves_the_nodes_below_it_in_proportion() {
        let tank = Body::<2, 3>::of_box([0.0, 1.0], [1.0, 2.0], 0.25).unwrap();
        let wave = tank.with_surface(1.0, 2.0, |x| 2.0 + 0.5 * x[0]);
        assert!((volume(&wave) - 1.25).abs() < 1e-14);
        assert!(wave.place.contains(&[1.0, 2.5]) && wave.place.contains(&[1.0, 1.75]));
    }
}
