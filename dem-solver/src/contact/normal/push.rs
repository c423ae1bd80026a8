//! A normal force that never pulls and keeps to the stated restitution at finite substeps.

use super::Normal;
use crate::contact::coefficients::Coefficients;

/// δ^(1/4), which Hertz's damping grows with, has its mean over a touch that begins at δ = 0 at this fraction of the
/// last overlap: (4/5)⁴.
const MEAN_POINT: f64 = 0.4096;

/// F_n = max(0, k δ + c̃ δ'), k and c at δ, and c̃ such that the substep h leaves the damping ratio alone.
///
/// 1. δ' is that of the start of the substep, δ that of its middle. With δ' = δ'_middle + F_n h/(2 m*) the contact
///    swings as one of k/(1 - ε) and c̃/(1 - ε), ε = c̃ h/(2 m*). Its damping ratio is that of k and c for
///    c̃ = c (√(1 + q²) - q), q = c h/(4 m*); c/(1 + q) is that to q²/2. The force at rest stays k δ.
/// 2. Where δ < δ' h the bodies met since the middle of the last substep. When this one ends they have been in touch
///    for f h, f = 1/2 + δ/(δ' h), and overlap by f δ' h. The impulse is that of all of this time: of the spring
///    U(f δ' h)/δ', U its stored energy, of the dashpot f h times the mean of c, times δ'. A contact then gains no
///    energy wherever in a substep it begins.
#[inline]
pub fn push<const D: usize, N: Normal<D>>(
    coefficients: &Coefficients,
    overlap: f64,
    closing: f64,
    step: f64,
) -> f64 {
    let approach = closing * step;
    let (elastic, growth) = if overlap < approach {
        let touched = 0.5 + overlap / approach;
        let reached = touched * approach;
        let mean_growth = N::growth(MEAN_POINT * reached).damping;
        (N::stored_energy(coefficients, reached) / approach, touched * mean_growth)
    } else {
        let growth = N::growth(overlap);
        (coefficients.normal_stiffness * growth.stiffness * overlap, growth.damping)
    };
    let damping = coefficients.normal_damping * growth;
    let viscous = damping * closing / (1.0 + damping * step / (4.0 * coefficients.effective_mass));
    (elastic + viscous).max(0.0)
}
