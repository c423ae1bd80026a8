//! Claims about triangulations of clouds of every kind.

mod checker;
mod clouds;
mod degenerate;
mod edit;
mod faces;
mod invariance;
mod program;
mod reuse;

use delaunay::{Delaunay, Triangulation, check};

/// Triangulates points whose ranks are their indices and demands that the exact checker finds no fault.
fn faultless<const D: usize, const N: usize>(points: &[[f64; D]]) -> Triangulation<N> {
    let rank = (0..points.len() as u32).collect::<Vec<_>>();
    let triangulation = Delaunay::<D, N>::new().triangulate(points, &rank).unwrap().clone();
    let faults = check(points, &rank, &triangulation).unwrap();
    assert!(faults.none(), "{faults:?} in the triangulation of {} points", points.len());
    triangulation
}

/// Six times the volumes of the cells.
fn volumes(points: &[[f64; 3]], triangulation: &Triangulation<4>) -> Vec<f64> {
    let volume = |cell: &[u32; 4]| {
        let [a, b, c, d] = cell.map(|corner| points[corner as usize]);
        let [b, c, d] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
        minor(1, 2) * d[0] + minor(2, 0) * d[1] + minor(0, 1) * d[2]
    };
    triangulation.cells.iter().map(volume).collect()
}
