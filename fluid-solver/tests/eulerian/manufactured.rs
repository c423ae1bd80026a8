//! Order of accuracy with a void fraction that varies in space and time, by manufactured solutions.

use crate::support::{advance, box_mesh, flow, given, l2_error, pressure_error};
use fluid_solver::backend::eulerian::Properties;
use std::f64::consts::PI;

const DENSITY: f64 = 1.3;

/// ε, the volume flux q = εu with ∇·q = −∂ε/∂t, and p.
#[derive(Clone, Copy)]
struct Solution<const D: usize> {
    void_fraction: fn(&[f64; D], f64) -> f64,
    flux: fn(&[f64; D], f64) -> [f64; D],
    pressure: fn(&[f64; D], f64) -> f64,
    viscosity: f64,
}

impl<const D: usize> Solution<D> {
    fn velocity(&self, x: &[f64; D], t: f64) -> [f64; D] {
        (self.flux)(x, t).map(|q| q / (self.void_fraction)(x, t))
    }

    /// b = [∂(ρεu)/∂t + ∇·(ρε u⊗u) + ε∇p − ε∇·τ]/(ρε).
    fn body_force(&self, x: &[f64; D], t: f64) -> [f64; D] {
        let void = (self.void_fraction)(x, t);
        std::array::from_fn(|k| {
            let momentum = |x: &[f64; D], t: f64| DENSITY * (self.flux)(x, t)[k];
            let inertia = derivative(|s| momentum(x, t + s));
            let convection: f64 =
                (0..D).map(|m| slope(m, x, &|x| momentum(x, t) * self.velocity(x, t)[m])).sum();
            let pressure = void * slope(k, x, &|x| (self.pressure)(x, t));
            let u = |l: usize| move |x: &[f64; D]| self.velocity(x, t)[l];
            let stress: f64 = (0..D)
                .map(|m| {
                    let laplacian = slope(m, x, &|x| slope(m, x, &u(k)));
                    let cross = slope(m, x, &|x| slope(k, x, &u(m)));
                    laplacian + cross / 3.0
                })
                .sum();
            (inertia + convection + pressure - void * self.viscosity * stress) / (DENSITY * void)
        })
    }
}

/// Central difference of fourth order.
fn derivative(f: impl Fn(f64) -> f64) -> f64 {
    const H: f64 = 2e-3;
    (8.0 * (f(H) - f(-H)) - (f(2.0 * H) - f(-2.0 * H))) / (12.0 * H)
}

fn slope<const D: usize>(axis: usize, x: &[f64; D], f: &dyn Fn(&[f64; D]) -> f64) -> f64 {
    derivative(|s| {
        let mut shifted = *x;
        shifted[axis] += s;
        f(&shifted)
    })
}

/// Errors of u and p at the end, with h and Δt ~ 1/n.
fn errors<const D: usize, const N: usize>(solution: Solution<D>, n: usize) -> (f64, f64) {
    const END: f64 = 0.5;
    let properties =
        Properties { density: DENSITY, viscosity: solution.viscosity, gravity: [0.0; D], tolerance: 1e-8 };
    let mesh = box_mesh::<D, N>([0.0; D], [1.0; D], [n; D], [false; D], Some(0.1));
    let mut flow = flow(mesh, properties, |_| given(move |x, t| solution.velocity(x, t)));
    let nodes = flow.mesh().nodes().to_vec();
    let at = |t: f64| -> Vec<f64> { nodes.iter().map(|x| (solution.void_fraction)(x, t)).collect() };
    flow.state_mut().reset_void_fraction(&at(0.0));
    flow.set_velocity(|x| solution.velocity(x, 0.0));
    flow.state_mut().pressure = nodes.iter().map(|x| (solution.pressure)(x, 0.0)).collect();
    advance(&mut flow, 0.0, END / n as f64, n, |flow, t| {
        flow.state_mut().void_fraction.copy_from_slice(&at(t));
        flow.set_body_force(|x| solution.body_force(x, t));
    });
    (
        l2_error(flow.mesh(), &flow.state().velocity, |x| solution.velocity(x, END)),
        pressure_error(flow.mesh(), &flow.state().pressure, |x| (solution.pressure)(x, END)),
    )
}

fn orders<const D: usize, const N: usize>(solution: Solution<D>, levels: &[usize]) -> Vec<(f64, f64)> {
    let errors: Vec<(f64, f64)> = levels.iter().map(|&n| errors::<D, N>(solution, n)).collect();
    errors.windows(2).map(|pair| ((pair[0].0 / pair[1].0).log2(), (pair[0].1 / pair[1].1).log2())).collect()
}

fn plane(viscosity: f64) -> Solution<2> {
    Solution {
        void_fraction: |x, t| 0.7 + 0.2 * (PI * x[0]).sin() * (PI * x[1]).sin() * t.cos(),
        flux: |x, t| {
            let ((sx, cx), (sy, cy)) = ((PI * x[0]).sin_cos(), (PI * x[1]).sin_cos());
            let (swirl, swell) = (0.5 * (1.0 + 0.5 * t.sin()), -0.1 / PI * t.sin());
            [swirl * sx * cy + swell * cx * sy, -swirl * cx * sy + swell * sx * cy]
        },
        pressure: |x, t| (PI * x[0]).cos() * (PI * x[1]).sin() * t.cos(),
        viscosity,
    }
}

fn space(viscosity: f64) -> Solution<3> {
    Solution {
        void_fraction: |x, t| 0.7 + 0.2 * (PI * x[0]).sin() * (PI * x[1]).sin() * (PI * x[2]).sin() * t.cos(),
        flux: |x, t| {
            let [(sx, cx), (sy, cy), (sz, cz)] = x.map(|x| (PI * x).sin_cos());
            let (swirl, swell) = (0.5 * (1.0 + 0.5 * t.sin()), -0.2 / (3.0 * PI) * t.sin());
            [
                swirl * sx * cy + swell * cx * sy * sz,
                -swirl * cx * sy + swell * sx * cy * sz,
                swirl * cx * cy + swell * sx * sy * cz,
            ]
        },
        pressure: |x, t| (PI * x[0]).cos() * (PI * x[1]).sin() * (PI * x[2]).sin() * t.cos(),
        viscosity,
    }
}

#[test]
fn velocity_is_second_order_under_a_moving_void_fraction_in_the_plane() {
    for viscosity in [0.1, 1e-3] {
        let orders = orders::<2, 3>(plane(viscosity), &[8, 16, 32]);
        assert!(orders[1].0 >= 1.9 && orders[1].1 >= 1.4, "viscosity {viscosity}: {orders:?}");
    }
}

#[test]
fn velocity_is_second_order_under_a_moving_void_fraction_in_space() {
    let orders = orders::<3, 4>(space(0.02), &[4, 8, 16]);
    assert!(orders[1].0 >= 1.9 && orders[1].1 >= 1.4, "{orders:?}");
}
