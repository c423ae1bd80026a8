//! Rows on their way to the cache before they are needed.

use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};

/// Asks for a row that is needed soon: a hint, which changes nothing but the time that its first use takes.
#[inline(always)]
pub fn prefetch<Row>(rows: &[Row], at: u32) {
    // SAFETY: a hint reads nothing, whatever the address.
    unsafe { _mm_prefetch::<_MM_HINT_T0>(rows.as_ptr().wrapping_add(at as usize).cast()) }
}
