//! Loops over fixed chunks: their bounds depend on the length only, never on the number of threads.

use rayon::prelude::*;

/// Entries per unit of parallel work.
const CHUNK: usize = 1024;

/// Calls `work(index, entry)` for every entry.
pub fn for_each<T: Send>(entries: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
    entries.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, entries)| {
        for (index, entry) in (chunk * CHUNK..).zip(entries) {
            work(index, entry);
        }
    });
}
