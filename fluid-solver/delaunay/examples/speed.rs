//! Speed of triangulation in CPU seconds of one thread: cells per second over kinds and numbers of points.

use delaunay::{Delaunay, check};
use std::time::Instant;

fn main() {
    let checked = std::env::args().any(|a| a == "check");
    for n in [10_000, 100_000, 1_000_000].into_iter().filter(|n| !checked || *n < 1_000_000) {
        run::<3, 4>("random", &random(n), checked);
    }
    run::<3, 4>("grid 22³", &grid(22, 0.0), checked);
    run::<3, 4>("grid 46³", &grid(46, 0.0), checked);
    run::<3, 4>("grid 46³ 1%", &grid(46, 0.01), checked);
    for n in [10_000, 100_000, 1_000_000].into_iter().filter(|n| !checked || *n < 1_000_000) {
        run::<2, 3>("random", &random(n), checked);
    }
    run::<2, 3>("grid 316²", &grid(316, 0.0), checked);
}

fn grid<const D: usize>(side: usize, noise: f64) -> Vec<[f64; D]> {
    let mut r = Random(7);
    (0..side.pow(D as u32))
        .map(|mut i| {
            std::array::from_fn(|_| {
                let k = i % side;
                i /= side;
                (k as f64 + noise * (r.next() - 0.5)) / (side - 1) as f64
            })
        })
        .collect()
}
fn random<const D: usize>(n: usize) -> Vec<[f64; D]> {
    let mut r = Random(1);
    (0..n).map(|_| std::array::from_fn(|_| r.next())).collect()
}
struct Random(u64);
impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|t| t.parse::<f64>().ok()).unwrap_or(0.0) * 1e-9
}
fn run<const D: usize, const N: usize>(name: &str, points: &[[f64; D]], checked: bool) {
    let rank: Vec<u32> = (0..points.len() as u32).collect();
    let mut delaunay = Delaunay::<D, N>::new();
    for _ in 0..2 {
        let (c, w) = (cpu(), Instant::now());
        let t = delaunay.triangulate(points, &rank).unwrap();
        let (c, w) = (cpu() - c, w.elapsed().as_secs_f64());
        let cells = t.cells.len();
        println!(
            "{D}D {name} {} points, {cells} cells: {c:.4} s cpu {w:.4} wall {:.2} M cells/s",
            points.len(),
            cells as f64 / c * 1e-6
        );
        if checked {
            println!("   {:?}", check(points, &rank, t));
        }
    }
}
