//! Any sequence of edits of a cloud on and about a lattice leaves the mesh that its points have anew.
#![no_main]

#[allow(dead_code)]
#[path = "../../tests/delaunay/program.rs"]
mod program;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Some((first, rest)) = bytes.split_first() {
        if first & 1 == 0 {
            program::edits::<2, 3>(rest);
        } else {
            program::edits::<3, 4>(rest);
        }
    }
});
