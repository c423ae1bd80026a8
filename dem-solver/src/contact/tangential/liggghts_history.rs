//! The tangential force of LIGGGHTS' `tangential history`.

use super::{Annuli, Sliding, Spring, Tangential, shortened};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::{Lanes, Vec3};

/// F_t = -k_t s - γ_t v_t below the limit μ |F_n|, as LIGGGHTS-PUBLIC 3.8.0 has it:
///
/// 1. s grows by v_t Δt, then loses its part along the normal; it is neither turned nor rescaled, also where k_t falls.
/// 2. Where |k_t s| > μ |F_n|, s is cut to that and the dashpot left out; |F_n| counts also where it pulls.
///
/// The memory is k_t s and k_t, as in [`super::Coulomb`].
#[derive(Clone, Copy, Debug)]
pub struct LiggghtsHistory;

impl Tangential for LiggghtsHistory {
    const REMEMBERS: bool = true;

    #[inline(always)]
    fn force<L: Lanes>(
        coefficients: &Coefficients<L>,
        growth: Growth<L>,
        sliding: &Sliding<L>,
        spring: &mut Spring<L>,
        _: &mut Annuli<L>,
    ) -> Vec3<L> {
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let before = L::select(L::splat(0.0).less(spring.stiffness), spring.stiffness, L::splat(1.0));
        let moved = spring.force * (stiffness / before) + sliding.velocity * (stiffness * sliding.step);
        let flat = moved - sliding.normal * moved.dot(sliding.normal);
        let held = shortened(flat, sliding.limit);
        *spring = Spring { force: held, stiffness, ..*spring };
        let slips = (sliding.limit * sliding.limit).less(flat.norm_squared());
        let damping = coefficients.tangential_damping * growth.damping;
        -held - sliding.velocity * L::select(slips, L::splat(0.0), damping)
    }
}
