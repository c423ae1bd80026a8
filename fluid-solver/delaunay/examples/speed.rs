//! Speed of triangulation: CPU seconds of one thread and cells per second over kinds and numbers of points, in the plane
//! beside `spade`. The first call takes its memory from the system, the second has it, the third has the mesh too.
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
    for share in [1e-4, 1e-3, 1e-2, 3e-2, 1e-1] {
        println!("3D 50,000 moved by {share:<6} of their distance {}", moved::<3, 4>(50_000, share));
        println!("2D 50,000 moved by {share:<6} of their distance {}", moved::<2, 3>(50_000, share));
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
    let mut call = |rank: &[u32]| {
        let start = seconds();
        let cells = delaunay.triangulate(points, rank).map_or(0, |triangulation| triangulation.cells.len());
        let spent = seconds() - start;
        format!("{cells:>8} cells {spent:.4} s {:.2} M/s", cells as f64 / spent * 1e-6)
    };
    format!("first {}; again {}; reused {}", call(&rank), call(&unsorted(&rank)), call(&rank))
}

/// A rank that falls keeps a mesh from being reused.
fn unsorted(rank: &[u32]) -> Vec<u32> {
    let mut unsorted = rank.to_vec();
    unsorted.swap(0, 1);
    unsorted
}

/// Points that move by a share of their distance: time of a new mesh and of the last one repaired.
fn moved<const D: usize, const N: usize>(count: usize, share: f64) -> String {
    let (mut points, mut random) = (clouds::random::<D>(count), clouds::Random(3));
    let rank = (0..count as u32).collect::<Vec<_>>();
    let (mut anew, mut kept) = (Delaunay::<D, N>::new(), Delaunay::<D, N>::new());
    let mut spent = [0.0; 2];
    let step = share / (count as f64).powf(1.0 / D as f64);
    for n in 0..6 {
        for x in points.iter_mut().flatten() {
            *x += step * (2.0 * random.next() - 1.0);
        }
        let other = unsorted(&rank);
        for (k, (delaunay, rank)) in [(&mut anew, &other), (&mut kept, &rank)].into_iter().enumerate() {
            let start = seconds();
            delaunay.triangulate(&points, rank).expect("finite points");
            spent[k] += if n == 0 { 0.0 } else { seconds() - start };
        }
    }
    let each = spent.map(|spent| 1e6 * spent / (5 * count) as f64);
    format!("anew {:.2}, reused {:.2} us a point", each[0], each[1])
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
