//! Remeshing moves no momentum.

use crate::support::momentum;
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::body::Body;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::remesh::{Books, Remesher, SpaceRemesher, TargetSize};
use std::f64::consts::{PI, TAU};

/// A ball that a stated flow draws out, remeshed in each step: the largest change of its momentum by that, of its volume times
/// the largest speed, which is about 1 m/s.
fn change<const D: usize, const N: usize>(
    mut renewal: impl Renewal<D, N>,
    (centre, size): ([f64; D], f64),
    (steps, length): (usize, f64),
    velocity: impl Fn(&[f64; D]) -> [f64; D],
) -> f64 {
    let mut cloud: Cloud<D, N> = Body::of_sphere(centre, 0.15, size).unwrap().cloud();
    let (mut books, nodes, mut worst) = (Books::start(&cloud), cloud.place.len(), 0.0f64);
    for n in 0..steps {
        for (x, v) in cloud.place.iter_mut().zip(&mut cloud.velocity) {
            *v = velocity(x);
            (0..D).for_each(|k| x[k] += length * v[k]);
        }
        let before = momentum(&cloud);
        let size = TargetSize::Constant(size);
        renewal.remesh(&mut cloud, &[], length * n as f64, &size, &mut books).unwrap();
        let after = momentum(&cloud);
        worst = (0..D).map(|k| (after[k] - before[k]).abs() / books.volume.target).fold(worst, f64::max);
    }
    assert!(cloud.birth.iter().any(|&birth| birth as usize >= nodes), "nodes came");
    worst
}

/// R. J. LeVeque, SIAM J. Numer. Anal. 33 (1996) 627: a vortex, and two in space.
#[test]
fn remeshing_keeps_momentum_to_round_off() {
    let vortex = |x: &[f64; 2]| {
        let [s, t] = x.map(|x| ((PI * x).sin().powi(2), (TAU * x).sin()));
        [-s.0 * t.1, t.0 * s.1]
    };
    let plane = change(Remesher::<2, 3>::default(), ([0.5, 0.75], 0.02), (100, 0.01), vortex);
    let vortices = |x: &[f64; 3]| {
        let [r, s, t] = x.map(|x| ((PI * x).sin().powi(2), (TAU * x).sin()));
        [2.0 * r.0 * s.1 * t.1, -r.1 * s.0 * t.1, -r.1 * s.1 * t.0]
    };
    let space = change(SpaceRemesher::default(), ([0.35; 3], 0.03), (60, 0.01), vortices);
    println!("momentum by remeshing, of V · 1 m/s: {plane:.1e} in the plane, {space:.1e} in space");
    assert!(plane <= 1e-13 && space <= 1e-13, "{plane:e} {space:e}");
}
