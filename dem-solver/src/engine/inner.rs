//! The inner list: those of the outer pairs that nearly touch, in blocks, with what they remember.

use super::block::{ConstantsBlock, ExtrasBlock, PairBlock, WIDTH};
use super::chunk::{Chunk, InnerPairs, OuterPairs};
use super::constants::{extras_of_pair, of_pair};
use super::outer::low_bits;
use super::periods::Periods;
use super::springs::{Memory, Springs};
use crate::contact::Remembered;
use crate::grains::{AsRows, Grains};
use crate::lanes::{Backend, Kernel, Row4, RowLanes, Vec3};
use crate::scene::Scene;

/// How a chunk's inner list is made.
pub struct Refresh<'a, const D: usize> {
    /// Laws and materials.
    pub scene: &'a Scene<D>,
    /// The grains.
    pub grains: &'a Grains,
    /// Periodic axes.
    pub periods: &'a Periods,
    /// Gap below which pairs are listed \[m\].
    pub gap: f64,
    /// Whether all pairs are alike.
    pub alike: bool,
}

impl<const D: usize> Refresh<'_, D> {
    /// Picks the inner pairs anew; springs stay with their pairs, or come from `remembered` after a new outer list.
    pub fn run(&self, backend: Backend, chunk: &mut Chunk) {
        let old = std::mem::take(&mut chunk.inner);
        let mut source = Vec::with_capacity(old.source.len() + old.source.len() / 8);
        backend.run(Near {
            places: self.grains.place.as_rows(),
            outer: &chunk.outer,
            grain_of_slot: &chunk.grain_of_slot,
            periods: self.periods,
            gap: self.gap,
            near: &mut source,
        });
        chunk.inner = InnerPairs { source, ..InnerPairs::default() };
        self.complete(chunk);
        if !chunk.inner.springs.is_empty() {
            carry(&old, &mut chunk.inner);
            recall(&chunk.remembered, &mut chunk.inner);
        }
        chunk.remembered.clear();
    }

    /// Finds what follows from the choice of pairs: who they are, their constants; no spring is loaded.
    pub fn complete(&self, chunk: &mut Chunk) {
        let blocks = pair_blocks(chunk);
        (chunk.inner.constants, chunk.inner.extras) = self.constants(&blocks);
        chunk.inner.springs = Springs::relaxed(Memory::of(self.scene), blocks.len());
        chunk.inner.blocks = blocks;
    }

    fn constants(&self, blocks: &[PairBlock]) -> (Vec<ConstantsBlock>, Vec<ExtrasBlock>) {
        if self.alike {
            return (vec![], vec![]);
        }
        let with_extras = if self.scene.extras.any() { blocks.len() } else { 0 };
        let mut constants = vec![ConstantsBlock::default(); blocks.len()];
        let mut extras = vec![ExtrasBlock::default(); with_extras];
        for (k, block) in blocks.iter().enumerate() {
            for lane in 0..WIDTH {
                let (i, j) = (block.i[lane] as usize, block.j[lane] as usize);
                let Some((radii, coefficients)) = of_pair(self.scene, self.grains, i, j) else { continue };
                constants[k].set(lane, radii, &coefficients);
                if let Some(extras) = extras.get_mut(k) {
                    extras.set(lane, &extras_of_pair(self.scene, self.grains, (i, j), &coefficients));
                }
            }
        }
        (constants, extras)
    }
}

/// The inner pairs in blocks.
fn pair_blocks(chunk: &Chunk) -> Vec<PairBlock> {
    let first = chunk.rows.start as u32;
    let block = |pairs: &[u32]| {
        let mut block =
            PairBlock { i: [first; WIDTH], j: [first; WIDTH], slot_i: [0; WIDTH], slot_j: [0; WIDTH] };
        for (lane, &pair) in pairs.iter().enumerate() {
            let (i, slot) = (chunk.outer.i[pair as usize], chunk.outer.slot[pair as usize]);
            block.i[lane] = i;
            block.slot_i[lane] = i - first;
            block.j[lane] = chunk.grain_of_slot[slot as usize];
            block.slot_j[lane] = slot;
        }
        block
    };
    chunk.inner.source.chunks(WIDTH).map(block).collect()
}

/// Carries springs from the old inner list to the new one; both ascend in the outer pair.
fn carry(old: &InnerPairs, new: &mut InnerPairs) {
    let mut from = 0;
    for (to, pair) in new.source.iter().enumerate() {
        while from < old.source.len() && old.source[from] < *pair {
            from += 1;
        }
        if from < old.source.len() && old.source[from] == *pair {
            new.springs.set(to, &old.springs.get(from));
        }
    }
}

/// Gives the springs of the last outer list to the pairs of this one; both ascend in the first grain.
fn recall(remembered: &[Remembered], pairs: &mut InnerPairs) {
    let mut left = remembered;
    if left.is_empty() {
        return;
    }
    for to in 0..pairs.source.len() {
        let (block, lane) = (to / WIDTH, to % WIDTH);
        let (i, j) = (pairs.blocks[block].i[lane], pairs.blocks[block].j[lane]);
        while left.first().is_some_and(|entry| entry.i < i) {
            left = &left[1..];
        }
        let of_grain = left.iter().take_while(|entry| entry.i == i);
        if let Some(entry) = of_grain.into_iter().find(|entry| entry.j == j) {
            pairs.springs.set(to, &entry.spring);
        }
    }
}

/// Finds the outer pairs whose gap is below a bound.
struct Near<'a> {
    places: &'a [Row4],
    outer: &'a OuterPairs,
    grain_of_slot: &'a [u32],
    periods: &'a Periods,
    gap: f64,
    near: &'a mut Vec<u32>,
}

impl Kernel for Near<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: RowLanes>(self) {
        let Self { places, outer, grain_of_slot, periods, gap, near } = self;
        for begin in (0..outer.i.len()).step_by(WIDTH) {
            let count = WIDTH.min(outer.i.len() - begin);
            let (mut i, mut j) = ([outer.i[begin]; WIDTH], [outer.i[begin]; WIDTH]);
            for k in 0..count {
                i[k] = outer.i[begin + k];
                j[k] = grain_of_slot[outer.slot[begin + k] as usize];
            }
            let mut bits = 0;
            for lane in (0..WIDTH).step_by(L::WIDTH) {
                // SAFETY: the rows of outer pairs are rows of the grains.
                let (a, b) = unsafe { (L::columns4(places, &i[lane..]), L::columns4(places, &j[lane..])) };
                let separation = Vec3::new(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
                let reach = a[3] + b[3] + L::splat(gap);
                let close = periods.nearest(separation).norm_squared().less(reach * reach);
                bits |= L::bits(close) << lane;
            }
            bits &= low_bits(count);
            while bits != 0 {
                near.push(begin as u32 + bits.trailing_zeros());
                bits &= bits - 1;
            }
        }
    }
}
