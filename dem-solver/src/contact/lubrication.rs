//! Liquid that is squeezed out from between two bodies, or drawn in.

use std::f64::consts::PI;

use crate::lanes::Lanes;

/// No pair takes more than one over this of its relative momentum in a step. Equal spheres all around, 12 of them, have
/// Σ (n·e)² = 4 along any e: together they stop a grain at most, and do not throw it back.
const SHARE: f64 = 4.0;

/// F = 6 π μ_f R*² v_n/h, which pushes bodies apart that come nearer at v_n and holds those back that part, at gaps h below
/// the cut-off; below the roughness h counts as the roughness; where the bodies touch there is none. It is viscous:
/// friction does not feel it.
///
/// In a step Δt, with h that of its middle and v_n that of its start, c = 6 π μ_f R*²/h and q = c Δt/m*, the mean force is
/// c v_n/max(1 + q/2, 4 q): the rule of the midpoint, v_n/(1 + q/2) being the speed of the middle, up to where a pair would
/// lose more than a quarter of its momentum. Stable at any viscosity and any step; to resolve the approach is up to the step.
///
/// Source: Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261–290, leading order of squeezing; Davis, Serayssol & Hinch,
/// J. Fluid Mech. 163 (1986) 479–497, with roughness: restitution e (1 - St_c/St), St = m* v/(6 π μ_f R*²),
/// St_c = (1 + 1/e)(1 + ln(cut-off/roughness)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lubrication {
    /// Viscosity μ_f of the liquid \[Pa s\].
    pub viscosity: f64,
    /// Gap below which the force grows no more \[m\].
    pub roughness: f64,
    /// Gap from which on there is no force \[m\].
    pub cut_off: f64,
}

impl Lubrication {
    /// 6 π μ_f R*² of two bodies of this effective radius \[m\]: force times gap over speed \[N s\].
    pub fn strength(&self, effective_radius: f64) -> f64 {
        6.0 * PI * self.viscosity * effective_radius * effective_radius
    }

    /// Mean force of a step \[s\] that pushes two bodies apart, `closing` at v_n \[m/s\] when it starts, with this gap in
    /// its middle \[m\] \[N\].
    #[inline(always)]
    pub fn push<L: Lanes>(&self, strength: L, inverse_mass: L, gap: L, closing: L, step: L) -> L {
        let between = L::both(L::splat(0.0).less(gap), gap.less(L::splat(self.cut_off)));
        let damping = strength / gap.max(L::splat(self.roughness));
        let q = damping * inverse_mass * step;
        let slowed = (L::splat(1.0) + L::splat(0.5) * q).max(L::splat(SHARE) * q);
        (damping * closing / slowed).only(between)
    }
}
