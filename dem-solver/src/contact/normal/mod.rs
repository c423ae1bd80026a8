//! Normal contact laws.

mod hertz;
mod hooke;
mod liggghts;
mod liggghts_hertz;
mod liggghts_hooke;
mod onate;
mod push;

use super::coefficients::{Coefficients, Growth};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

use push::push;

pub use hertz::Hertz;
pub use hooke::Hooke;
pub use liggghts_hertz::LiggghtsHertz;
pub use liggghts_hooke::LiggghtsHooke;
pub use onate::Onate;

/// A law for the normal force of two bodies in contact,
///
/// F_n = k(δ) δ + c(δ) δ',  δ overlap, δ' its rate, k(δ) = k₁ s(δ), c(δ) = c₁ √s(δ) in [`Growth`].
pub trait Normal<const D: usize>: Copy + Send + Sync {
    /// Whether the contact is stiff up to its end: k(δ) does not vanish with δ.
    const ENDS_STIFF: bool;

    /// The constants of two bodies of effective radius R* \[m\] and effective mass m* \[kg\].
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients;

    /// Growth of stiffness and damping at this overlap \[m\].
    fn growth<L: Lanes>(overlap: L) -> Growth<L>;

    /// Mean normal force in a substep \[s\], positive where the bodies push each other apart \[N\], at the overlap
    /// \[m\] of its middle and the closing speed δ' \[m/s\] of its start.
    ///
    /// Unless a law says otherwise it pushes or vanishes, never pulls, and keeps to the stated restitution.
    #[inline(always)]
    fn force<L: Lanes>(coefficients: &Coefficients<L>, overlap: L, closing: L, step: L) -> L {
        push::<D, Self, L>(coefficients, overlap, closing, step)
    }

    /// Distance from the centre of a body of this radius at which surface speed and friction are taken \[m\]; `share`
    /// is the body's share r/(r_i + r_j) of the sum of the two radii, 0 on a wall.
    ///
    /// Unless a law says otherwise r - share δ: the two arms add up to the distance, so that no angular momentum is
    /// lost, two spheres gear as ω_i r_i = -ω_j r_j, and on a wall rolling is v = ω r, at any overlap.
    #[inline(always)]
    fn arm<L: Lanes>(radius: L, overlap: L, share: L) -> L {
        radius - share * overlap
    }

    /// Spin relative to a wall at rest, as resistance to rolling counts it, over the body's own: 1 unless a law says
    /// otherwise.
    #[inline(always)]
    fn wall_spin<L: Lanes>(_radius: L, _overlap: L) -> L {
        L::splat(1.0)
    }

    /// Energy stored in the normal spring, ∫₀^δ k(δ) δ dδ \[J\].
    fn stored_energy<L: Lanes>(coefficients: &Coefficients<L>, overlap: L) -> L;

    /// Slope of the elastic force, d(k(δ) δ)/dδ \[N/m\].
    fn slope(coefficients: &Coefficients, overlap: f64) -> f64;

    /// The longest step that resolves a contact of two equal bodies of mass `mass` \[kg\] and `radius` \[m\] \[s\].
    fn resolving_step(&self, pair: &PairMaterial, poissons_ratio: f64, mass: f64, radius: f64) -> f64;
}

/// The normal laws a case can name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NormalLaw {
    /// `"hooke"`: [`Hooke`].
    Hooke(Hooke),
    /// `"hertz"`: [`Hertz`].
    Hertz(Hertz),
    /// `"hertz"` with `tangential-law = "partial-slip"`: [`Hertz`] of spheres, with
    /// [`crate::contact::tangential::PartialSlip`].
    HertzPartialSlip(Hertz),
    /// `"onate"`: [`Onate`].
    Onate(Onate),
    /// `"liggghts-hooke"`: [`LiggghtsHooke`], with [`crate::contact::tangential::LiggghtsHistory`].
    LiggghtsHooke(LiggghtsHooke),
    /// `"liggghts-hertz"`: [`LiggghtsHertz`], with [`crate::contact::tangential::LiggghtsHistory`].
    LiggghtsHertz(LiggghtsHertz),
    /// `"none"`: grains pass through each other and through walls.
    None,
}

/// Steps in one linear contact: the fewest that a safety factor of 1 allows; at 0.5 they are 36, and the restitution
/// is met to 1e-3 wherever in a substep the contact begins.
const STEPS_PER_CONTACT: f64 = 18.0;

/// t_c/18 with t_c = π √(m*/k_n), the duration of an undamped linear contact \[s\].
fn linear_resolving_step(stiffness: f64, effective_mass: f64) -> f64 {
    std::f64::consts::PI * (effective_mass / stiffness).sqrt() / STEPS_PER_CONTACT
}
