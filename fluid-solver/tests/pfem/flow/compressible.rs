//! A fluid that gives way to pressure.

use crate::support::{advance, block, flow, newtonian, tank, touch};
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Fluid, Forces};
use fluid_solver::backend::pfem::wall::{Grip, Wall};
use std::f64::consts::PI;

const DENSITY: f64 = 1000.0;
const HEIGHT: f64 = 1.0;

/// A column between frictionless walls, its speed of sound c (m/s).
fn column(speed_of_sound: f64) -> (Fluid, Cloud<2, 3>, Vec<Wall<2>>) {
    let modulus = DENSITY * speed_of_sound * speed_of_sound;
    let fluid = Fluid { bulk_modulus: Some(modulus), ..newtonian(DENSITY, 1e-3) };
    let (mut cloud, walls) = (block::<2, 3>([0.2, HEIGHT], [8, 40], 0.2), tank([0.2, HEIGHT], Grip::Slip));
    touch(&mut cloud, &walls);
    (fluid, cloud, walls)
}

fn top(cloud: &Cloud<2, 3>) -> f64 {
    cloud.place.iter().map(|x| x[1]).fold(0.0, f64::max)
}

#[test]
fn a_column_sinks_by_half_its_weight_over_its_modulus() {
    let (fluid, mut cloud, walls) = column(100.0);
    let forces = Forces { gravity: [0.0, -10.0], grains: None };
    // Sound dies out within some of its periods, 0.04 s, as the steps do not resolve it.
    advance(&mut flow(fluid, 1e-9), &mut cloud, &walls, &forces, 0.02, 0..100, |_, _| ());
    let exact = 10.0 * HEIGHT * HEIGHT / (2.0 * 100.0 * 100.0);
    let sunk = HEIGHT - top(&cloud);
    assert!((sunk / exact - 1.0).abs() <= 2e-3, "{sunk} m, {exact} m");
    for (x, p) in cloud.place.iter().zip(&cloud.pressure) {
        let weight = DENSITY * 10.0 * (HEIGHT - x[1]);
        assert!((p - weight).abs() <= 2e-3 * DENSITY * 10.0 * HEIGHT, "{p} Pa at {x:?}, {weight} Pa");
    }
}

#[test]
fn sound_goes_up_and_down_a_column_in_four_heights_and_dies_as_the_steps_say() {
    let (speed_of_sound, steps) = (20.0, 200);
    let (fluid, mut cloud, walls) = column(speed_of_sound);
    for (v, x) in cloud.velocity.iter_mut().zip(&cloud.place) {
        v[1] = 1e-4 * (0.5 * PI * x[1] / HEIGHT).sin();
    }
    let forces = Forces { gravity: [0.0; 2], grains: None };
    let exact = 4.0 * HEIGHT / speed_of_sound;
    let length = exact / steps as f64;
    let mut series = vec![0.0];
    advance(&mut flow(fluid, 1e-8), &mut cloud, &walls, &forces, length, 0..2 * steps + 10, |cloud, _| {
        series.push(top(cloud) - HEIGHT);
    });
    let crossings = series.windows(2).enumerate().filter(|(n, a)| *n > 0 && a[0] * a[1] <= 0.0);
    let zeros: Vec<f64> = crossings.map(|(n, a)| (n as f64 + a[0] / (a[0] - a[1])) * length).collect();
    let period = zeros[2] - zeros[0];
    assert!((period / exact - 1.0).abs() <= 5e-3, "{period} s, {exact} s");
    // p over the step before: (1 + (ωΔt)²/2)^{−1/2} a step.
    let peak = |range: std::ops::Range<usize>| series[range].iter().fold(0.0f64, |max, a| max.max(a.abs()));
    let kept = peak(3 * steps / 2..2 * steps) / peak(steps / 2..steps);
    let stated = (1.0 + 0.5 * (2.0 * PI / steps as f64).powi(2)).powf(-0.5 * steps as f64);
    assert!((kept - stated).abs() <= 0.01, "{kept} of the amplitude after a period, {stated}");
}
