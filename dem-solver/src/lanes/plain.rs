//! Eight lanes without intrinsics, for any CPU.

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Lanes, Row4, Row8, RowLanes, Vec3};

/// Eight f64.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Plain([f64; 8]);

macro_rules! lane_by_lane {
    ($trait:ident, $method:ident, $operator:tt) => {
        impl $trait for Plain {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(from_fn(|k| self.0[k] $operator other.0[k]))
            }
        }
    };
}
lane_by_lane!(Add, add, +);
lane_by_lane!(Sub, sub, -);
lane_by_lane!(Mul, mul, *);
lane_by_lane!(Div, div, /);

impl Neg for Plain {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl Lanes for Plain {
    const WIDTH: usize = 8;
    /// All bits of a lane set, or none: compilers make vector compares and selects of it.
    type Mask = [u64; 8];

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([x; 8])
    }
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self(from_fn(|k| from[k]))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[..8].copy_from_slice(&self.0);
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }
    #[inline(always)]
    fn inverse_root_guess<const SHIFT: u32>(self, magic: i64) -> Self {
        Self(self.0.map(|x| x.inverse_root_guess::<SHIFT>(magic)))
    }
    #[inline(always)]
    fn round(self) -> Self {
        Self(self.0.map(f64::round_ties_even))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(from_fn(|k| if self.0[k] < other.0[k] { self.0[k] } else { other.0[k] }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(from_fn(|k| if self.0[k] > other.0[k] { self.0[k] } else { other.0[k] }))
    }
    #[inline(always)]
    fn less(self, other: Self) -> [u64; 8] {
        from_fn(|k| if self.0[k] < other.0[k] { u64::MAX } else { 0 })
    }
    #[inline(always)]
    fn select(mask: [u64; 8], yes: Self, no: Self) -> Self {
        Self(from_fn(|k| f64::from_bits((yes.0[k].to_bits() & mask[k]) | (no.0[k].to_bits() & !mask[k]))))
    }
    #[inline(always)]
    fn both(one: [u64; 8], other: [u64; 8]) -> [u64; 8] {
        from_fn(|k| one[k] & other[k])
    }
    #[inline(always)]
    fn bits(mask: [u64; 8]) -> u32 {
        (0..8).fold(0, |bits, k| bits | ((mask[k] & 1) as u32) << k)
    }
}

/// Three columns of what is found for each lane.
#[inline(always)]
fn transposed(row: impl Fn(usize) -> [f64; 3]) -> Vec3<Plain> {
    let mut columns = [[0.0; 8]; 3];
    for k in 0..8 {
        let row = row(k);
        for c in 0..3 {
            columns[c][k] = row[c];
        }
    }
    let [x, y, z] = columns;
    Vec3::new(Plain(x), Plain(y), Plain(z))
}

/// Adds to three components of a row, from lane k.
#[inline(always)]
fn add_lane(row: &mut [f64], k: usize, vector: Vec3<Plain>) {
    row[0] += vector.x.0[k];
    row[1] += vector.y.0[k];
    row[2] += vector.z.0[k];
}

#[inline(always)]
fn subtract_lane(row: &mut [f64], k: usize, vector: Vec3<Plain>) {
    row[0] -= vector.x.0[k];
    row[1] -= vector.y.0[k];
    row[2] -= vector.z.0[k];
}

// SAFETY of all bodies: the caller vouches for the indices.
impl RowLanes for Plain {
    #[inline(always)]
    unsafe fn columns4(rows: &[Row4], at: &[u32]) -> [Self; 4] {
        let mut columns = [[0.0; 8]; 4];
        for k in 0..8 {
            let row = unsafe { rows.get_unchecked(at[k] as usize) };
            for c in 0..4 {
                columns[c][k] = row.0[c];
            }
        }
        columns.map(Plain)
    }

    #[inline(always)]
    unsafe fn difference4(rows: &[Row4], i: &[u32], j: &[u32]) -> Vec3<Self> {
        transposed(|k| {
            let (a, b) =
                unsafe { (rows.get_unchecked(i[k] as usize).0, rows.get_unchecked(j[k] as usize).0) };
            from_fn(|c| b[c] - a[c])
        })
    }

    #[inline(always)]
    unsafe fn columns8(rows: &[Row8], at: &[u32]) -> [Vec3<Self>; 2] {
        [0, 4].map(|half| {
            transposed(|k| from_fn(|c| unsafe { rows.get_unchecked(at[k] as usize).0[half + c] }))
        })
    }

    #[inline(always)]
    unsafe fn difference_and_sum8(rows: &[Row8], i: &[u32], j: &[u32]) -> [Vec3<Self>; 2] {
        let both =
            |k: usize| unsafe { (rows.get_unchecked(i[k] as usize).0, rows.get_unchecked(j[k] as usize).0) };
        let difference = transposed(|k| {
            let (a, b) = both(k);
            from_fn(|c| a[c] - b[c])
        });
        let sum = transposed(|k| {
            let (a, b) = both(k);
            from_fn(|c| a[4 + c] + b[4 + c])
        });
        [difference, sum]
    }

    #[inline(always)]
    unsafe fn difference_of_second_half(rows: &[Row8], i: &[u32], j: &[u32]) -> Vec3<Self> {
        transposed(|k| {
            let (a, b) =
                unsafe { (rows.get_unchecked(i[k] as usize).0, rows.get_unchecked(j[k] as usize).0) };
            from_fn(|c| a[4 + c] - b[4 + c])
        })
    }

    #[inline(always)]
    unsafe fn add8(rows: &mut [Row8], at: &[u32], first: Vec3<Self>, second: Vec3<Self>) {
        for k in 0..8 {
            let row = unsafe { &mut rows.get_unchecked_mut(at[k] as usize).0 };
            add_lane(&mut row[..3], k, first);
            add_lane(&mut row[4..7], k, second);
        }
    }

    #[inline(always)]
    unsafe fn add_opposed8(rows: &mut [Row8], i: &[u32], j: &[u32], first: Vec3<Self>, second: Vec3<Self>) {
        unsafe { Self::add_unequal8(rows, i, j, first, second, second) }
    }

    #[inline(always)]
    unsafe fn add_unequal8(
        rows: &mut [Row8],
        i: &[u32],
        j: &[u32],
        first: Vec3<Self>,
        second_i: Vec3<Self>,
        second_j: Vec3<Self>,
    ) {
        for k in 0..8 {
            let row = unsafe { &mut rows.get_unchecked_mut(i[k] as usize).0 };
            add_lane(&mut row[..3], k, first);
            add_lane(&mut row[4..7], k, second_i);
            let row = unsafe { &mut rows.get_unchecked_mut(j[k] as usize).0 };
            subtract_lane(&mut row[..3], k, first);
            add_lane(&mut row[4..7], k, second_j);
        }
    }
}
