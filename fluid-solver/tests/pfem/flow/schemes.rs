//! The schemes measured against each other.

use crate::flow::waves::Wave;
use crate::support::{WATER, advance, block, gravity, largest_speed, tank, touch, volume};
use fluid_solver::backend::pfem::flow::{Control, Flow, Scheme};
use fluid_solver::backend::pfem::wall::Grip;
use std::f64::consts::PI;

const SCHEMES: [Scheme; 3] = [Scheme::Monolithic, Scheme::Segregated, Scheme::FractionalStep];

/// A tank that starts from its hydrostatic pressure.
fn speed_at_rest<const D: usize, const N: usize>(cells: [usize; D], scheme: Scheme) -> f64 {
    let (mut cloud, walls) = (block::<D, N>([0.3; D], cells, 0.25), tank([0.3; D], Grip::Slip));
    touch(&mut cloud, &walls);
    cloud.pressure = cloud.place.iter().map(|x| WATER.density * 9.81 * (0.3 - x[D - 1])).collect();
    let mut flow = Flow::new(WATER, Control { scheme, ..Control::default() });
    advance(&mut flow, &mut cloud, &walls, &gravity(), 1e-3, 0..100, |_, _| ());
    largest_speed(&cloud)
}

#[test]
fn a_tank_is_at_rest_with_every_scheme() {
    for scheme in SCHEMES {
        let (plane, space) =
            (speed_at_rest::<2, 3>([9, 11], scheme), speed_at_rest::<3, 4>([4, 3, 5], scheme));
        println!("at rest, {scheme:?}: {plane:.1e} m/s in the plane, {space:.1e} m/s in space");
        assert!(plane <= 1e-10 && space <= 1e-10, "{scheme:?}: {plane:e} {space:e} m/s");
    }
}

/// Error of the period and of the volume, amplitude left, largest residual and linear iterations of two periods of a wave.
fn wave(scheme: Scheme) -> [f64; 5] {
    let wave = Wave { depth: 0.5, cells: [20, 10], grading: 1.0, amplitude: 5e-3 };
    let exact = 2.0 * PI / (9.81 * PI * (PI * wave.depth).tanh()).sqrt();
    let (length, walls) = (exact / 100.0, tank([1.0, 1.0], Grip::Slip));
    let mut cloud = wave.cloud();
    touch(&mut cloud, &walls);
    cloud.pressure = cloud.place.iter().map(|x| WATER.density * 9.81 * (wave.depth - x[1])).collect();
    let start = volume(&cloud);
    let (mut series, mut residual, mut change, mut iterations) =
        (vec![wave.coefficient(&cloud)], 0.0f64, 0.0f64, 0.0);
    let mut flow = Flow::new(WATER, Control { scheme, ..Control::default() });
    advance(&mut flow, &mut cloud, &walls, &gravity(), length, 0..203, |cloud, solution| {
        series.push(wave.coefficient(cloud));
        residual = residual.max(solution.residuals.momentum.hypot(solution.residuals.volume));
        change = change.max((volume(cloud) / start - 1.0).abs());
        iterations += solution.iterations as f64;
    });
    let zeros = super::waves::zeros(&series, length);
    let left = series[175..].iter().fold(0.0f64, |max, a| max.max(a.abs()));
    [(zeros[3] - zeros[1]) / exact - 1.0, change, left, residual, iterations]
}

#[test]
fn three_corrections_are_as_good_as_the_whole_system_on_a_wave_and_the_segregated_scheme_damps_it() {
    let [whole, segregated, corrected] = SCHEMES.map(wave);
    assert!(corrected[4] < 0.7 * whole[4], "the cheap one costs {} of {} iterations", corrected[4], whole[4]);
    for [period, change, left, ..] in [whole, corrected] {
        assert!(period.abs() <= 8e-3 && change <= 1e-6 && (left - 1.0).abs() <= 0.01);
    }
    // Backward Euler: π²/100 a period; and what the scheme leaves of its equations is there to be seen.
    assert!((0.75..0.87).contains(&segregated[2]), "{}", segregated[2]);
    assert!(segregated[3] > 10.0 * whole[3] && segregated[1] > 10.0 * whole[1]);
}
