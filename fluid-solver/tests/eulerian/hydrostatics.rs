//! A fluid at rest stays at rest.

use crate::support::{advance, box_mesh, flow, largest_speed};
use fluid_solver::backend::eulerian::Properties;
use fluid_solver::boundary::Condition;

const TOLERANCE: f64 = 1e-8;

fn rest<const D: usize, const N: usize>(cells: [usize; D], open: bool) {
    let mut gravity = [0.0; D];
    gravity[D - 1] = -9.81;
    gravity[0] = 1.3;
    let properties = Properties { density: 998.2, viscosity: 1e-3, gravity, tolerance: TOLERANCE };
    let mesh = box_mesh::<D, N>([0.0; D], [0.3; D], cells, [false; D], Some(0.2));
    let top = if D == 2 { "y-max" } else { "z-max" };
    let mut flow = flow(mesh, properties, |name| match name {
        name if name == top && open => Condition::Outlet { pressure: 1e5 },
        "x-min" => Condition::Slip,
        _ => Condition::NoSlip,
    });
    // A void fraction that jumps from 0.4 to 1 across one row of cells.
    let void: Vec<f64> =
        flow.mesh().nodes().iter().map(|x| if x[D - 1] < 0.14 { 0.4 } else { 1.0 }).collect();
    flow.state_mut().reset_void_fraction(&void);
    advance(&mut flow, 0.0, 1e-3, 3, |_, _| ());
    assert!(largest_speed(&flow) <= 1e-10, "{:e}", largest_speed(&flow));
    advance(&mut flow, 3e-3, 1e-3, 97, |_, _| ());
    assert!(largest_speed(&flow) <= 1e-10, "{:e}", largest_speed(&flow));
}

#[test]
fn a_jump_of_void_fraction_does_not_stir_a_fluid_at_rest_in_the_plane() {
    rest::<2, 3>([10, 12], true);
    rest::<2, 3>([10, 12], false);
}

#[test]
fn a_jump_of_void_fraction_does_not_stir_a_fluid_at_rest_in_space() {
    rest::<3, 4>([4, 5, 6], true);
    rest::<3, 4>([4, 5, 6], false);
}
