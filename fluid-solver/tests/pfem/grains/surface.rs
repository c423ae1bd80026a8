//! Grains in the free surface.

use super::scene::{SIDE, Tank};
use crate::support::{WATER, block};
use fluid_solver::backend::pfem::grains::GrainsInCloud;
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::grains::Spreading;
use interface::frames::GrainRow;

const RADIUS: f64 = 0.009;

/// A grain at a height over the surface (m).
fn at<const D: usize>(height: f64) -> GrainRow {
    let mut position = std::array::from_fn(|k| if k < D { 0.43 * SIDE } else { 0.0 });
    position[D - 1] = SIDE + height;
    GrainRow { position, radius: RADIUS, mass: 1.0, ..GrainRow::default() }
}

/// Share of a grain below a plane this many radii over its centre.
fn share_below<const D: usize>(depth: f64) -> f64 {
    match D {
        2 => 0.5 + (depth.asin() + depth * (1.0 - depth * depth).sqrt()) / std::f64::consts::PI,
        _ => 0.25 * (2.0 + 3.0 * depth - depth.powi(3)),
    }
}

fn crossing<const D: usize, const N: usize>(cells: usize) {
    let mut tank = Tank::<D, N>::new(cells, Grip::Slip);
    let places = 400;
    let heights = (0..=places).map(|n| RADIUS * (1.5 - 3.0 * n as f64 / places as f64));
    let mut last: Option<(f64, [f64; 3])> = None;
    for height in heights {
        tank.grains.populate(&tank.cloud, &[at::<D>(height)]).unwrap();
        tank.grains.prepare_samples();
        let sample = tank.grains.sample(0);
        // Buoyancy by Archimedes.
        let depth = (-height / RADIUS).clamp(-1.0, 1.0);
        let below = share_below::<D>(depth);
        assert!((sample.wetted_fraction - below).abs() <= 1e-12, "{} {below}", sample.wetted_fraction);
        assert_eq!(sample.density == 0.0, below == 0.0);
        let spread = tank.grains.void_fraction().iter().zip(tank.grains.mesh().measure());
        let spread: f64 = spread.map(|(void, measure)| (1.0 - void) * measure).sum();
        let volume = match D {
            2 => std::f64::consts::PI * RADIUS.powi(2),
            _ => 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3),
        };
        assert!((spread - below * volume).abs() <= 1e-12 * volume, "{spread} {}", below * volume);
        let slope = sample.pressure_gradient.map(|slope| slope * sample.wetted_fraction);
        if let Some((fraction, force)) = last {
            assert!(sample.wetted_fraction >= fraction);
            // No jump: a place is 0.75 % of a radius from the next.
            let jump = (0..3).map(|k| (slope[k] - force[k]).abs()).fold(0.0, f64::max);
            assert!(jump <= 0.01 * 9810.0, "{height}: {jump}");
        }
        last = Some((sample.wetted_fraction, slope));
    }
}

#[test]
fn a_grain_that_sinks_through_the_surface_is_wet_by_its_share_below_without_a_jump() {
    crossing::<2, 3>(10);
    crossing::<3, 4>(5);
}

#[test]
fn a_grain_at_a_wall_under_water_is_wet() {
    let mut tank = Tank::<2, 3>::new(10, Grip::Slip);
    let grain = |x: f64| GrainRow { position: [x, 0.3 * SIDE, 0.0], ..at::<2>(0.0) };
    tank.grains.populate(&tank.cloud, &[grain(RADIUS), grain(0.5 * RADIUS), grain(-0.1 * RADIUS)]).unwrap();
    tank.grains.prepare_samples();
    for row in 0..3 {
        assert_eq!(tank.grains.sample(row).wetted_fraction, 1.0, "{row}");
    }
    tank.grains.populate(&tank.cloud, &[grain(-2.0 * RADIUS)]).unwrap();
    tank.grains.prepare_samples();
    assert_eq!(tank.grains.sample(0).wetted_fraction, 0.0);
}

/// A grain in the middle of a film.
fn in_film<const D: usize, const N: usize>(thickness: f64) {
    let mut size = [SIDE; D];
    size[D - 1] = thickness;
    let film = block::<D, N>(size, std::array::from_fn(|k| if k == D - 1 { 1 } else { 20 }), 0.0);
    let mut grains = GrainsInCloud::new(WATER, 1.0, film.place.len(), Spreading::Kernel);
    grains.forget(&film);
    grains.populate(&film, &[at::<D>(0.5 * thickness - SIDE)]).unwrap();
    grains.prepare_samples();
    let share = 2.0 * share_below::<D>(0.5 * thickness / RADIUS) - 1.0;
    let found = grains.sample(0).wetted_fraction;
    assert!((found - share).abs() <= 1e-12, "{found} {share}");
}

#[test]
fn of_a_grain_thicker_than_its_film_no_more_is_wet_than_lies_in_it() {
    in_film::<2, 3>(0.4 * RADIUS);
    in_film::<3, 4>(0.4 * RADIUS);
}
