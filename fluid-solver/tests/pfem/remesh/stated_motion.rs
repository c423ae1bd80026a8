//! Motions that are known.

use super::{Fluid, Seeds};
use std::f64::consts::PI;

const H: f64 = 0.02;

fn disc(centre: [f64; 2], radius: f64) -> Fluid {
    let mut seeds = Seeds::new(&[]);
    seeds.add_disc(centre, radius, H, [0.0; 2]);
    seeds.mesh(H, 1.0)
}

#[test]
fn a_disc_that_turns_and_flies_is_not_remeshed() {
    let mut fluid = disc([0.0, 0.0], 0.2);
    let (cells, nodes) = (fluid.cloud.cells.clone(), fluid.cloud.place.len());
    for _ in 0..200 {
        let centre = [3.0 * fluid.time, -fluid.time];
        let events = fluid.carry(0.01, |x, t| {
            let moved = [3.0 * (t - 0.0), -t];
            [3.0 - 2.0 * (x[1] - moved[1]), -1.0 + 2.0 * (x[0] - moved[0])]
        });
        assert!(events.none(), "{events:?} at {centre:?}");
    }
    fluid.check();
    assert_eq!(fluid.cloud.cells, cells);
    assert_eq!(fluid.cloud.place.len(), nodes);
    assert!(fluid.volume_error().abs() < 1e-7, "{}", fluid.volume_error());
    assert!(fluid.books.volume.correction.absolute < 1e-7 * fluid.books.volume.target);
}

/// R. J. LeVeque, High-resolution conservative algorithms for advection in incompressible flow, SIAM J. Numer. Anal. 33
/// (1996) 627: the flow turns round at half the period and brings everything back.
fn vortex(x: [f64; 2], t: f64, period: f64) -> [f64; 2] {
    let (sx, sy) = ((PI * x[0]).sin(), (PI * x[1]).sin());
    let turn = (PI * t / period).cos();
    [-turn * sx * sx * (2.0 * PI * x[1]).sin(), turn * sy * sy * (2.0 * PI * x[0]).sin()]
}

#[test]
fn a_vortex_that_turns_round_brings_the_surface_back() {
    let mut fluid = disc([0.5, 0.75], 0.15);
    let (steps, period) = (400, 2.0);
    let mut largest: f64 = 0.0;
    for _ in 0..steps {
        fluid.carry(period / f64::from(steps), |x, t| vortex(x, t, period));
        largest = largest.max(fluid.volume_error().abs());
    }
    fluid.check();
    let wet = fluid.cloud.neighbours.iter().zip(&fluid.cloud.cells).flat_map(|(around, cell)| {
        (0..3).filter(|&i| around[i] == u32::MAX).map(|i| cell[(i + 1) % 3]).collect::<Vec<_>>()
    });
    let off = |x: [f64; 2]| ((x[0] - 0.5f64).hypot(x[1] - 0.75) - 0.15).abs();
    let worst = wet.map(|node| off(fluid.cloud.place[node as usize])).fold(0.0, f64::max);
    assert!(worst < 0.25 * H, "{} h", worst / H);
    assert!(largest < 2e-3, "{largest}");
    assert_eq!(fluid.books.volume.merging.absolute + fluid.books.volume.separation.absolute, 0.0);
}

#[test]
fn the_result_depends_on_the_cloud_alone() {
    let mut fluid = disc([0.5, 0.75], 0.15);
    for step in 0..150 {
        if step % 10 == 0 {
            fluid.remesher = Default::default();
        }
        fluid.carry(0.01, |x, t| vortex(x, t, 3.0));
    }
    let mut through = disc([0.5, 0.75], 0.15);
    for _ in 0..150 {
        through.carry(0.01, |x, t| vortex(x, t, 3.0));
    }
    assert_eq!(fluid.cloud, through.cloud);
    assert_eq!(fluid.books, through.books);
}
