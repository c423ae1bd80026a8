//! The same bits.

use crate::support::{WATER, advance, block, flow, gravity, newtonian, tank, touch};
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::wall::Grip;

fn collapsed(viscosity: f64, grip: Grip) -> Cloud<3, 4> {
    let mut cloud = block::<3, 4>([0.1; 3], [18, 16, 18], 0.25);
    let walls = tank([0.4, 0.1, 0.1], grip);
    touch(&mut cloud, &walls);
    let mut flow = flow(newtonian(1000.0, viscosity), 1e-6);
    advance(&mut flow, &mut cloud, &walls, &gravity(), 1e-3, 0..2, |_, _| ());
    cloud
}

#[test]
fn one_two_and_four_threads_give_the_same_bits() {
    for (viscosity, grip) in [(1e-3, Grip::NoSlip), (100.0, Grip::NoSlip), (1e-3, Grip::WallFunction)] {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| collapsed(viscosity, grip))
        };
        let one = with(1);
        assert!(one == with(2) && one == with(4));
    }
}

#[test]
fn what_was_solved_before_leaves_no_trace() {
    let start = || {
        let mut cloud = block::<2, 3>([0.1; 2], [8, 8], 0.25);
        let walls = tank([0.4, 0.1], Grip::Slip);
        touch(&mut cloud, &walls);
        (cloud, walls)
    };
    let (mut through, walls) = start();
    advance(&mut flow(WATER, 1e-6), &mut through, &walls, &gravity(), 1e-3, 0..6, |_, _| ());
    let mut stopped = start().0;
    advance(&mut flow(WATER, 1e-6), &mut stopped, &walls, &gravity(), 1e-3, 0..3, |_, _| ());
    let mut other = flow(WATER, 1e-6);
    // A solver that has seen a longer step of another cloud.
    advance(&mut other, &mut start().0, &walls, &gravity(), 2e-3, 0..2, |_, _| ());
    advance(&mut other, &mut stopped, &walls, &gravity(), 1e-3, 3..6, |_, _| ());
    assert!(through == stopped);
}
