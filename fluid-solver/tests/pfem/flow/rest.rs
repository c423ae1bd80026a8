//! A fluid at rest stays at rest.

use crate::support::{G, WATER, advance, block, flow, gravity, largest_speed, tank, touch};
use fluid_solver::backend::pfem::wall::Grip;

const DEPTH: f64 = 0.3;

fn hydrostatic<const D: usize, const N: usize>(cells: [usize; D], grip: Grip, exact: bool, steps: usize) {
    let size = [DEPTH; D];
    let (mut cloud, walls) = (block::<D, N>(size, cells, 0.25), tank(size, grip));
    touch(&mut cloud, &walls);
    let pressure = |x: &[f64; D]| WATER.density * G * (DEPTH - x[D - 1]);
    if exact {
        cloud.pressure = cloud.place.iter().map(pressure).collect();
    }
    let start = cloud.place.clone();
    let tolerance = if exact { 1e-6 } else { 1e-12 };
    advance(&mut flow(WATER, tolerance), &mut cloud, &walls, &gravity(), 1e-3, 0..steps, |cloud, _| {
        assert!(largest_speed(cloud) <= 1e-10, "{:e}", largest_speed(cloud));
    });
    for (x, p) in cloud.place.iter().zip(&cloud.pressure) {
        assert!((p - pressure(x)).abs() <= 1e-9 * WATER.density * G * DEPTH, "{p} against {}", pressure(x));
    }
    for (x, start) in cloud.place.iter().zip(&start) {
        assert!((0..D).all(|k| (x[k] - start[k]).abs() <= 1e-10 * DEPTH));
    }
}

#[test]
fn a_tank_stays_flat_for_a_thousand_steps_in_the_plane_whatever_its_walls_hold() {
    hydrostatic::<2, 3>([9, 11], Grip::Slip, true, 1000);
    hydrostatic::<2, 3>([9, 11], Grip::NoSlip, true, 1000);
    hydrostatic::<2, 3>([9, 11], Grip::WallFunction, true, 1000);
}

#[test]
fn a_tank_stays_flat_for_a_thousand_steps_in_space_whatever_its_walls_hold() {
    hydrostatic::<3, 4>([5, 4, 6], Grip::Slip, true, 1000);
    hydrostatic::<3, 4>([5, 4, 6], Grip::NoSlip, true, 1000);
    hydrostatic::<3, 4>([5, 4, 6], Grip::WallFunction, true, 1000);
}

#[test]
fn the_hydrostatic_pressure_is_found_from_none() {
    hydrostatic::<2, 3>([9, 11], Grip::Slip, false, 10);
    hydrostatic::<2, 3>([9, 11], Grip::NoSlip, false, 10);
    hydrostatic::<3, 4>([5, 4, 6], Grip::Slip, false, 10);
    hydrostatic::<3, 4>([5, 4, 6], Grip::NoSlip, false, 10);
}
