//! Which of the cells that fill a cavity are neighbours: those that share a ridge of its rim.

use super::mesh::{Face, Mesh};

/// A rim of up to so many corners is joined by a table.
const MOST: usize = 64;

/// Where the table holds the faces that no ridge leads to.
const NOWHERE: u16 = 0;

/// Ridges of a rim and the new faces on them. The point is the last corner of every new cell.
///
/// Two new faces meet in every ridge and see it in opposite senses. So each notes itself in a table under the ridge as it
/// sees it and looks its fellow up under the reversed one (Marot, Pellerin & Remacle 2019); what the table held before is
/// never read.
pub struct Ridges<const N: usize> {
    /// For each point the number that it has on this rim plus `first`; less than `first` if it has none.
    number: Vec<u32>,
    first: u32,
    count: u32,
    table: Box<[Face; MOST * MOST]>,
    list: Vec<([u32; 2], Face)>,
}

impl<const N: usize> Default for Ridges<N> {
    fn default() -> Self {
        Self {
            number: vec![],
            first: 1,
            count: 0,
            table: Box::new([Face::default(); MOST * MOST]),
            list: vec![],
        }
    }
}

/// Ridges of a new cell opposite to each of its corners, reversed.
pub type Reversed<const N: usize> = [u16; N];

impl<const N: usize> Ridges<N> {
    /// Makes room for a mesh of so many points.
    pub fn make_room(&mut self, points: usize) {
        if self.number.len() < points {
            self.number.resize(points, 0);
        }
    }

    /// Begins a new rim.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.first += self.count;
        self.count = 0;
        if self.first > u32::MAX / 2 {
            self.number.fill(0);
            self.first = 1;
        }
    }

    /// Whether the rim has more corners than the table has numbers.
    #[inline(always)]
    pub fn overflow(&self) -> bool {
        self.count as usize >= MOST
    }

    /// Number of a corner on this rim.
    #[inline(always)]
    fn number(&mut self, corner: u32) -> usize {
        let number = &mut self.number[corner as usize];
        if *number < self.first {
            *number = self.first + self.count;
            self.count += 1;
        }
        (*number - self.first) as usize
    }

    /// Notes the faces of a new cell; returns where their fellows will be noted.
    #[inline(always)]
    pub fn note(&mut self, cell: u32, corners: [u32; N]) -> Reversed<N> {
        let ridges = if N == 3 {
            // A corner and a sense.
            let (a, b) = (self.number(corners[0]) + 1, self.number(corners[1]) + 1);
            [[b, 0], [0, a], [0, 0]]
        } else {
            let (a, b, c) = (self.number(corners[0]), self.number(corners[1]), self.number(corners[2]));
            [[b, c], [c, a], [a, b]]
        };
        let mut reversed = [NOWHERE; N];
        for k in 0..N - 1 {
            let [a, b] = ridges[k];
            self.table[(a * MOST + b) % (MOST * MOST)] = Face::new(cell, k);
            reversed[k] = ((b * MOST + a) % (MOST * MOST)) as u16;
        }
        reversed
    }

    /// What was noted there.
    #[inline(always)]
    pub fn fellows(&self, reversed: &Reversed<N>) -> [Face; N] {
        let mut fellows = [Face::default(); N];
        for k in 0..N - 1 {
            fellows[k] = self.table[usize::from(reversed[k]) % (MOST * MOST)];
        }
        fellows
    }

    /// Makes new cells neighbours if the rim has too many corners for the table: sorting brings the two faces on a ridge
    /// together.
    #[cold]
    pub fn join<const D: usize>(&mut self, mesh: &mut Mesh<D, N>, cells: impl Iterator<Item = u32>) {
        self.list.clear();
        for cell in cells {
            let corners = mesh.cell(cell).corners;
            for k in 0..D {
                let mut ridge = (0..D).filter(|other| *other != k).map(|other| corners[other]);
                let [a, b] = [0, 1].map(|_| ridge.next().unwrap_or(u32::MAX));
                self.list.push(([a.min(b), a.max(b)], Face::new(cell, k)));
            }
        }
        self.list.sort_unstable_by_key(|(ridge, _)| *ridge);
        for pair in self.list.chunks_exact(2) {
            mesh.join(pair[0].1, pair[1].1);
        }
    }
}
