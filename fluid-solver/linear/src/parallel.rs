//! Fixed chunks of work: their bounds depend on the length only, never on the number of threads.

use rayon::prelude::*;

/// Rows per chunk; about 10 µs of work in the product with a mesh Laplacian.
pub(crate) const ROWS: usize = 2048;

/// Length from which a second thread pays.
const PARALLEL: usize = 8 * ROWS;

/// Calls `work(first index, chunk)` for consecutive chunks of `ROWS` entries, in parallel if there are many.
pub(crate) fn for_each_chunk<T: Send>(entries: &mut [T], work: impl Fn(usize, &mut [T]) + Sync + Send) {
    if entries.len() < PARALLEL {
        work(0, entries);
    } else {
        entries.par_chunks_mut(ROWS).enumerate().for_each(|(k, chunk)| work(k * ROWS, chunk));
    }
}
