//! The cavity that a point digs, and the cells that fill it.

use super::mesh::{Cell, Face, GHOST, Mark, Mesh};
use super::ridges::Ridges;

/// A face of the cavity's rim and the point: the cell to be.
#[derive(Clone, Copy)]
struct Rim<const N: usize> {
    corners: [u32; N],
    /// Which corner is the point.
    at: usize,
    outside: Face,
}

/// Insertion of a point, with the scratch it needs.
#[derive(Default)]
pub struct Cavity<const N: usize> {
    inside: Vec<u32>,
    rim: Vec<Rim<N>>,
    ridges: Ridges<N>,
}

impl<const N: usize> Cavity<N> {
    /// Makes ready for a mesh of so many points.
    pub fn reset(&mut self, points: usize) {
        self.ridges.reset(points);
    }

    /// Inserts a point that conflicts with the cell `seed`; returns a cell, no ghost, of which it is a corner.
    #[inline(always)]
    pub fn insert<const D: usize>(&mut self, mesh: &mut Mesh<D, N>, point: u32, seed: u32) -> u32 {
        self.dig(mesh, point, seed);
        self.fill(mesh)
    }

    /// Collects the cells that the point conflicts with; they hang together.
    #[inline(always)]
    fn dig<const D: usize>(&mut self, mesh: &mut Mesh<D, N>, point: u32, seed: u32) {
        self.inside.clear();
        self.rim.clear();
        self.inside.push(seed);
        mesh.marks[seed as usize] = Mark::Inside;
        let mut next = 0;
        while let Some(cell) = self.inside.get(next) {
            let this = *mesh.cell(*cell);
            next += 1;
            for at in 0..N {
                let outside = this.neighbours[at];
                let other = outside.cell() as usize;
                match mesh.marks[other] {
                    Mark::Inside => continue,
                    Mark::Open if mesh.conflicts(other as u32, point) => {
                        mesh.marks[other] = Mark::Inside;
                        self.inside.push(other as u32);
                        continue;
                    }
                    _ => mesh.marks[other] = Mark::Outside,
                }
                let mut corners = this.corners;
                corners[at] = point;
                self.rim.push(Rim { corners, at, outside });
            }
        }
    }

    /// Fills the cavity with the cells between its rim and the point.
    #[inline(always)]
    fn fill<const D: usize>(&mut self, mesh: &mut Mesh<D, N>) -> u32 {
        let mut real = 0;
        self.ridges.clear();
        for (k, rim) in self.rim.iter().enumerate() {
            let cell = if k < self.inside.len() { self.inside[k] } else { mesh.place() };
            let mut neighbours = [Face::default(); N];
            neighbours[rim.at] = rim.outside;
            mesh.cells[cell as usize] = Cell { corners: rim.corners, neighbours };
            mesh.marks[cell as usize] = Mark::Open;
            let outside = &mut mesh.cells[rim.outside.cell() as usize];
            outside.neighbours[rim.outside.opposite()] = Face::new(cell, rim.at);
            mesh.marks[rim.outside.cell() as usize] = Mark::Open;
            self.ridges.add(cell, rim.corners, rim.at);
            if !rim.corners.contains(&GHOST) {
                real = cell;
            }
        }
        for cell in self.inside.iter().skip(self.rim.len()) {
            mesh.marks[*cell as usize] = Mark::Free;
            mesh.free.push(*cell);
        }
        self.ridges.join(mesh);
        real
    }
}
