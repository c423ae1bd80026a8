//! Unlike grains: their restitution is the stated one.

use super::finding::Finding;
use super::{Effort, impact, laws};

const RATIOS: [f64; 7] = [1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3];
const RADIUS: f64 = 1e-3;
const YOUNGS_MODULUS: f64 = 1e8;
const SPEED: f64 = 0.1;
const RESTITUTION: f64 = 0.8;
/// Relative to the stated restitution.
const TOLERANCE: f64 = 1e-3;

/// Young's modulus of the second grain over that of the first.
pub fn of_stiffness(_: Effort) -> Vec<Finding> {
    each(|ratio| ([YOUNGS_MODULUS, YOUNGS_MODULUS * ratio], (RADIUS, RADIUS)))
}

/// Radius of the second grain over that of the first.
pub fn of_size(_: Effort) -> Vec<Finding> {
    each(|ratio| ([YOUNGS_MODULUS; 2], (RADIUS, RADIUS * ratio)))
}

fn each(grains: impl Fn(f64) -> ([f64; 2], (f64, f64))) -> Vec<Finding> {
    let with_law = |(name, law)| {
        RATIOS.map(|ratio| {
            let (moduli, radii) = grains(ratio);
            let scene = laws::spheres(law, &moduli, RESTITUTION, 0.0);
            let found = impact::restitution(scene, radii, SPEED, 0.5);
            let allowed = RESTITUTION * (1.0 - TOLERANCE)..=RESTITUTION * (1.0 + TOLERANCE);
            Finding::number(format!("{name}, {ratio:e}"), "restitution", found, allowed)
        })
    };
    laws::own().into_iter().flat_map(with_law).collect()
}
