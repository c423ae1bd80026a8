//! Loops over fixed chunks: their bounds depend on the length only, never on the number of threads.

use rayon::prelude::*;

/// Entries per unit of parallel work.
const CHUNK: usize = 1024;

/// Entries from which a second thread pays.
const PARALLEL: usize = 8 * CHUNK;

/// Calls `work(index, entry)` for every entry.
pub fn for_each<T: Send>(entries: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
    if entries.len() < PARALLEL {
        return entries.iter_mut().enumerate().for_each(|(index, entry)| work(index, entry));
    }
    entries.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, entries)| {
        for (index, entry) in (chunk * CHUNK..).zip(entries) {
            work(index, entry);
        }
    });
}
