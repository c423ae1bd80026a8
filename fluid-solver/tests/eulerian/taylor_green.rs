//! Order of accuracy for decaying periodic vortices: Taylor & Green in the plane, Antuono in space.
//!
//! Both solve the Navier–Stokes equations, for their convection is a gradient, which the pressure takes.

use crate::support::{advance, box_mesh, flow, l2_error, pressure_error};
use fluid_solver::backend::eulerian::Properties;
use fluid_solver::boundary::Condition;
use std::f64::consts::{FRAC_PI_6, TAU};

const VISCOSITY: f64 = 0.05;

/// Velocity and pressure of fluid of density 1 in a periodic box of side 2π at t = 0; u decays as e^−kνt, p as e^−2kνt.
struct Vortices<const D: usize> {
    velocity: fn(&[f64; D]) -> [f64; D],
    pressure: fn(&[f64; D]) -> f64,
    decay: f64,
}

/// Taylor & Green (1937): u = (sin x cos y, −cos x sin y), p = (cos 2x + cos 2y)/4.
const PLANE: Vortices<2> = Vortices {
    velocity: |x| [x[0].sin() * x[1].cos(), -x[0].cos() * x[1].sin()],
    pressure: |x| 0.25 * ((2.0 * x[0]).cos() + (2.0 * x[1]).cos()),
    decay: 2.0,
};

/// Antuono (2020) J. Fluid Mech. 890:A23: ∇×u = √3 u, p = −u²/2, root mean square speed 1.
const SPACE: Vortices<3> = Vortices {
    velocity: antuono,
    pressure: |x| -0.5 * antuono(x).iter().map(|u| u * u).sum::<f64>(),
    decay: 3.0,
};

/// u_x = 4√2/(3√3) \[sin(x − 5π/6) cos(y − π/6) sin z − cos(z − 5π/6) sin(x − π/6) sin y\], and cyclically.
fn antuono(x: &[f64; 3]) -> [f64; 3] {
    let component = |[x, y, z]: [f64; 3]| {
        let forth = (x - 5.0 * FRAC_PI_6).sin() * (y - FRAC_PI_6).cos() * z.sin();
        let back = (z - 5.0 * FRAC_PI_6).cos() * (x - FRAC_PI_6).sin() * y.sin();
        4.0 * 2.0_f64.sqrt() / 27.0_f64.sqrt() * (forth - back)
    };
    std::array::from_fn(|k| component(std::array::from_fn(|m| x[(k + m) % 3])))
}

/// Errors of u and p at t = 1, root mean squares over the box, with h and Δt ~ 1/n.
fn errors<const D: usize, const N: usize>(vortices: &Vortices<D>, n: usize) -> [f64; 2] {
    let properties = Properties { density: 1.0, viscosity: VISCOSITY, gravity: [0.0; D], tolerance: 1e-8 };
    let mesh = box_mesh::<D, N>([0.0; D], [TAU; D], [n; D], [true; D], Some(0.2));
    let mut flow = flow(mesh, properties, |_| Condition::NoSlip);
    flow.set_velocity(vortices.velocity);
    let start: Vec<f64> = flow.mesh().nodes().iter().map(vortices.pressure).collect();
    flow.state_mut().pressure.copy_from_slice(&start);
    advance(&mut flow, 0.0, 1.0 / n as f64, n, |_, _| ());

    let left = (-vortices.decay * VISCOSITY).exp();
    let (mesh, state) = (flow.mesh(), flow.state());
    let velocity = l2_error(mesh, &state.velocity, |x| (vortices.velocity)(x).map(|u| left * u));
    let pressure = pressure_error(mesh, &state.pressure, |x| left * left * (vortices.pressure)(x));
    [velocity, pressure].map(|error| error / TAU.powf(0.5 * D as f64))
}

/// Orders of u between successive levels; prints the errors.
#[allow(clippy::print_stdout, reason = "the errors are figures of the documentation")]
fn orders<const D: usize, const N: usize>(vortices: &Vortices<D>, levels: [usize; 3]) -> [f64; 2] {
    let errors = levels.map(|n| errors::<D, N>(vortices, n));
    for (n, [velocity, pressure]) in levels.iter().zip(errors) {
        println!("{D}D, {n} cells a side: error of u {velocity:.3e}, of p {pressure:.3e}");
    }
    let order = |coarse: usize, fine: usize| {
        let refinement = levels[fine] as f64 / levels[coarse] as f64;
        (errors[coarse][0] / errors[fine][0]).ln() / refinement.ln()
    };
    let orders = [order(0, 1), order(1, 2)];
    println!("{D}D: orders of u {orders:.2?}");
    orders
}

#[test]
fn vortices_in_the_plane_are_second_order_in_velocity() {
    let orders = orders::<2, 3>(&PLANE, [16, 32, 64]);
    assert!(orders.iter().all(|&order| order >= 1.9), "{orders:?}");
}

#[test]
fn vortices_in_space_are_second_order_in_velocity() {
    let orders = orders::<3, 4>(&SPACE, [8, 16, 24]);
    assert!(orders.iter().all(|&order| order >= 1.9), "{orders:?}");
}
