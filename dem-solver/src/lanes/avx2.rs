//! Four lanes by AVX2: two registers per row.
//!
//! SAFETY of every intrinsic here: lanes exist only inside a kernel that [`super::Backend`] runs, and it runs
//! this one only where AVX2 was detected. Row indices are vouched for by the caller.

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Lanes, Row4, Row8, RowLanes, Vec3};

/// Four f64.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(__m256d);

macro_rules! lane_by_lane {
    ($trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for Avx2 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}
lane_by_lane!(Add, add, _mm256_add_pd);
lane_by_lane!(Sub, sub, _mm256_sub_pd);
lane_by_lane!(Mul, mul, _mm256_mul_pd);
lane_by_lane!(Div, div, _mm256_div_pd);

impl Neg for Avx2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

impl Lanes for Avx2 {
    const WIDTH: usize = 4;
    type Mask = __m256d;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self(unsafe { _mm256_set1_pd(x) })
    }
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self(unsafe { _mm256_loadu_pd(from[..4].as_ptr()) })
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        unsafe { _mm256_storeu_pd(to[..4].as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn inverse_root_guess<const SHIFT: u32>(self, magic: i64) -> Self {
        unsafe {
            let shifted = _mm256_srl_epi64(_mm256_castpd_si256(self.0), _mm_cvtsi32_si128(SHIFT as i32));
            Self(_mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(magic), shifted)))
        }
    }
    #[inline(always)]
    fn round(self) -> Self {
        Self(unsafe { _mm256_round_pd::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(self.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(unsafe { _mm256_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(unsafe { _mm256_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> __m256d {
        unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __m256d, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask) })
    }
    #[inline(always)]
    fn both(one: __m256d, other: __m256d) -> __m256d {
        unsafe { _mm256_and_pd(one, other) }
    }
    #[inline(always)]
    fn bits(mask: __m256d) -> u32 {
        unsafe { _mm256_movemask_pd(mask) as u32 }
    }
}

#[inline(always)]
unsafe fn row4(rows: &[Row4], at: u32) -> __m256d {
    unsafe { _mm256_load_pd(rows.get_unchecked(at as usize).0.as_ptr()) }
}

/// Half a row: from column 0 or 4.
#[inline(always)]
unsafe fn half(rows: &[Row8], at: u32, from: usize) -> __m256d {
    unsafe { _mm256_load_pd(rows.get_unchecked(at as usize).0.as_ptr().add(from)) }
}

/// The four columns of four rows, or the four rows of four columns.
#[inline(always)]
unsafe fn transposed(r: [__m256d; 4]) -> [__m256d; 4] {
    unsafe {
        let (a, b) = (_mm256_unpacklo_pd(r[0], r[1]), _mm256_unpackhi_pd(r[0], r[1]));
        let (c, d) = (_mm256_unpacklo_pd(r[2], r[3]), _mm256_unpackhi_pd(r[2], r[3]));
        [
            _mm256_permute2f128_pd::<0x20>(a, c),
            _mm256_permute2f128_pd::<0x20>(b, d),
            _mm256_permute2f128_pd::<0x31>(a, c),
            _mm256_permute2f128_pd::<0x31>(b, d),
        ]
    }
}

#[inline(always)]
unsafe fn vectors(r: [__m256d; 4]) -> Vec3<Avx2> {
    let [x, y, z, _] = unsafe { transposed(r) };
    Vec3::new(Avx2(x), Avx2(y), Avx2(z))
}

#[inline(always)]
unsafe fn rows_of(v: Vec3<Avx2>) -> [__m256d; 4] {
    unsafe { transposed([v.x.0, v.y.0, v.z.0, _mm256_setzero_pd()]) }
}

#[inline(always)]
unsafe fn add_to(rows: &mut [Row8], at: u32, first: __m256d, second: __m256d) {
    unsafe {
        let to = rows.get_unchecked_mut(at as usize).0.as_mut_ptr();
        _mm256_store_pd(to, _mm256_add_pd(_mm256_load_pd(to), first));
        _mm256_store_pd(to.add(4), _mm256_add_pd(_mm256_load_pd(to.add(4)), second));
    }
}

macro_rules! for_each_lane {
    ($k:ident => $row:expr) => {
        [
            {
                let $k = 0;
                $row
            },
            {
                let $k = 1;
                $row
            },
            {
                let $k = 2;
                $row
            },
            {
                let $k = 3;
                $row
            },
        ]
    };
}

impl RowLanes for Avx2 {
    #[inline(always)]
    unsafe fn columns4(rows: &[Row4], at: &[u32]) -> [Self; 4] {
        let [x, y, z, r] = unsafe { transposed(for_each_lane!(k => row4(rows, at[k]))) };
        [Self(x), Self(y), Self(z), Self(r)]
    }

    #[inline(always)]
    unsafe fn difference4(rows: &[Row4], i: &[u32], j: &[u32]) -> Vec3<Self> {
        unsafe { vectors(for_each_lane!(k => _mm256_sub_pd(row4(rows, j[k]), row4(rows, i[k])))) }
    }

    #[inline(always)]
    unsafe fn columns8(rows: &[Row8], at: &[u32]) -> [Vec3<Self>; 2] {
        unsafe {
            [
                vectors(for_each_lane!(k => half(rows, at[k], 0))),
                vectors(for_each_lane!(k => half(rows, at[k], 4))),
            ]
        }
    }

    #[inline(always)]
    unsafe fn difference_and_sum8(rows: &[Row8], i: &[u32], j: &[u32]) -> [Vec3<Self>; 2] {
        unsafe {
            [
                vectors(for_each_lane!(k => _mm256_sub_pd(half(rows, i[k], 0), half(rows, j[k], 0)))),
                vectors(for_each_lane!(k => _mm256_add_pd(half(rows, i[k], 4), half(rows, j[k], 4)))),
            ]
        }
    }

    #[inline(always)]
    unsafe fn difference_of_second_half(rows: &[Row8], i: &[u32], j: &[u32]) -> Vec3<Self> {
        unsafe { vectors(for_each_lane!(k => _mm256_sub_pd(half(rows, i[k], 4), half(rows, j[k], 4)))) }
    }

    #[inline(always)]
    unsafe fn add8(rows: &mut [Row8], at: &[u32], first: Vec3<Self>, second: Vec3<Self>) {
        unsafe {
            let (first, second) = (rows_of(first), rows_of(second));
            for k in 0..4 {
                add_to(rows, at[k], first[k], second[k]);
            }
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
        unsafe {
            let (first, opposed) = (rows_of(first), rows_of(-first));
            let (second_i, second_j) = (rows_of(second_i), rows_of(second_j));
            for k in 0..4 {
                add_to(rows, i[k], first[k], second_i[k]);
                add_to(rows, j[k], opposed[k], second_j[k]);
            }
        }
    }
}
