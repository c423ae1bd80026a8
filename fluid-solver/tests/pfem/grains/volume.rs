//! Grains displace fluid.

use super::scene::{SIDE, Tank};
use crate::support::largest_speed;
use fluid_solver::backend::pfem::wall::Grip;
use interface::frames::{GrainRow, ReactionRow};
use std::f64::consts::PI;

const RADIUS: f64 = 0.009;

/// A row of grains pushed down through the surface.
fn pushed<const D: usize>(height: f64) -> Vec<GrainRow> {
    let grain = |n: usize| {
        let mut position = std::array::from_fn(|k| if k < D { 0.43 * SIDE } else { 0.0 });
        (position[0], position[D - 1]) = (SIDE * (0.2 + 0.2 * n as f64), SIDE + height);
        GrainRow { id: n as u64, position, radius: RADIUS, mass: f64::INFINITY, ..GrainRow::default() }
    };
    (0..4).map(grain).collect()
}

fn displaced<const D: usize, const N: usize>(cells: usize, steps: usize) {
    let mut tank = Tank::<D, N>::new(cells, Grip::Slip);
    let before = tank.volume();
    tank.grains.populate(&tank.cloud, &pushed::<D>(1.1 * RADIUS)).unwrap();
    let (length, way) = (2e-3, 3.2 * RADIUS);
    let reactions = vec![ReactionRow::default(); 4];
    for n in 1..=steps {
        let rows = pushed::<D>(1.1 * RADIUS - way * n as f64 / steps as f64);
        let (solution, _) = tank.window(length, &rows, 3, |_| reactions.clone());
        tank.commit(length, &solution);
    }
    let solid = 4.0
        * match D {
            2 => PI * RADIUS.powi(2),
            _ => 4.0 / 3.0 * PI * RADIUS.powi(3),
        };
    let gained = tank.volume() - before;
    assert_eq!(tank.grains.wetted_volume(), solid);
    assert!((gained / solid - 1.0).abs() <= 2e-3, "{gained:e} of {solid:e}");
    assert!(largest_speed(&tank.cloud) < 0.5);
}

#[test]
fn the_water_rises_by_the_volume_of_the_grains_pushed_into_it() {
    displaced::<2, 3>(10, 60);
    displaced::<3, 4>(6, 30);
}
