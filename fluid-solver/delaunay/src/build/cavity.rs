//! The cavity that a point digs, and the cells that fill it.

use super::mesh::{Cell, Face, GHOST, Mark, Mesh};
use super::ridges::{Reversed, Ridges};
use crate::predicate::{circumsphere, face};

/// A cell to be: from a face of the cavity's rim to the point, which is its last corner.
#[derive(Clone, Copy)]
struct Star<const N: usize> {
    corners: [u32; N],
    outside: Face,
    cell: u32,
    reversed: Reversed<N>,
}

/// Insertion of a point, with the scratch it needs.
#[derive(Default)]
pub struct Cavity<const N: usize> {
    inside: Vec<u32>,
    stars: Vec<Star<N>>,
    ridges: Ridges<N>,
}

impl<const N: usize> Cavity<N> {
    /// Makes room for a mesh of so many points.
    pub fn make_room(&mut self, points: usize) {
        self.ridges.make_room(points);
    }

    /// Inserts a point that conflicts with the cell `seed`; returns a cell, no ghost, of which it is a corner.
    #[inline(always)]
    pub fn insert<const D: usize>(&mut self, mesh: &mut Mesh<D, N>, point: u32, seed: u32) -> u32 {
        self.dig(mesh, point, seed);
        self.fill(mesh);
        self.stars.iter().rev().find(|star| !star.corners.contains(&GHOST)).map_or(seed, |star| star.cell)
    }

    /// Collects the cells that the point conflicts with; they hang together.
    #[inline(always)]
    fn dig<const D: usize>(&mut self, mesh: &mut Mesh<D, N>, point: u32, seed: u32) {
        self.inside.clear();
        self.stars.clear();
        self.inside.push(seed);
        mesh.marks[seed as usize] = Mark::Inside;
        let mut next = 0;
        while let Some(cell) = self.inside.get(next) {
            let Cell { corners, neighbours, .. } = *mesh.cell(*cell);
            next += 1;
            // Asked for at once, so that memory has to be waited for once.
            let origins = neighbours.map(|face| mesh.cell(face.cell()).corners[D]);
            for at in 0..N {
                let outside = neighbours[at];
                let other = outside.cell();
                match mesh.marks[other as usize] {
                    Mark::Inside => continue,
                    Mark::Open if mesh.conflicts_from(origins[at], other, point) => {
                        mesh.marks[other as usize] = Mark::Inside;
                        self.inside.push(other);
                        continue;
                    }
                    _ => mesh.marks[other as usize] = Mark::Outside,
                }
                let corners = face(&corners, at, point);
                self.stars.push(Star { corners, outside, cell: 0, reversed: [0; N] });
            }
        }
    }

    /// Fills the cavity with the cells between its rim and the point.
    #[inline(always)]
    fn fill<const D: usize>(&mut self, mesh: &mut Mesh<D, N>) {
        let Self { inside, stars, ridges } = self;
        ridges.clear();
        for (k, star) in stars.iter_mut().enumerate() {
            star.cell = if k < inside.len() { inside[k] } else { mesh.place() };
            star.reversed = ridges.note(star.cell, star.corners);
        }
        for star in &*stars {
            let mut neighbours = ridges.fellows(&star.reversed);
            neighbours[D] = star.outside;
            let sphere = circumsphere(star.corners.map(|corner| mesh.point(corner)));
            mesh.cells[star.cell as usize] = Cell { corners: star.corners, neighbours, sphere };
            mesh.marks[star.cell as usize] = Mark::Open;
            let outside = star.outside.cell() as usize;
            mesh.cells[outside].neighbours[star.outside.opposite()] = Face::new(star.cell, D);
            mesh.marks[outside] = Mark::Open;
        }
        if ridges.overflow() {
            ridges.join(mesh, stars.iter().map(|star| star.cell));
        }
        for cell in inside.iter().skip(stars.len()) {
            mesh.marks[*cell as usize] = Mark::Free;
            mesh.free.push(*cell);
        }
    }
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Inserts one more point, a place, a rank and a name, near a cell that is no ghost; returns a cell, no ghost, of which
    /// it is a corner, or none if it equals another point.
    pub fn add(&mut self, cavity: &mut Cavity<N>, near: u32, point: ([f64; D], u32, u32)) -> Option<u32> {
        let (place, rank, name) = point;
        let point = self.spare.pop().unwrap_or(self.points.len() as u32);
        if point as usize == self.points.len() {
            self.points.push(place);
            self.ranks.push(rank);
            self.names.push(name);
        } else {
            let at = point as usize;
            (self.points[at], self.ranks[at], self.names[at]) = (place, rank, name);
        }
        cavity.make_room(self.points.len());
        let around = self.find_around(near, &place);
        if self.places(self.cell(around)).contains(&&place) {
            return None;
        }
        Some(cavity.insert(self, point, around))
    }
}
