//! Constant directional torque.

use super::{Resistance, Rolling, RollingConstants};
use crate::contact::coefficients::Coefficients;
use crate::lanes::{Lanes, Vec3};
use crate::material::PairMaterial;

/// T = μ_r R* k_n δ ω_r/|ω_r|, its part along n removed, as LIGGGHTS-PUBLIC 3.8.0 has it: the direction is that of the
/// whole relative spin ω_r, torsion included.
///
/// Source: Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011) 269–282, model A.
#[derive(Clone, Copy, Debug)]
pub struct Cdt;

impl Resistance for Cdt {
    const REMEMBERS: bool = false;

    fn stiffness_and_damping(_: &Coefficients, _: &PairMaterial, _: f64, _: f64) -> (f64, f64) {
        (0.0, 0.0)
    }

    #[inline(always)]
    fn torque<L: Lanes>(constants: &RollingConstants<L>, rolling: &Rolling<L>, _: &mut Vec3<L>) -> Vec3<L> {
        let squared = rolling.spin.norm_squared();
        let spins = L::splat(0.0).less(squared);
        let speed = L::select(spins, squared, L::splat(1.0)).sqrt();
        let torque =
            rolling.spin * (constants.friction * constants.effective_radius * rolling.elastic / speed);
        torque - rolling.normal * torque.dot(rolling.normal)
    }
}
