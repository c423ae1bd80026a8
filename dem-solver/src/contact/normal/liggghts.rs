//! What the normal laws of LIGGGHTS share.

use super::Normal;
use crate::contact::coefficients::Coefficients;
use crate::lanes::Lanes;

/// F_n = k(δ) δ + γ(δ) δ' as LIGGGHTS-PUBLIC 3.8.0 has it with `limitForce off`: it pulls at the end of a damped
/// contact.
#[inline(always)]
pub fn force<const D: usize, N: Normal<D>, L: Lanes>(
    coefficients: &Coefficients<L>,
    overlap: L,
    closing: L,
) -> L {
    let growth = N::growth(overlap);
    coefficients.normal_stiffness * growth.stiffness * overlap
        + coefficients.normal_damping * growth.damping * closing
}

/// Lever arm r - δ/2, at spheres and walls alike \[m\].
#[inline(always)]
pub fn arm<L: Lanes>(radius: L, overlap: L) -> L {
    radius - overlap * L::splat(0.5)
}

/// Lever arm over distance from the wall: the spin relative to a wall over the sphere's own.
#[inline(always)]
pub fn wall_spin<L: Lanes>(radius: L, overlap: L) -> L {
    arm(radius, overlap) / (radius - overlap)
}
