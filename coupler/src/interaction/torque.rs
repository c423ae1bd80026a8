//! The viscous torque on a grain that spins otherwise than the fluid.

use std::array::from_fn;
use std::f64::consts::PI;

use super::Shape;
use super::exchange::Relaxation;

/// Rotational exchange coefficient \[N m s\] of T = c(ω_f/2 − ω), ω_f = ∇×u, creeping flow.
///
/// π μ d³ of a sphere (Kirchhoff 1876), π μ d²·depth of a disc (Lamb 1932, §333).
pub fn rotational_coefficient(shape: Shape, diameter: f64, viscosity: f64) -> f64 {
    match shape {
        Shape::Sphere => PI * viscosity * diameter * diameter * diameter,
        Shape::Disc { depth } => PI * viscosity * diameter * diameter * depth,
    }
}

/// Mean torque \[N m\] of the exact relaxation of the spin over a window: c(ω_f/2 − ω)(1 − e^−x)/x, x = cΔt/I.
///
/// `angular_velocity` is the spin when the window opens; the spin never overshoots the fluid's, whatever Δt.
pub fn viscous_torque(
    coefficient: f64,
    vorticity: [f64; 3],
    angular_velocity: [f64; 3],
    moment_of_inertia: f64,
    window: f64,
) -> [f64; 3] {
    let mean = Relaxation::over(coefficient * window / moment_of_inertia).mean;
    from_fn(|k| coefficient * mean * (0.5 * vorticity[k] - angular_velocity[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_window_feels_the_torque_of_a_rotating_sphere() {
        let coefficient = rotational_coefficient(Shape::Sphere, 2e-3, 1e-3);
        let torque = viscous_torque(coefficient, [0.0; 3], [0.0, 0.0, 5.0], 1e-12, 1e-12);
        let kirchhoff = -8.0 * PI * 1e-3 * 1e-9 * 5.0;
        assert!((torque[2] / kirchhoff - 1.0).abs() < 1e-10, "{torque:?}");
    }

    #[test]
    fn over_a_long_window_a_grain_takes_the_spin_of_the_fluid_and_no_more() {
        let (inertia, window) = (3e-13, 1e4);
        let coefficient = rotational_coefficient(Shape::Disc { depth: 0.1 }, 1e-3, 1e-3);
        let torque = viscous_torque(coefficient, [0.0, 0.0, 8.0], [0.0, 0.0, 1.0], inertia, window);
        let spin = 1.0 + torque[2] * window / inertia;
        assert!((spin - 4.0).abs() < 1e-14, "{spin}");
    }
}
