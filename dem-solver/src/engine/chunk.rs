//! Successive grains whose pairs are worked on together.

use std::ops::Range;

use super::block::{ConstantsBlock, ExtrasBlock, PairBlock, WIDTH};
use super::constants::Alike;
use super::near_planes::{NearPlanes, PlaneSpring};
use super::springs::Springs;
use super::wall_contact::{Candidate, WallContact};
use crate::contact::{Coefficients, History, Remembered};

/// Grains per chunk, at least and at most.
const SMALLEST: usize = 1024;
const LARGEST: usize = 8192;
/// Chunks aimed at between these bounds.
const AIM: usize = 8;

/// The rows of each chunk: they follow from the number of grains alone, so that sums do not depend on the number
/// of threads.
pub fn ranges(grains: usize) -> impl Iterator<Item = Range<usize>> {
    let size = grains.div_ceil(AIM).clamp(SMALLEST, LARGEST);
    (0..grains).step_by(size).map(move |first| first..grains.min(first + size))
}

/// The contacts of successive grains with later grains and with walls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chunk {
    /// Its grains.
    pub rows: Range<usize>,
    /// The grain of each slot of the chunk's loads: its own rows, then those of later chunks that its pairs load,
    /// ascending.
    pub grain_of_slot: Vec<u32>,
    /// Its slots behind its own rows, by the chunk they lie in.
    pub stretches: Vec<Stretch>,
    /// Pairs within the outer skin, ascending in the first grain.
    pub outer: OuterPairs,
    /// Pairs within the inner gap, in the order of the outer ones.
    pub inner: InnerPairs,
    /// Springs on their way from the last outer list to the next, ascending in both grains.
    pub remembered: Vec<Remembered>,
    /// Grains that only planes at rest are near.
    pub planes: NearPlanes,
    /// Their springs on the way from the last list to the next, ascending in the grain.
    pub plane_springs: Vec<PlaneSpring>,
    /// The other grains near walls, ascending in the grain.
    pub candidates: Vec<Candidate>,
    /// Those of them that touched in the last step, ascending in the grain.
    pub wall_contacts: Vec<WallContact>,
}

/// Pairs within the outer skin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OuterPairs {
    /// Row of the first grain.
    pub i: Vec<u32>,
    /// Slot of the second.
    pub slot: Vec<u32>,
}

/// Pairs within the inner gap, in blocks; the last block is filled up with pairs of a grain and itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InnerPairs {
    /// Which of the outer pairs each is.
    pub source: Vec<u32>,
    /// Who they are.
    pub blocks: Vec<PairBlock>,
    /// What they remember; empty without friction.
    pub springs: Springs,
    /// Their constants; empty where all pairs are alike.
    pub constants: Vec<ConstantsBlock>,
    /// Constants of their laws besides normal and tangential force; empty without such.
    pub extras: Vec<ExtrasBlock>,
}

impl InnerPairs {
    /// The springs of all pairs, if contacts remember.
    pub fn all_springs(&self) -> impl Iterator<Item = History> {
        let count = if self.springs.is_empty() { 0 } else { self.source.len() };
        (0..count).map(|k| self.springs.get(k))
    }

    /// Sets the springs of the pairs, in their order.
    pub fn set_springs(&mut self, springs: impl Iterator<Item = History>) {
        for (k, spring) in springs.enumerate() {
            self.springs.set(k, &spring);
        }
    }

    /// Rows and constants of all pairs; `alike` if the scene has them.
    pub fn pairs(&self, alike: Option<&Alike>) -> impl Iterator<Item = (usize, usize, Coefficients)> {
        (0..self.source.len()).map(move |k| {
            let (block, lane) = (k / WIDTH, k % WIDTH);
            let PairBlock { i, j, .. } = &self.blocks[block];
            let coefficients =
                alike.map_or_else(|| self.constants[block].coefficients(lane), |alike| alike.coefficients);
            (i[lane] as usize, j[lane] as usize, coefficients)
        })
    }
}

impl Chunk {
    /// The grains `rows`, without contacts.
    pub fn new(rows: Range<usize>) -> Self {
        let grain_of_slot = (rows.start as u32..rows.end as u32).collect();
        Self { rows, grain_of_slot, ..Self::default() }
    }

    /// Clears the lists; springs that are loaded are kept for the next ones.
    pub fn stow(&mut self) {
        self.stow_pairs();
        self.stow_planes();
        self.candidates.clear();
    }

    /// Clears the lists of pairs.
    pub fn stow_pairs(&mut self) {
        let InnerPairs { source, blocks, springs, constants, extras } = &mut self.inner;
        for pair in 0..source.len() {
            let spring = springs.get(pair);
            if spring.is_active() {
                let (block, lane) = (&blocks[pair / WIDTH], pair % WIDTH);
                self.remembered.push(Remembered { i: block.i[lane], j: block.j[lane], spring });
            }
        }
        source.clear();
        blocks.clear();
        springs.clear();
        constants.clear();
        extras.clear();
        self.outer.i.clear();
        self.outer.slot.clear();
    }

    /// Clears the list of grains near planes.
    pub fn stow_planes(&mut self) {
        self.plane_springs.extend(self.planes.loaded());
        self.planes.clear();
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.rows = other.rows.clone();
        self.grain_of_slot.clone_from(&other.grain_of_slot);
        self.stretches.clone_from(&other.stretches);
        self.outer.i.clone_from(&other.outer.i);
        self.outer.slot.clone_from(&other.outer.slot);
        self.inner.source.clone_from(&other.inner.source);
        self.inner.blocks.clone_from(&other.inner.blocks);
        self.inner.springs.copy_from(&other.inner.springs);
        self.inner.constants.clone_from(&other.inner.constants);
        self.inner.extras.clone_from(&other.inner.extras);
        self.remembered.clone_from(&other.remembered);
        self.planes.copy_from(&other.planes);
        self.plane_springs.clone_from(&other.plane_springs);
        self.candidates.clone_from(&other.candidates);
        self.wall_contacts.clone_from(&other.wall_contacts);
    }
}

/// A stretch of a chunk's slots that lies in a later chunk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stretch {
    /// The later chunk.
    pub target: usize,
    /// The slots.
    pub slots: Range<usize>,
}

/// Finds for each chunk the stretches of its slots that lie in later chunks.
pub fn find_stretches(chunks: &mut [Chunk]) {
    let ends: Vec<usize> = chunks.iter().map(|chunk| chunk.rows.end).collect();
    for chunk in chunks {
        chunk.stretches.clear();
        let mut begin = chunk.rows.len();
        for (target, &end_row) in ends.iter().enumerate() {
            let behind = &chunk.grain_of_slot[begin..];
            let end = begin + behind.partition_point(|&row| (row as usize) < end_row);
            if begin < end {
                chunk.stretches.push(Stretch { target, slots: begin..end });
            }
            begin = end;
        }
    }
}
