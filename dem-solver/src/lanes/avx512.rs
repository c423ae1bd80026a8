//! Eight lanes by AVX-512: one register per number, one register per row.
//!
//! SAFETY of every intrinsic here: lanes exist only inside a kernel that [`super::Backend`] runs, and it runs
//! this one only where AVX-512 was detected. Row indices are vouched for by the caller.

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Lanes, Row4, Row8, RowLanes, Vec3};

/// Eight f64.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(__m512d);

macro_rules! lane_by_lane {
    ($trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for Avx512 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}
lane_by_lane!(Add, add, _mm512_add_pd);
lane_by_lane!(Sub, sub, _mm512_sub_pd);
lane_by_lane!(Mul, mul, _mm512_mul_pd);
lane_by_lane!(Div, div, _mm512_div_pd);

impl Neg for Avx512 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
}

impl Lanes for Avx512 {
    const WIDTH: usize = 8;
    type Mask = __mmask8;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self(unsafe { _mm512_set1_pd(x) })
    }
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self(unsafe { _mm512_loadu_pd(from[..8].as_ptr()) })
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        unsafe { _mm512_storeu_pd(to[..8].as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }
    #[inline(always)]
    fn inverse_root_guess<const SHIFT: u32>(self, magic: i64) -> Self {
        unsafe {
            let shifted = _mm512_srli_epi64::<SHIFT>(_mm512_castpd_si512(self.0));
            Self(_mm512_castsi512_pd(_mm512_sub_epi64(_mm512_set1_epi64(magic), shifted)))
        }
    }
    #[inline(always)]
    fn round(self) -> Self {
        Self(unsafe { _mm512_roundscale_pd::<{ _MM_FROUND_TO_NEAREST_INT }>(self.0) })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(unsafe { _mm512_min_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(unsafe { _mm512_max_pd(self.0, other.0) })
    }
    #[inline(always)]
    fn less(self, other: Self) -> __mmask8 {
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __mmask8, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm512_mask_mov_pd(no.0, mask, yes.0) })
    }
    #[inline(always)]
    fn both(one: __mmask8, other: __mmask8) -> __mmask8 {
        one & other
    }
    #[inline(always)]
    fn bits(mask: __mmask8) -> u32 {
        u32::from(mask)
    }
}

#[inline(always)]
unsafe fn row4(rows: &[Row4], at: u32) -> __m256d {
    unsafe { _mm256_load_pd(rows.get_unchecked(at as usize).0.as_ptr()) }
}

#[inline(always)]
unsafe fn row8(rows: &[Row8], at: u32) -> __m512d {
    unsafe { _mm512_load_pd(rows.get_unchecked(at as usize).0.as_ptr()) }
}

#[inline(always)]
unsafe fn second_half(rows: &[Row8], at: u32) -> __m256d {
    unsafe { _mm256_load_pd(rows.get_unchecked(at as usize).0.as_ptr().add(4)) }
}

/// -1 in the first half, 1 in the second: products with it are exact.
#[inline(always)]
unsafe fn signs() -> __m512d {
    unsafe { _mm512_setr_pd(-1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0) }
}

/// The four columns of eight rows of four.
#[inline(always)]
unsafe fn transposed4(r: [__m256d; 8]) -> [Avx512; 4] {
    unsafe {
        let pair = |a, b| _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(a), b);
        let (a, b, c, d) = (pair(r[0], r[2]), pair(r[1], r[3]), pair(r[4], r[6]), pair(r[5], r[7]));
        let (even, odd) = (_mm512_unpacklo_pd(a, b), _mm512_unpackhi_pd(a, b));
        let (even_above, odd_above) = (_mm512_unpacklo_pd(c, d), _mm512_unpackhi_pd(c, d));
        [
            Avx512(_mm512_shuffle_f64x2::<0x88>(even, even_above)),
            Avx512(_mm512_shuffle_f64x2::<0x88>(odd, odd_above)),
            Avx512(_mm512_shuffle_f64x2::<0xdd>(even, even_above)),
            Avx512(_mm512_shuffle_f64x2::<0xdd>(odd, odd_above)),
        ]
    }
}

/// Columns 0, 1, 2 and 4, 5, 6 of eight rows of eight.
#[inline(always)]
unsafe fn transposed8(r: [__m512d; 8]) -> [Vec3<Avx512>; 2] {
    unsafe {
        let (e0, o0) = (_mm512_unpacklo_pd(r[0], r[1]), _mm512_unpackhi_pd(r[0], r[1]));
        let (e1, o1) = (_mm512_unpacklo_pd(r[2], r[3]), _mm512_unpackhi_pd(r[2], r[3]));
        let (e2, o2) = (_mm512_unpacklo_pd(r[4], r[5]), _mm512_unpackhi_pd(r[4], r[5]));
        let (e3, o3) = (_mm512_unpacklo_pd(r[6], r[7]), _mm512_unpackhi_pd(r[6], r[7]));
        // Columns 0 and 4, 2 and 6, 1 and 5; rows 0–3, then 4–7.
        let (a, a_above) = (_mm512_shuffle_f64x2::<0x88>(e0, e1), _mm512_shuffle_f64x2::<0x88>(e2, e3));
        let (b, b_above) = (_mm512_shuffle_f64x2::<0xdd>(e0, e1), _mm512_shuffle_f64x2::<0xdd>(e2, e3));
        let (c, c_above) = (_mm512_shuffle_f64x2::<0x88>(o0, o1), _mm512_shuffle_f64x2::<0x88>(o2, o3));
        [
            Vec3::new(
                Avx512(_mm512_shuffle_f64x2::<0x88>(a, a_above)),
                Avx512(_mm512_shuffle_f64x2::<0x88>(c, c_above)),
                Avx512(_mm512_shuffle_f64x2::<0x88>(b, b_above)),
            ),
            Vec3::new(
                Avx512(_mm512_shuffle_f64x2::<0xdd>(a, a_above)),
                Avx512(_mm512_shuffle_f64x2::<0xdd>(c, c_above)),
                Avx512(_mm512_shuffle_f64x2::<0xdd>(b, b_above)),
            ),
        ]
    }
}

