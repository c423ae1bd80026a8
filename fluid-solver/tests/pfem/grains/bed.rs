//! Beds that rest.

use super::scene::{Random, SIDE, Tank, defect, grains};
use crate::support::{G, WATER, largest_speed};
use fluid_solver::backend::pfem::wall::Grip;
use interface::frames::ReactionRow;

fn rest<const D: usize, const N: usize>(cells: usize, count: usize) {
    let mut tank = Tank::<D, N>::new(cells, Grip::NoSlip);
    let rows = grains::<D>(count, 0.5 * SIDE, &mut Random(1));
    tank.grains.populate(&tank.cloud, &rows).unwrap();
    let row = ReactionRow { exchange_coefficient: 1e6, ..ReactionRow::default() };
    for n in 0..100 {
        let (solution, ledger) = tank.window(1e-3, &rows, 1, |_| vec![row; count]);
        assert!(defect(&ledger) <= 1e-12, "{n}: {:e}", defect(&ledger));
        tank.commit(1e-3, &solution);
        assert!(largest_speed(&tank.cloud) <= 1e-10, "{n}: {:e}", largest_speed(&tank.cloud));
    }
    println!("half a bed of grains at rest in {D}D: {:.1e} m/s", largest_speed(&tank.cloud));
    for row in 0..count {
        let sample = tank.grains.sample(row);
        let slope = sample.pressure_gradient;
        assert!((slope[D - 1] / (-G * WATER.density) - 1.0).abs() < 1e-10, "{slope:?}");
        assert!(slope[0].abs() < 1e-10 * G * WATER.density && sample.wetted_fraction == 1.0);
        assert!(sample.void_fraction < 1.0);
    }
}

#[test]
fn half_a_tank_of_grains_with_huge_drag_does_not_stir_water_at_rest_in_the_plane() {
    rest::<2, 3>(12, 120);
}

#[test]
fn half_a_tank_of_grains_with_huge_drag_does_not_stir_water_at_rest_in_space() {
    rest::<3, 4>(6, 500);
}
