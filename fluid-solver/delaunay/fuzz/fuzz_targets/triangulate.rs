//! Any small cloud on and about a lattice, in 2D and 3D, has no fault.
#![no_main]

#[allow(dead_code)]
#[path = "../../tests/delaunay/clouds.rs"]
mod clouds;

use delaunay::{Delaunay, check};
use libfuzzer_sys::fuzz_target;

fn claim<const D: usize, const N: usize>(bytes: &[u8]) {
    let points = clouds::from_bytes::<D>(bytes);
    let rank = (0..points.len() as u32).collect::<Vec<_>>();
    let mut delaunay = Delaunay::<D, N>::new();
    let triangulation = delaunay.triangulate(&points, &rank).unwrap();
    assert!(check(&points, &rank, triangulation).unwrap().none());
}

fuzz_target!(|bytes: &[u8]| {
    claim::<2, 3>(bytes);
    claim::<3, 4>(bytes);
});
