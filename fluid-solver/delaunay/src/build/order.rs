//! The order in which points are inserted: random rounds of eightfold size, along a Hilbert curve inside a round.

use crate::points::bounds;

/// Points of one stretch of the curve are sorted by their coordinates if they are no more than this.
const FEW: usize = 24;

/// Order of insertion, and the points that equal others.
#[derive(Default)]
pub struct Order {
    /// Indices of the points that are unlike all others, in the order of insertion.
    pub points: Vec<u32>,
    /// Points left out because they equal another, and which: `[left out, kept]`.
    pub twins: Vec<[u32; 2]>,
    curve: Vec<u32>,
    keys: Vec<u64>,
}

impl Order {
    /// Orders points. The order depends on the points alone, not on earlier calls.
    pub fn sort<const D: usize>(&mut self, points: &[[f64; D]], rank: &[u32]) {
        self.curve.clear();
        self.curve.extend(0..points.len() as u32);
        self.keys.clear();
        self.keys.resize(points.len(), 0);
        along_curve(points, &mut self.curve, &mut self.keys);
        self.twins.clear();
        drop_twins(points, rank, &mut self.curve, &mut self.twins);
        self.in_rounds();
    }

    /// Deals the points along the curve out to rounds, the smallest round first.
    fn in_rounds(&mut self) {
        let rounds = self.curve.len().max(1).ilog2() / 3 + 1;
        let round = |place: usize| {
            let random = (place as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let random = (random ^ (random >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            rounds - 1 - (random >> 32).trailing_zeros().min(3 * (rounds - 1)) / 3
        };
        let mut next = vec![0; rounds as usize + 1];
        for place in 0..self.curve.len() {
            next[round(place) as usize + 1] += 1;
        }
        for k in 1..next.len() {
            next[k] += next[k - 1];
        }
        self.points.clear();
        self.points.resize(self.curve.len(), 0);
        for (place, point) in self.curve.iter().enumerate() {
            let next = &mut next[round(place) as usize];
            self.points[*next] = *point;
            *next += 1;
        }
    }
}

/// Sorts `some` of the points along a Hilbert curve through their own box; many points in one stretch of it get a curve of
/// their own. Equal points become neighbours.
fn along_curve<const D: usize>(points: &[[f64; D]], some: &mut [u32], keys: &mut [u64]) {
    let (low, high) = bounds(some.iter().map(|point| points[*point as usize]));
    let extent = (0..D).fold(0.0, |extent: f64, k| extent.max(high[k] - low[k]));
    if some.len() <= FEW || extent == 0.0 {
        some.sort_unstable_by(|a, b| {
            lexicographic(&points[*a as usize], &points[*b as usize]).then(a.cmp(b))
        });
        return;
    }
    // About 2^D stretches per point.
    let bits = (some.len().ilog2() / D as u32 + 2).min(32 / D as u32);
    let scale = f64::from((1u32 << bits) - 1) / extent;
    for (key, point) in keys.iter_mut().zip(&*some) {
        let x = &points[*point as usize];
        let cell = std::array::from_fn::<u32, D, _>(|k| ((x[k] - low[k]) * scale) as u32);
        *key = hilbert(cell, bits) << 32 | u64::from(*point);
    }
    keys.sort_unstable();
    for (point, key) in some.iter_mut().zip(&*keys) {
        *point = *key as u32;
    }
    let mut start = 0;
    while start < some.len() {
        let length = keys[start..].iter().take_while(|key| **key >> 32 == keys[start] >> 32).count();
        if length > 1 {
            // The keys of this stretch are read no more.
            along_curve(points, &mut some[start..start + length], &mut keys[start..start + length]);
        }
        start += length;
    }
}

/// Place of a cell of the grid of 2^`bits` cells a side on the Hilbert curve (Skilling 2004).
fn hilbert<const D: usize>(mut cell: [u32; D], bits: u32) -> u64 {
    for bit in (1..bits).rev() {
        let (top, below) = (1 << bit, (1 << bit) - 1);
        for k in 0..D {
            if cell[k] & top != 0 {
                cell[0] ^= below;
            } else {
                let swapped = (cell[0] ^ cell[k]) & below;
                cell[0] ^= swapped;
                cell[k] ^= swapped;
            }
        }
    }
    for k in 1..D {
        cell[k] ^= cell[k - 1];
    }
    let mut flipped = 0;
    for bit in 1..bits {
        if cell[D - 1] >> bit & 1 != 0 {
            flipped ^= (1 << bit) - 1;
        }
    }
    let mut place = 0;
    for bit in (0..bits).rev() {
        for k in 0..D {
            place = place << 1 | u64::from((cell[k] ^ flipped) >> bit & 1);
        }
    }
    place
}

fn lexicographic<const D: usize>(a: &[f64; D], b: &[f64; D]) -> std::cmp::Ordering {
    a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal)
}

/// Takes every point out of the curve that equals one of lower rank.
fn drop_twins<const D: usize>(
    points: &[[f64; D]],
    rank: &[u32],
    curve: &mut Vec<u32>,
    twins: &mut Vec<[u32; 2]>,
) {
    curve.dedup_by(|point, kept| {
        let equal = points[*point as usize] == points[*kept as usize];
        if equal {
            if (rank[*point as usize], *point) < (rank[*kept as usize], *kept) {
                std::mem::swap(point, kept);
            }
            twins.push([*point, *kept]);
        }
        equal
    });
    // The point kept at first may have given way to another.
    for place in (1..twins.len()).rev() {
        let [left, kept] = twins[place];
        if twins[place - 1][1] == left {
            twins[place - 1][1] = kept;
        }
    }
    twins.sort_unstable();
}
