//! Forces and torques, chunk by chunk.

use super::chunk::Chunk;
use crate::lanes::{Kernel, Row8, RowLanes};

/// What one chunk writes in a step; empty between steps.
#[derive(Clone, Debug, Default)]
pub struct ChunkLoads {
    /// `[F 0 | T 0]` by slot.
    pub slots: Vec<Row8>,
    /// The same on each plane, torques about the origin.
    pub planes: Vec<Row8>,
}

impl ChunkLoads {
    /// No load on so many slots and planes.
    pub fn clear(&mut self, slots: usize, planes: usize) {
        self.slots.clear();
        self.slots.resize(slots, Row8::default());
        self.planes.clear();
        self.planes.resize(planes, Row8::default());
    }
}

/// Loads that a chunk puts on rows of a later one.
pub struct Arriving<'a> {
    /// The rows.
    rows: &'a [u32],
    /// Loads on them.
    loads: &'a mut [Row8],
}

impl Arriving<'_> {
    /// Forgets the loads.
    pub fn clear(self) {
        self.loads.fill(Row8::default());
    }
}

/// By chunk: the loads it puts on its own rows, and those that earlier chunks put there, in their order.
pub fn by_target<'a>(
    chunks: &'a [Chunk],
    loads: &'a mut [ChunkLoads],
) -> Vec<(&'a mut [Row8], Vec<Arriving<'a>>)> {
    let mut own = Vec::with_capacity(chunks.len());
    let mut arriving: Vec<Vec<Arriving>> = chunks.iter().map(|_| vec![]).collect();
    for (chunk, loads) in chunks.iter().zip(loads) {
        let (mine, mut behind) = loads.slots.split_at_mut(chunk.rows.len());
        own.push(mine);
        for stretch in &chunk.stretches {
            let (part, rest) = behind.split_at_mut(stretch.slots.len());
            let rows = &chunk.grain_of_slot[stretch.slots.clone()];
            arriving[stretch.target].push(Arriving { rows, loads: part });
            behind = rest;
        }
    }
    own.into_iter().zip(arriving).collect()
}

/// Adds what an earlier chunk puts on rows of a later one; leaves it empty for the next step.
pub struct Join<'a> {
    /// First row of the later chunk.
    pub first: usize,
    /// What arrives.
    pub from: Arriving<'a>,
    /// Loads on the later chunk.
    pub to: &'a mut [Row8],
}

impl Kernel for Join<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: RowLanes>(self) {
        for (&row, load) in self.from.rows.iter().zip(self.from.loads) {
            let load = std::mem::take(&mut load.0);
            let sum = &mut self.to[row as usize - self.first];
            sum.0 = std::array::from_fn(|c| sum.0[c] + load[c]);
        }
    }
}
