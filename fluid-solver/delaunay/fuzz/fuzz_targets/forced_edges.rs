//! Any edges forced into a triangulation of the plane leave it valid and Delaunay beside them.
#![no_main]

#[allow(dead_code)]
#[path = "../../tests/delaunay/program.rs"]
mod program;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    program::forced_edges(bytes);
});