/// Four rows `[first 0 | second 0]` from what the columns hold of them: rows 0, 2, 4, 6 from the low halves of
/// pairs of lanes.
#[inline(always)]
unsafe fn four_rows(xy: __m512d, z0: __m512d, uv: __m512d, w0: __m512d) -> [__m512d; 4] {
    unsafe {
        let (a, b) = (_mm512_shuffle_f64x2::<0x44>(xy, z0), _mm512_shuffle_f64x2::<0xee>(xy, z0));
        let (c, d) = (_mm512_shuffle_f64x2::<0x44>(uv, w0), _mm512_shuffle_f64x2::<0xee>(uv, w0));
        [
            _mm512_shuffle_f64x2::<0x88>(a, c),
            _mm512_shuffle_f64x2::<0xdd>(a, c),
            _mm512_shuffle_f64x2::<0x88>(b, d),
            _mm512_shuffle_f64x2::<0xdd>(b, d),
        ]
    }
}

/// The eight rows `[first 0 | second 0]`.
#[inline(always)]
unsafe fn rows_of(first: Vec3<Avx512>, second: Vec3<Avx512>) -> [__m512d; 8] {
    unsafe {
        let zero = _mm512_setzero_pd();
        let even = four_rows(
            _mm512_unpacklo_pd(first.x.0, first.y.0),
            _mm512_unpacklo_pd(first.z.0, zero),
            _mm512_unpacklo_pd(second.x.0, second.y.0),
            _mm512_unpacklo_pd(second.z.0, zero),
        );
        let odd = four_rows(
            _mm512_unpackhi_pd(first.x.0, first.y.0),
            _mm512_unpackhi_pd(first.z.0, zero),
            _mm512_unpackhi_pd(second.x.0, second.y.0),
            _mm512_unpackhi_pd(second.z.0, zero),
        );
        [even[0], odd[0], even[1], odd[1], even[2], odd[2], even[3], odd[3]]
    }
}

#[inline(always)]
unsafe fn add_to(rows: &mut [Row8], at: u32, row: __m512d) {
    unsafe {
        let to = rows.get_unchecked_mut(at as usize).0.as_mut_ptr();
        _mm512_store_pd(to, _mm512_add_pd(_mm512_load_pd(to), row));
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
            {
                let $k = 4;
                $row
            },
            {
                let $k = 5;
                $row
            },
            {
                let $k = 6;
                $row
            },
            {
                let $k = 7;
                $row
            },
        ]
    };
}

impl RowLanes for Avx512 {
    #[inline(always)]
    unsafe fn columns4(rows: &[Row4], at: &[u32]) -> [Self; 4] {
        unsafe { transposed4(for_each_lane!(k => row4(rows, at[k]))) }
    }

    #[inline(always)]
    unsafe fn difference4(rows: &[Row4], i: &[u32], j: &[u32]) -> Vec3<Self> {
        let [x, y, z, _] =
            unsafe { transposed4(for_each_lane!(k => _mm256_sub_pd(row4(rows, j[k]), row4(rows, i[k])))) };
        Vec3::new(x, y, z)
    }

    #[inline(always)]
    unsafe fn columns8(rows: &[Row8], at: &[u32]) -> [Vec3<Self>; 2] {
        unsafe { transposed8(for_each_lane!(k => row8(rows, at[k]))) }
    }

    #[inline(always)]
    unsafe fn difference_and_sum8(rows: &[Row8], i: &[u32], j: &[u32]) -> [Vec3<Self>; 2] {
        unsafe {
            let signs = signs();
            transposed8(for_each_lane!(k => _mm512_fmadd_pd(signs, row8(rows, j[k]), row8(rows, i[k]))))
        }
    }

    #[inline(always)]
    unsafe fn difference_of_second_half(rows: &[Row8], i: &[u32], j: &[u32]) -> Vec3<Self> {
        let [x, y, z, _] = unsafe {
            transposed4(for_each_lane!(k => _mm256_sub_pd(second_half(rows, i[k]), second_half(rows, j[k]))))
        };
        Vec3::new(x, y, z)
    }

    #[inline(always)]
    unsafe fn add8(rows: &mut [Row8], at: &[u32], first: Vec3<Self>, second: Vec3<Self>) {
        unsafe {
            let add = rows_of(first, second);
            for k in 0..8 {
                add_to(rows, at[k], add[k]);
            }
        }
    }

    #[inline(always)]
    unsafe fn add_opposed8(rows: &mut [Row8], i: &[u32], j: &[u32], first: Vec3<Self>, second: Vec3<Self>) {
        unsafe {
            let (add, signs) = (rows_of(first, second), signs());
            for k in 0..8 {
                add_to(rows, i[k], add[k]);
                add_to(rows, j[k], _mm512_mul_pd(signs, add[k]));
            }
        }
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
            let (on_i, on_j) = (rows_of(first, second_i), rows_of(-first, second_j));
            for k in 0..8 {
                add_to(rows, i[k], on_i[k]);
                add_to(rows, j[k], on_j[k]);
            }
        }
    }
}
