//! Elastic–plastic spring and dashpot.

use super::{Resistance, Rolling, RollingConstants};
use crate::contact::coefficients::Coefficients;
use crate::contact::tangential::shortened;
use crate::lanes::{Lanes, Vec3};
use crate::material::PairMaterial;

/// T = T_k + c_r ω_t, dT_k/dt = k_r ω_t, |T_k| ≤ μ_r R* |F_n|, as LIGGGHTS-PUBLIC 3.8.0 has it: ω_t is the relative
/// spin without its part along n, T_k does not turn with the contact, and at the limit the dashpot is left out.
///
/// | symbol | formula |
/// |---|---|
/// | k_r | 2.25 k_n(δ) (μ_r R*)² |
/// | c_r | 2 η √(I k_r), I = 1.4 m r² of a sphere, 1.5 m r² in 2D; of two the harmonic sum |
///
/// Source: Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011) 269–282, model C; k_r: Iwashita & Oda, J. Eng. Mech. 124
/// (1998) 285–292.
#[derive(Clone, Copy, Debug)]
pub struct Epsd;

impl Resistance for Epsd {
    const REMEMBERS: bool = true;

    fn stiffness_and_damping(
        coefficients: &Coefficients,
        pair: &PairMaterial,
        effective_radius: f64,
        inertia: f64,
    ) -> (f64, f64) {
        let arm = pair.rolling_friction * effective_radius;
        let stiffness = 2.25 * coefficients.normal_stiffness * arm * arm;
        (stiffness, 2.0 * pair.rolling_damping_ratio * (inertia * stiffness).sqrt())
    }

    #[inline(always)]
    fn torque<L: Lanes>(
        constants: &RollingConstants<L>,
        rolling: &Rolling<L>,
        torque: &mut Vec3<L>,
    ) -> Vec3<L> {
        let spin = rolling.spin - rolling.normal * rolling.spin.dot(rolling.normal);
        let strained = *torque + spin * (constants.stiffness * rolling.growth.stiffness * rolling.step);
        let limit = constants.friction * constants.effective_radius * rolling.pressing;
        *torque = shortened(strained, limit);
        let yields = (limit * limit).less(strained.norm_squared());
        let damping = constants.damping * rolling.growth.damping;
        *torque + spin * L::select(yields, L::splat(0.0), damping)
    }
}
