//! A grain in a periodic box: the velocity that its images give it, for `cases/settling-sphere-periodic`.

use std::f64::consts::{PI, TAU};

use super::oseen::tests::exact_sphere_mobility;
use crate::interaction::Shape;
use crate::interaction::drag::{Drag, Slip};

const DENSITY: f64 = 1000.0;
const VISCOSITY: f64 = 89.053e-3;
const DIAMETER: f64 = 1e-3;
const GRAIN_DENSITY: f64 = 2500.0;
const GRAVITY: f64 = 5.886;

/// (1/L³) Σ_{k≠0} (1 − k_z²/k²) μk²/(μ²k⁴ + ρ²U²k_z²) e^−σ²k² \[m/(N s)\], k = 2π(i, j, l)/L.
///
/// The velocity along z, sampled at a grain, of the fluid that a unit force along z on it and each of its images drives,
/// in a stream of speed U along z and without a mean velocity; Hasimoto (1959) J. Fluid Mech. 5:317 has U = 0, σ → 0.
fn lattice_mobility(side: f64, speed: f64, width: f64) -> f64 {
    let last = (6.2 * side / (TAU * width)) as i32;
    let mut sum = 0.0;
    for i in -last..=last {
        for j in -last..=last {
            for l in -last..=last {
                if (i, j, l) == (0, 0, 0) {
                    continue;
                }
                let along = TAU * f64::from(l) / side;
                let square = f64::from(i * i + j * j + l * l) * (TAU / side).powi(2);
                let (viscous, inertial) = (VISCOSITY * square, DENSITY * speed * along);
                let green = viscous / (viscous * viscous + inertial * inertial);
                sum += (1.0 - along * along / square) * green * (-width * width * square).exp();
            }
        }
    }
    sum / (side * side * side)
}

/// The images' part: the lattice less the grain itself in unbounded fluid \[m/(N s)\].
fn images_mobility(side: f64, speed: f64, width: f64) -> f64 {
    let reynolds = DENSITY * speed * width / VISCOSITY;
    let own = exact_sphere_mobility(reynolds) / (6.0 * PI.powf(1.5) * VISCOSITY * width);
    lattice_mobility(side, speed, width) - own
}

/// Slip at which Schiller & Naumann's drag is the given force \[m/s\].
fn slip_under(force: f64) -> f64 {
    let coefficient = |speed: f64| {
        Drag::SchillerNaumann.exchange_coefficient(&Slip {
            speed,
            diameter: DIAMETER,
            volume: Shape::Sphere.volume(0.5 * DIAMETER),
            void_fraction: 1.0,
            density: DENSITY,
            viscosity: VISCOSITY,
        })
    };
    (0..60).fold(0.0, |speed, _| force / coefficient(speed))
}

/// Terminal speed in a box of 12 kernel widths a side, seen from where grain and fluid together have no momentum.
fn terminal_speed(width: f64) -> f64 {
    let (side, volume) = (12.0 * width, Shape::Sphere.volume(0.5 * DIAMETER));
    let force = GRAIN_DENSITY * volume * GRAVITY;
    let mean_flow = GRAIN_DENSITY * volume / (DENSITY * (side.powi(3) - volume));
    let free = slip_under(force);
    (0..20).fold(free, |speed, _| (free + force * images_mobility(side, speed, width)) / (1.0 + mean_flow))
}

/// −2.8373/(6πμL), Hasimoto's constant, and 4π(σ/L)² for the width of the kernels.
#[test]
fn images_in_creeping_flow_are_those_of_hasimoto() {
    for widths in [12.0, 24.0] {
        let (side, width) = (widths * DIAMETER, DIAMETER);
        let found = images_mobility(side, 0.0, width) * 6.0 * PI * VISCOSITY * side;
        let hasimoto = -2.837_297 + 4.0 * PI / (widths * widths);
        assert!((found - hasimoto).abs() < 1e-5, "{widths}: {found}, Hasimoto {hasimoto}");
    }
}

#[test]
fn the_case_expects_the_law_less_its_images() {
    let checks = include_str!("../../../../cases/settling-sphere-periodic/check.toml");
    let references = checks.lines().filter_map(|line| line.strip_prefix("reference = -"));
    let references: Vec<f64> = references.map(|number| number.parse().unwrap()).collect();
    assert_eq!(references.len(), 3);
    for (widths, reference) in [1.0, 2.0, 4.0].into_iter().zip(references) {
        let found = terminal_speed(widths * DIAMETER);
        assert!((found / reference - 1.0).abs() < 1e-6, "h/d = {widths}: {found}, check.toml {reference}");
    }
}
