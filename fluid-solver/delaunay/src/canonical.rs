//! The cells in an order of their own: that of their corners.

use crate::build::{Cell, Mark, Mesh};
use crate::{HULL, Triangulation};

/// Blocks that cells are dealt to on their way to their places.
const BLOCKS: usize = 512;

/// A cell on its way out.
#[derive(Clone, Copy)]
struct Entry<const N: usize> {
    corners: [u32; N],
    /// Where its neighbours are in the mesh.
    neighbours: [u32; N],
    /// Where it is itself.
    slot: u32,
}

/// Copies cells out in an order that does not depend on how they came about.
///
/// Corners rise, but for the last two, which may change places to make the cell positive; cells rise by their corners.
#[derive(Default)]
pub struct Canonical<const N: usize> {
    entries: Vec<Entry<N>>,
    block: Vec<Entry<N>>,
    /// For each point where its cells begin: those that it is the least corner of.
    begin: Vec<u32>,
    number: Vec<u32>,
}

impl<const N: usize> Canonical<N> {
    /// Copies the cells of a mesh of `points` points that are no ghosts.
    pub fn copy<const D: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        points: usize,
        triangulation: &mut Triangulation<N>,
    ) {
        let Self { entries, block, begin, number } = self;
        begin.clear();
        begin.resize(points + 1, 0);
        number.clear();
        number.resize(mesh.cells.len(), HULL);
        let least = |cell: &Cell<N>| {
            cell.corners.iter().fold((u32::MAX, false), |(least, ghost), corner| {
                let name = mesh.names[*corner as usize];
                (least.min(name), ghost | (name == HULL))
            })
        };
        for (slot, cell) in mesh.cells.iter().enumerate() {
            let (least, ghost) = least(cell);
            if !ghost && mesh.marks[slot] != Mark::Free {
                number[slot] = least;
                begin[least as usize + 1] += 1;
            }
        }
        for k in 1..begin.len() {
            begin[k] += begin[k - 1];
        }
        let none = Entry { corners: [HULL; N], neighbours: [HULL; N], slot: HULL };
        entries.clear();
        entries.resize(begin[points] as usize, none);
        // First to blocks of least corners that stay in the cache, then within each.
        let width = points.div_ceil(BLOCKS).max(1);
        let ends = begin.iter().copied().skip(width).step_by(width).chain([begin[points]]);
        let blocks = || begin[..points].iter().copied().step_by(width);
        let mut next: Vec<u32> = blocks().collect();
        let ranges: Vec<_> = blocks().zip(ends).map(|(start, end)| start as usize..end as usize).collect();
        for (slot, cell) in mesh.cells.iter().enumerate().filter(|(slot, _)| number[*slot] != HULL) {
            let next = &mut next[number[slot] as usize / width];
            entries[*next as usize] = Entry::new(mesh, slot, cell);
            *next += 1;
        }
        let Triangulation { cells, neighbours, .. } = triangulation;
        for list in [&mut *cells, &mut *neighbours] {
            list.clear();
            list.reserve(entries.len());
        }
        for (first, range) in (0..points).step_by(width).zip(ranges) {
            let start = range.start;
            block.resize(range.len(), none);
            for entry in &entries[range] {
                let next = &mut begin[entry.corners[0] as usize];
                block[*next as usize - start] = *entry;
                *next += 1;
            }
            let mut group = 0;
            for end in &begin[first..points.min(first + width)] {
                let end = *end as usize - start;
                block[group..end].sort_unstable_by_key(Entry::key);
                group = end;
            }
            cells.extend(block.iter().map(|entry| entry.corners));
            neighbours.extend(block.iter().map(|entry| entry.neighbours));
            for (place, entry) in block.iter().enumerate() {
                number[entry.slot as usize] = (start + place) as u32;
            }
        }
        for slots in neighbours {
            *slots = slots.map(|slot| number[slot as usize]);
        }
    }
}

impl<const N: usize> Entry<N> {
    /// What cells of the same least corner are sorted by: their other corners.
    fn key(&self) -> (u64, u32) {
        (u64::from(self.corners[1]) << 32 | u64::from(self.corners[2]), self.corners[N - 1])
    }

    fn new<const D: usize>(mesh: &Mesh<D, N>, slot: usize, cell: &Cell<N>) -> Self {
        // A corner and the neighbour across from it in one number, in the order of the corners.
        let mut sides: [u64; N] = std::array::from_fn(|k| {
            let corner = mesh.names[cell.corners[k] as usize];
            u64::from(corner) << 32 | u64::from(cell.neighbours[k].cell())
        });
        // Insertion that always goes to the end, for a branch would be taken by chance.
        let mut odd = false;
        for end in 1..N {
            for k in (1..=end).rev() {
                let (a, b) = (sides[k - 1], sides[k]);
                odd ^= a > b;
                (sides[k - 1], sides[k]) = (a.min(b), a.max(b));
            }
        }
        // An even number of exchanges leaves the cell positive.
        let (a, b) = (sides[N - 2], sides[N - 1]);
        (sides[N - 2], sides[N - 1]) = if odd { (b, a) } else { (a, b) };
        let (corners, neighbours) = (sides.map(|side| (side >> 32) as u32), sides.map(|side| side as u32));
        Self { corners, neighbours, slot: slot as u32 }
    }
}
