//! Elastic–plastic spring as stiff as the tangential one.

use super::{Epsd, Resistance, Rolling, RollingConstants};
use crate::contact::coefficients::Coefficients;
use crate::lanes::{Lanes, Vec3};
use crate::material::PairMaterial;

/// [`Epsd`] with k_r = k_t(δ) R*² and without dashpot, as LIGGGHTS-PUBLIC 3.8.0 has it.
#[derive(Clone, Copy, Debug)]
pub struct Epsd2;

impl Resistance for Epsd2 {
    const REMEMBERS: bool = true;

    fn stiffness_and_damping(
        coefficients: &Coefficients,
        _: &PairMaterial,
        effective_radius: f64,
        _: f64,
    ) -> (f64, f64) {
        (coefficients.tangential_stiffness * effective_radius * effective_radius, 0.0)
    }

    #[inline(always)]
    fn torque<L: Lanes>(
        constants: &RollingConstants<L>,
        rolling: &Rolling<L>,
        torque: &mut Vec3<L>,
    ) -> Vec3<L> {
        Epsd::torque(constants, rolling, torque)
    }
}
