//! A fluid that gives way to pressure.

use crate::support::{advance, block, flow, newtonian, tank, touch};
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Fluid, Forces};
use fluid_solver::backend::pfem::wall::{Grip, Wall};
use std::f64::consts::PI;

const DENSITY: f64 = 1000.0;
const HEIGHT: f64 = 1.0;

/// A column of cells between frictionless walls, its speed of sound c (m/s).
fn column<const D: usize, const N: usize>(
    cells: [usize; D],
    speed_of_sound: f64,
) -> (Fluid, Cloud<D, N>, Vec<Wall<D>>) {
    let modulus = DENSITY * speed_of_sound * speed_of_sound;
    let fluid = Fluid { bulk_modulus: Some(modulus), ..newtonian(DENSITY, 1e-3) };
    let mut size = [0.2; D];
    size[D - 1] = HEIGHT;
    let (mut cloud, walls) = (block::<D, N>(size, cells, 0.2), tank(size, Grip::Slip));
    touch(&mut cloud, &walls);
    (fluid, cloud, walls)
}

fn top<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> f64 {
    cloud.place.iter().map(|x| x[D - 1]).fold(0.0, f64::max)
}

/// Error of how far a column sinks by its weight, and of the pressure in it.
fn settlement<const D: usize, const N: usize>(cells: [usize; D]) -> [f64; 2] {
    let (fluid, mut cloud, walls) = column::<D, N>(cells, 100.0);
    let mut forces = Forces { gravity: [0.0; D], grains: None };
    forces.gravity[D - 1] = -10.0;
    // Sound dies out within some of its periods, 0.04 s, as the steps do not resolve it.
    advance(&mut flow(fluid, 1e-9), &mut cloud, &walls, &forces, 0.02, 0..100, |_, _| ());
    let exact = 10.0 * HEIGHT * HEIGHT / (2.0 * 100.0 * 100.0);
    let off = |(x, p): (&[f64; D], &f64)| (p / (DENSITY * 10.0) - (HEIGHT - x[D - 1])).abs() / HEIGHT;
    let pressure = cloud.place.iter().zip(&cloud.pressure).map(off).fold(0.0, f64::max);
    [(HEIGHT - top(&cloud)) / exact - 1.0, pressure]
}

#[test]
fn a_column_sinks_by_half_its_weight_over_its_modulus() {
    for [sunk, pressure] in [settlement::<2, 3>([8, 40]), settlement::<3, 4>([2, 2, 40])] {
        println!("settlement by weight {sunk:+.2e}, pressure to {pressure:.2e} ρgH");
        assert!(sunk.abs() <= 2e-3 && pressure <= 2e-3, "{sunk} {pressure}");
    }
}

/// Error of the period of sound in so many steps, what is left of the amplitude after one, and what the steps say.
fn sound<const D: usize, const N: usize>(cells: [usize; D], steps: usize) -> [f64; 3] {
    let speed_of_sound = 20.0;
    let (fluid, mut cloud, walls) = column::<D, N>(cells, speed_of_sound);
    for (v, x) in cloud.velocity.iter_mut().zip(&cloud.place) {
        v[D - 1] = 1e-4 * (0.5 * PI * x[D - 1] / HEIGHT).sin();
    }
    let forces = Forces { gravity: [0.0; D], grains: None };
    let exact = 4.0 * HEIGHT / speed_of_sound;
    let length = exact / steps as f64;
    let mut series = vec![0.0];
    advance(&mut flow(fluid, 1e-8), &mut cloud, &walls, &forces, length, 0..2 * steps + 10, |cloud, _| {
        series.push(top(cloud) - HEIGHT);
    });
    let crossings = series.windows(2).enumerate().filter(|(n, a)| *n > 0 && a[0] * a[1] <= 0.0);
    let zeros: Vec<f64> = crossings.map(|(n, a)| (n as f64 + a[0] / (a[0] - a[1])) * length).collect();
    // p over the step before: (1 + (ωΔt)²/2)^{−1/2} a step.
    let peak = |range: std::ops::Range<usize>| series[range].iter().fold(0.0f64, |max, a| max.max(a.abs()));
    let kept = peak(3 * steps / 2..2 * steps) / peak(steps / 2..steps);
    let stated = (1.0 + 0.5 * (2.0 * PI / steps as f64).powi(2)).powf(-0.5 * steps as f64);
    [(zeros[2] - zeros[0]) / exact - 1.0, kept, stated]
}

#[test]
fn sound_goes_up_and_down_a_column_in_four_heights_and_dies_as_the_steps_say() {
    for [period, kept, stated] in [sound::<2, 3>([8, 40], 200), sound::<3, 4>([2, 2, 40], 200)] {
        println!(
            "sound: period {period:+.2e}, {kept:.4} of the amplitude is left after one, {stated:.4} by the steps"
        );
        assert!(period.abs() <= 5e-3, "{period}");
        assert!((kept - stated).abs() <= 0.01, "{kept} {stated}");
    }
}
