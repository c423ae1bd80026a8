//! Which of the cells that fill a cavity are neighbours: those that share a ridge of its rim.

use super::mesh::{Face, Mesh};
use crate::predicate::FACE;

/// A rim of up to so many corners is joined by a table.
const MOST: usize = 64;

/// A new cell: the numbers of its corners on the rim, and which corner is the point.
#[derive(Clone, Copy)]
struct Star<const N: usize> {
    cell: u32,
    at: usize,
    numbers: [u32; N],
}

impl<const N: usize> Star<N> {
    /// The ridge on the face opposite to a corner, as this cell sees it: in space a pair of corners, in the plane a corner
    /// and a sense. The cell on the other side of the face sees the reversed pair.
    #[inline(always)]
    fn ridge(&self, opposite: usize) -> [usize; 2] {
        if N == 3 {
            let corner = self.numbers[3 - self.at - opposite] as usize;
            if (self.at + 1) % 3 == opposite { [corner, MOST - 1] } else { [MOST - 1, corner] }
        } else {
            // The face opposite to the point, turned so that it begins with the other corner.
            let face = FACE[self.at];
            let begin = face.iter().position(|k| *k == opposite).unwrap_or(0);
            [1, 2].map(|k| self.numbers[face[(begin + k) % 3]] as usize)
        }
    }

    /// Corners that are not the point.
    fn others(&self) -> impl Iterator<Item = usize> + use<N> {
        let at = self.at;
        (0..N).filter(move |k| *k != at)
    }
}

/// Ridges of a rim and the new faces on them.
///
/// Two new faces meet in every ridge and see it in opposite senses. So each notes itself in a table under the ridge as it
/// sees it and looks its fellow up under the reversed one (Marot, Pellerin & Remacle 2019); what the table held before is
/// never read.
pub struct Ridges<const N: usize> {
    /// For each point the number that it has on this rim plus `first`; less than `first` if it has none.
    number: Vec<u32>,
    first: u32,
    count: u32,
    stars: Vec<Star<N>>,
    table: Box<[[Face; MOST]; MOST]>,
    list: Vec<([usize; 2], Face)>,
}

impl<const N: usize> Default for Ridges<N> {
    fn default() -> Self {
        let table = Box::new([[Face::default(); MOST]; MOST]);
        Self { number: vec![], first: 1, count: 0, stars: vec![], table, list: vec![] }
    }
}

impl<const N: usize> Ridges<N> {
    /// Makes ready for a mesh of so many points.
    pub fn reset(&mut self, points: usize) {
        self.number.clear();
        self.number.resize(points, 0);
        (self.first, self.count) = (1, 0);
    }

    /// Begins a new rim.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.stars.clear();
        self.first += self.count;
        self.count = 0;
        if self.first > u32::MAX / 2 {
            self.number.fill(0);
            self.first = 1;
        }
    }

    /// Adds a new cell whose corner `at` is the point.
    #[inline(always)]
    pub fn add(&mut self, cell: u32, corners: [u32; N], at: usize) {
        let mut star = Star { cell, at, numbers: [0; N] };
        for k in star.others() {
            let number = &mut self.number[corners[k] as usize];
            if *number < self.first {
                *number = self.first + self.count;
                self.count += 1;
            }
            star.numbers[k] = *number - self.first;
        }
        self.stars.push(star);
    }

    /// Makes the new cells neighbours across the faces that they share.
    #[inline(always)]
    pub fn join<const D: usize>(&mut self, mesh: &mut Mesh<D, N>) {
        if self.count as usize >= MOST {
            return self.join_many(mesh);
        }
        for star in &self.stars {
            for k in star.others() {
                let [a, b] = star.ridge(k);
                self.table[a][b] = Face::new(star.cell, k);
            }
        }
        for star in &self.stars {
            for k in star.others() {
                let [a, b] = star.ridge(k);
                mesh.cells[star.cell as usize].neighbours[k] = self.table[b][a];
            }
        }
    }

    /// The same for a rim of many corners: sorting brings the two faces on a ridge together.
    #[cold]
    fn join_many<const D: usize>(&mut self, mesh: &mut Mesh<D, N>) {
        self.list.clear();
        for star in &self.stars {
            self.list.extend(star.others().map(|k| {
                let [a, b] = star.ridge(k);
                ([a.min(b), a.max(b)], Face::new(star.cell, k))
            }));
        }
        self.list.sort_unstable_by_key(|(ridge, _)| *ridge);
        for pair in self.list.chunks_exact(2) {
            mesh.join(pair[0].1, pair[1].1);
        }
    }
}
