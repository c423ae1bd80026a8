//! Any small cloud on and about a lattice, in 2D and 3D, has no fault, and has the same cells if it is put together by edits.
#![no_main]

#[allow(dead_code)]
#[path = "../../tests/delaunay/clouds.rs"]
mod clouds;

use delaunay::{Delaunay, check};
use libfuzzer_sys::fuzz_target;

fn claim<const D: usize, const N: usize>(bytes: &[u8]) {
    let mut points = clouds::from_bytes::<D>(bytes);
    let rank = (0..points.len() as u32).collect::<Vec<_>>();
    let mut delaunay = Delaunay::<D, N>::new();
    let triangulation = delaunay.triangulate(&points, &rank).unwrap().clone();
    assert!(check(&points, &rank, &triangulation).unwrap().none());
    let mut edited = Delaunay::<D, N>::new();
    for (place, rank) in points.iter().zip(&rank) {
        edited.insert(*place, *rank).unwrap();
    }
    assert!(*edited.triangulation() == triangulation);
    // To the place of another point and back, by an edit and all at once.
    for (point, byte) in bytes.iter().enumerate().take(points.len()) {
        let (home, other) = (points[point], points[usize::from(*byte) % points.len()]);
        edited.relocate(point as u32, other).unwrap();
        points[point] = other;
        assert!(edited.triangulation() == delaunay.triangulate(&points, &rank).unwrap());
        edited.relocate(point as u32, home).unwrap();
        points[point] = home;
    }
    assert!(*edited.triangulation() == triangulation);
}

fuzz_target!(|bytes: &[u8]| {
    claim::<2, 3>(bytes);
    claim::<3, 4>(bytes);
});
