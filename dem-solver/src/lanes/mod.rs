//! Several f64 side by side, by what the CPU offers, with the same bits from each.
//!
//! Every operation is one IEEE operation per lane: never fused, never reassociated, so that a CPU without
//! fused multiply-add computes the same. All intrinsics of the crate are in this folder.

mod avx2;
mod avx512;
mod backend;
mod plain;
mod prefetch;
mod scalar;
#[cfg(test)]
mod tests;
mod vec3;

use std::ops::{Add, Div, Mul, Neg, Sub};

pub use backend::{Backend, Kernel};
pub use prefetch::prefetch;
pub use vec3::Vec3;

/// Four numbers of one grain: `[x y z r]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub struct Row4(pub [f64; 4]);

/// Eight numbers of one grain, one cache line: `[v 1/m | ω 1/I]`, or `[F 0 | T 0]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct Row8(pub [f64; 8]);

/// Arithmetic on [`Lanes::WIDTH`] numbers at once.
///
/// Values exist only inside a [`Kernel`] that a [`Backend`] runs, that is on a CPU that has the instructions.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Number of lanes.
    const WIDTH: usize;
    /// One truth per lane.
    type Mask: Copy;

    /// The same number in every lane.
    fn splat(x: f64) -> Self;
    /// The first numbers of a slice.
    fn load(from: &[f64]) -> Self;
    /// Into the first places of a slice.
    fn store(self, to: &mut [f64]);
    /// Square root, rounded correctly.
    fn sqrt(self) -> Self;
    /// A first guess of x^(-1/2^SHIFT), x > 0: `magic` less the bits of x shifted, as integers.
    fn inverse_root_guess<const SHIFT: u32>(self, magic: i64) -> Self;
    /// To the nearest integer, ties to even.
    fn round(self) -> Self;
    /// `self < other ? self : other`.
    fn min(self, other: Self) -> Self;
    /// `self > other ? self : other`.
    fn max(self, other: Self) -> Self;
    /// Where `self < other`; nowhere where either is not a number.
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Where both hold.
    fn both(one: Self::Mask, other: Self::Mask) -> Self::Mask;
    /// Bit k is lane k.
    fn bits(mask: Self::Mask) -> u32;

    /// x^(-1/4) to two roundings, x > 0 and normal; finite at 0.
    #[inline(always)]
    fn inverse_fourth_root(self) -> Self {
        let quarter = self * Self::splat(0.25);
        let mut y = self.inverse_root_guess::<2>(0x4feb_098e_17c4_8bdd);
        for _ in 0..4 {
            let squared = y * y;
            y = y * (Self::splat(1.25) - quarter * (squared * squared));
        }
        y
    }

    /// Whether the mask holds everywhere.
    #[inline(always)]
    fn all(mask: Self::Mask) -> bool {
        Self::bits(mask) == (1 << Self::WIDTH) - 1
    }

    /// Whether the mask holds anywhere.
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        Self::bits(mask) != 0
    }

    /// The value where the mask holds, else 0.
    #[inline(always)]
    fn only(self, mask: Self::Mask) -> Self {
        Self::select(mask, self, Self::splat(0.0))
    }
}

/// Lanes that gather rows of grains, one grain per lane, and add to them.
///
/// # Safety
/// Rows are not bounds-checked: each of the first [`Lanes::WIDTH`] indices must be a row.
pub trait RowLanes: Lanes {
    /// The columns of `[x y z r]`.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn columns4(rows: &[Row4], at: &[u32]) -> [Self; 4];

    /// x, y, z of row j less row i.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn difference4(rows: &[Row4], i: &[u32], j: &[u32]) -> Vec3<Self>;

    /// The first and the second three of `[a b c · | d e f ·]`.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn columns8(rows: &[Row8], at: &[u32]) -> [Vec3<Self>; 2];

    /// First half of row i less that of row j; second half of row i plus that of row j.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn difference_and_sum8(rows: &[Row8], i: &[u32], j: &[u32]) -> [Vec3<Self>; 2];

    /// Second half of row i less that of row j.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn difference_of_second_half(rows: &[Row8], i: &[u32], j: &[u32]) -> Vec3<Self>;

    /// Adds `[first 0 | second 0]` to the rows, lane by lane.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn add8(rows: &mut [Row8], at: &[u32], first: Vec3<Self>, second: Vec3<Self>);

    /// Adds `[first 0 | second 0]` to row i and `[-first 0 | second 0]` to row j, lane by lane.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn add_opposed8(rows: &mut [Row8], i: &[u32], j: &[u32], first: Vec3<Self>, second: Vec3<Self>);

    /// Adds `[first 0 | second_i 0]` to row i and `[-first 0 | second_j 0]` to row j, lane by lane.
    ///
    /// # Safety
    /// See the trait.
    unsafe fn add_unequal8(
        rows: &mut [Row8],
        i: &[u32],
        j: &[u32],
        first: Vec3<Self>,
        second_i: Vec3<Self>,
        second_j: Vec3<Self>,
    );
}
