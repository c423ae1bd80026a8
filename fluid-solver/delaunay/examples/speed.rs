//! Speed of triangulation: CPU seconds of one thread and cells per second over kinds and numbers of points, in the plane
//! beside `spade`. The first call takes its memory from the system, the second reuses it.
//!
//! `cargo run --release -p delaunay --example speed`

use delaunay::Delaunay;
use spade::{DelaunayTriangulation, Point2, Triangulation};

#[path = "../tests/delaunay/clouds.rs"]
#[allow(dead_code)]
mod clouds;

#[allow(clippy::print_stdout)]
fn main() {
    for count in [10_000, 100_000, 1_000_000] {
        println!("3D random {count:>13} {}", measure::<3, 4>(&clouds::random(count)));
    }
    for (side, noise) in [(22, 0.0), (46, 0.0), (46, 0.01)] {
        println!("3D grid {side}³, moved {noise:<4} {}", measure::<3, 4>(&clouds::grid(side, noise)));
    }
    for count in [10_000, 100_000, 1_000_000] {
        let points = clouds::random(count);
        println!("2D random {count:>13} {} {}", measure::<2, 3>(&points), beside(&points));
    }
    let points = clouds::grid(316, 0.0);
    println!("2D grid 316², moved 0   {} {}", measure::<2, 3>(&points), beside(&points));
}

fn measure<const D: usize, const N: usize>(points: &[[f64; D]]) -> String {
    let rank = (0..points.len() as u32).collect::<Vec<_>>();
    let mut delaunay = Delaunay::<D, N>::new();
    let mut call = || {
        let start = seconds();
        let cells = delaunay.triangulate(points, &rank).map_or(0, |triangulation| triangulation.cells.len());
        let spent = seconds() - start;
        format!("{cells:>8} cells {spent:.4} s {:.2} M/s", cells as f64 / spent * 1e-6)
    };
    format!("first {}; again {}", call(), call())
}

fn beside(points: &[[f64; 2]]) -> String {
    let start = seconds();
    let points = points.iter().map(|[x, y]| Point2::new(*x, *y)).collect();
    let cells =
        DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(points).map_or(0, |all| all.num_inner_faces());
    let spent = seconds() - start;
    format!("; spade {cells} cells {spent:.4} s")
}

/// CPU time of this thread (s), as the kernel counts it.
fn seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|time| time.parse::<f64>().ok()).unwrap_or(0.0) * 1e-9
}
