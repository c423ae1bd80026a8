//! Any faces put into a triangulation in space leave cells that fill its hull once, and those that came before.
#![no_main]

#[allow(dead_code)]
#[path = "../../tests/delaunay/program.rs"]
mod program;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    program::recovered_faces(bytes);
});
