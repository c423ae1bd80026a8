//! Order of accuracy against exact solutions of the Navier–Stokes equations.

use crate::support::{advance, box_mesh, flow, l2_error, pressure_error};
use fluid_solver::backend::eulerian::Properties;
use fluid_solver::boundary::Condition;
use std::f64::consts::TAU;

/// Taylor–Green vortices decaying in a periodic square: errors of u and p at t = 1 with h and Δt ~ 1/n.
fn taylor_green(n: usize) -> (f64, f64) {
    let viscosity = 0.05;
    let properties = Properties { density: 1.0, viscosity, gravity: [0.0; 2], tolerance: 1e-8 };
    let mesh = box_mesh::<2, 3>([0.0; 2], [TAU; 2], [n, n], [true; 2], Some(0.2));
    let mut flow = flow(mesh, properties, |_| Condition::NoSlip);
    let velocity = move |x: &[f64; 2], t: f64| {
        let decay = (-2.0 * viscosity * t).exp();
        [x[0].sin() * x[1].cos() * decay, -x[0].cos() * x[1].sin() * decay]
    };
    let pressure = move |x: &[f64; 2], t: f64| {
        0.25 * ((2.0 * x[0]).cos() + (2.0 * x[1]).cos()) * (-4.0 * viscosity * t).exp()
    };
    flow.set_velocity(|x| velocity(x, 0.0));
    let start: Vec<f64> = flow.mesh().nodes().iter().map(|x| pressure(x, 0.0)).collect();
    flow.state_mut().pressure.copy_from_slice(&start);
    let iterations = advance(&mut flow, 0.0, 1.0 / n as f64, n, |_, _| ());
    println!("n {n}: {} iterations a step", iterations as f64 / n as f64);
    let errors = (
        l2_error(flow.mesh(), &flow.state().velocity, |x| velocity(x, 1.0)),
        pressure_error(flow.mesh(), &flow.state().pressure, |x| pressure(x, 1.0)),
    );
    errors
}

#[test]
fn taylor_green_vortices_are_second_order_in_velocity() {
    let errors = [16, 32, 64].map(taylor_green);
    for pair in errors.windows(2) {
        let order = (pair[0].0 / pair[1].0).log2();
        println!("{:?} order u {order} p {}", pair, (pair[0].1 / pair[1].1).log2());
        assert!(order >= 1.9, "{order}");
    }
}
