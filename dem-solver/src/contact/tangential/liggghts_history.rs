//! The tangential force of LIGGGHTS' `tangential history`.

use super::{Sliding, Spring, Tangential, shortened};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::vector::Vector;

/// F_t = -k_t s - γ_t v_t below the limit μ |F_n|, as LIGGGHTS-PUBLIC 3.8.0 has it:
///
/// 1. s grows by v_t Δt, then loses its part along the normal; it is neither turned nor rescaled, also where k_t falls.
/// 2. Where |k_t s| > μ |F_n|, s is cut to that and the dashpot left out; |F_n| counts also where it pulls.
#[derive(Clone, Copy, Debug)]
pub struct LiggghtsHistory;

impl<const D: usize> Tangential<D> for LiggghtsHistory {
    const REMEMBERS: bool = true;

    #[inline]
    fn force(
        coefficients: &Coefficients,
        growth: Growth,
        sliding: &Sliding<D>,
        spring: &mut Spring<D>,
    ) -> Vector<D> {
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let moved = spring.elongation + sliding.velocity * sliding.step;
        let flat = moved - sliding.normal * moved.dot(&sliding.normal);
        let elongation = shortened(flat, sliding.limit / stiffness);
        *spring = Spring { elongation, stiffness };
        if elongation == flat {
            -elongation * stiffness - sliding.velocity * (coefficients.tangential_damping * growth.damping)
        } else {
            -elongation * stiffness
        }
    }
}
