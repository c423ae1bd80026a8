//! What is reused of the last triangulation does not show.

use crate::clouds::{Random, flat, grid, random, sphere};
use delaunay::{Delaunay, check};

/// Moves points a little, takes some away and adds some, and triangulates them with what was there before and without.
/// Returns how often something was reused.
fn claim<const D: usize, const N: usize>(mut points: Vec<[f64; D]>, step: f64, steps: usize) -> usize {
    let mut times = 0;
    let mut rank: Vec<u32> = (0..points.len() as u32).collect();
    let mut born = points.len() as u32;
    let mut kept = Delaunay::<D, N>::new();
    let mut random = Random(13);
    for n in 0..steps {
        let anew = Delaunay::<D, N>::new().triangulate(&points, &rank).unwrap().clone();
        kept.triangulate(&points, &rank).unwrap();
        times += usize::from(kept.was_reused());
        let reused = kept.triangulation();
        assert!(*reused == anew, "step {n} of {} points by {step}", points.len());
        if n == steps / 2 {
            assert!(check(&points, &rank, reused).unwrap().none());
        }
        for point in &mut points {
            for x in point {
                *x += step * (2.0 * random.next() - 1.0);
            }
        }
        for _ in 0..random.below(points.len() / 50 + 2) {
            let gone = random.below(points.len());
            points.remove(gone);
            rank.remove(gone);
            let parent = points[random.below(points.len())];
            points.push(parent.map(|x| x + 0.02 * random.next()));
            rank.push(born);
            born += 1;
        }
    }
    times
}

#[test]
fn random_clouds_that_move_a_little_or_much_have_the_cells_that_they_would_have_anew() {
    for (step, least) in [(0.0, 18), (1e-5, 18), (1e-3, 16), (1e-2, 0), (0.3, 0)] {
        for times in [claim::<3, 4>(random(600), step, 20), claim::<2, 3>(random(600), step, 20)] {
            assert!(times >= least, "reused {times} of 20 times where points moved by {step}");
        }
    }
}

#[test]
fn grids_spheres_and_planes_that_move_a_little_have_the_cells_that_they_would_have_anew() {
    for step in [0.0, 1e-16, 1e-8, 1e-3, 1e-2] {
        claim::<3, 4>(grid(8, 0.0), step, 12);
        claim::<2, 3>(grid(20, 0.0), step, 12);
        claim::<3, 4>(sphere(400), step, 12);
        claim::<2, 3>(sphere(400), step, 12);
        claim::<3, 4>(flat(300, 2), step, 8);
    }
}
