//! A box parallel to the axes.

use super::jitter::Jitter;
use super::{assemble, at_least, count_points, positive};
use crate::element::simplex::Vector;
use crate::mesh::bins::for_each_index;
use crate::mesh::{Mesh, MeshError, PeriodicPairs};

const NAME: &str = "box mesh";

/// A box of `cells` bricks per axis, each cut into `D!` simplices around its diagonal from lower to upper corner
/// (Kuhn 1960): two triangles or six tetrahedra.
///
/// All diagonals point the same way, so faces of adjacent bricks and of periodic sides conform for any number of cells.
/// Boundaries: `x-min`, `x-max`, `y-min`, …, but for periodic axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxMesh<const D: usize> {
    /// Lower corner (m).
    pub lower: Vector<D>,
    /// Upper corner (m).
    pub upper: Vector<D>,
    /// Bricks along each axis; at least three along a periodic one.
    pub cells: [usize; D],
    /// Which axes are periodic.
    pub periodic: [bool; D],
    /// Displacement of the inner nodes, for irregular meshes.
    pub jitter: Option<Jitter>,
}

impl<const D: usize> BoxMesh<D> {
    /// Generates the mesh; points are numbered with axis 0 fastest.
    ///
    /// # Errors
    /// An extent that is not positive, no cells, too few cells along a periodic axis, or too many points.
    pub fn generate<const N: usize>(&self) -> Result<Mesh<D, N>, MeshError> {
        const { assert!(N == D + 1 && (D == 2 || D == 3)) };
        self.check()?;
        let lattice: [usize; D] = self.cells.map(|n| n + 1);
        let mut points = self.points(&lattice)?;
        let cells = self.cells(&lattice);
        if let Some(jitter) = &self.jitter {
            let brick = (0..D)
                .map(|k| (self.upper[k] - self.lower[k]) / self.cells[k] as f64)
                .fold(f64::INFINITY, f64::min);
            let inner =
                |point: usize| (0..D).all(|k| (1..self.cells[k]).contains(&coordinate(&lattice, point, k)));
            jitter.apply(&mut points, &cells, brick, inner)?;
        }
        let axes = ["x", "y", "z"];
        let sides = (0..D).filter(|&k| !self.periodic[k]).flat_map(|k| [(k, 0), (k, self.cells[k])]);
        let sides: Vec<(usize, usize)> = sides.collect();
        let groups = sides
            .iter()
            .map(|&(k, at)| format!("{}-{}", axes[k], if at == 0 { "min" } else { "max" }))
            .collect();
        let periodic = (0..D).filter(|&k| self.periodic[k]).map(|k| self.pairs(&lattice, k)).collect();
        assemble(points, cells, groups, periodic, |face| {
            let on =
                |&(k, at): &(usize, usize)| face.iter().all(|&p| coordinate(&lattice, p as usize, k) == at);
            sides.iter().position(on).map(|side| side as u32)
        })
    }

    fn check(&self) -> Result<(), MeshError> {
        for k in 0..D {
            positive(NAME, "upper - lower", self.upper[k] - self.lower[k])?;
            let (least, allowed) =
                if self.periodic[k] { (3, "at least 3 along a periodic axis") } else { (1, "at least 1") };
            at_least(NAME, "cells", least, self.cells[k], allowed)?;
        }
        Ok(())
    }

    fn points(&self, lattice: &[usize; D]) -> Result<Vec<Vector<D>>, MeshError> {
        let at = |index: usize, k: usize| {
            let t = index as f64 / self.cells[k] as f64;
            (1.0 - t) * self.lower[k] + t * self.upper[k]
        };
        let count = count_points(NAME, lattice)?;
        Ok((0..count).map(|point| std::array::from_fn(|k| at(coordinate(lattice, point, k), k))).collect())
    }

    fn cells<const N: usize>(&self, lattice: &[usize; D]) -> Vec<[u32; N]> {
        let paths = permutations::<D>();
        let mut cells = Vec::with_capacity(paths.len() * self.cells.iter().product::<usize>());
        for_each_index(&[0; D], &self.cells.map(|n| n - 1), |brick| {
            for (path, even) in &paths {
                let mut corner = *brick;
                let mut cell: [u32; N] = [number(lattice, &corner); N];
                for k in 0..D {
                    corner[path[k]] += 1;
                    cell[k + 1] = number(lattice, &corner);
                }
                if !even {
                    cell.swap(N - 2, N - 1);
                }
                cells.push(cell);
            }
        });
        cells
    }

    fn pairs(&self, lattice: &[usize; D], axis: usize) -> PeriodicPairs {
        let mut high = self.cells;
        high[axis] = 0;
        let mut pairs = Vec::new();
        for_each_index(&[0; D], &high, |master| {
            let mut image = *master;
            image[axis] = self.cells[axis];
            pairs.push((number(lattice, &image), number(lattice, master)));
        });
        PeriodicPairs { axis, pairs }
    }
}

fn number<const D: usize>(lattice: &[usize; D], index: &[usize; D]) -> u32 {
    (0..D).rev().fold(0, |number, k| number * lattice[k] + index[k]) as u32
}

fn coordinate<const D: usize>(lattice: &[usize; D], point: usize, axis: usize) -> usize {
    point / lattice[..axis].iter().product::<usize>() % lattice[axis]
}

/// All orders of the axes, and whether each is an even permutation.
fn permutations<const D: usize>() -> Vec<([usize; D], bool)> {
    let codes = 0..D.pow(D as u32);
    let orders = codes.map(|code| std::array::from_fn(|k| code / D.pow(k as u32) % D));
    let complete = orders.filter(|order: &[usize; D]| (0..D).all(|axis| order.contains(&axis)));
    let inversions = |order: &[usize; D]| {
        (0..D).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| order[j] > order[i]).count()
    };
    complete.map(|order| (order, inversions(&order) % 2 == 0)).collect()
}
