//! Motions that no pressure drives.

use crate::support::{G, WATER, advance, block, flow, gravity};
use fluid_solver::backend::pfem::flow::Forces;

fn graded<const D: usize, const N: usize>(
    cells: [usize; D],
) -> fluid_solver::backend::pfem::cloud::Cloud<D, N> {
    let mut cloud = block::<D, N>([1.0; D], cells, 0.25);
    // Spacing grows eightfold from one corner to the other.
    cloud.place.iter_mut().flatten().for_each(|x| *x = 0.1 * (*x * (1.0 + *x * *x)));
    cloud
}

fn fall<const D: usize, const N: usize>(cells: [usize; D]) {
    let mut cloud = graded::<D, N>(cells);
    let start = cloud.place.clone();
    let length = 2e-3;
    advance(&mut flow(WATER, 1e-6), &mut cloud, &[], &gravity(), length, 0..20, |cloud, solution| {
        let largest = cloud.pressure.iter().fold(0.0, |max: f64, p| max.max(p.abs()));
        assert!(largest <= 1e-8 * WATER.density * G * 0.2, "{largest:e} Pa");
        assert!(solution.iterations <= 2, "{}", solution.iterations);
    });
    let time = 20.0 * length;
    for (x, start) in cloud.place.iter().zip(&start) {
        for k in 0..D {
            let fallen = if k == D - 1 { 0.5 * G * time * time } else { 0.0 };
            assert!((start[k] - x[k] - fallen).abs() <= 1e-12, "{:e}", start[k] - x[k] - fallen);
        }
    }
}

#[test]
fn a_blob_falls_freely_without_pressure_on_a_graded_mesh() {
    fall::<2, 3>([12, 12]);
    fall::<3, 4>([6, 6, 6]);
}

#[test]
fn a_translation_goes_on_for_ever() {
    let mut cloud = graded::<3, 4>([5, 5, 5]);
    cloud.velocity.fill([1.0, -2.0, 3.0]);
    advance(
        &mut flow(WATER, 1e-6),
        &mut cloud,
        &[],
        &Forces { gravity: [0.0; 3], grains: None },
        0.1,
        0..10,
        |_, _| (),
    );
    assert!(cloud.velocity.iter().all(|v| *v == [1.0, -2.0, 3.0]));
    assert!(cloud.pressure.iter().all(|p| *p == 0.0));
}
