//! Normal contact laws.

mod hertz;
mod hooke;
mod liggghts_hertz;
mod liggghts_hooke;
mod push;

use super::coefficients::{Coefficients, Growth};
use crate::material::PairMaterial;

use push::push;

pub use hertz::Hertz;
pub use hooke::Hooke;
pub use liggghts_hertz::LiggghtsHertz;
pub use liggghts_hooke::LiggghtsHooke;

/// A law for the normal force of two bodies in contact,
///
/// F_n = k(δ) δ + c(δ) δ',  δ overlap, δ' its rate, k(δ) = k₁ s(δ), c(δ) = c₁ √s(δ) in [`Growth`].
pub trait Normal<const D: usize>: Copy + Send + Sync {
    /// The constants of two bodies of effective radius R* \[m\] and effective mass m* \[kg\].
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients;

    /// Growth of stiffness and damping at this overlap \[m\].
    fn growth(overlap: f64) -> Growth;

    /// Mean normal force in a substep \[s\], positive where the bodies push each other apart \[N\], at the overlap
    /// \[m\] of its middle and the closing speed δ' \[m/s\] of its start.
    ///
    /// Unless a law says otherwise it pushes or vanishes, never pulls, and keeps to the stated restitution.
    #[inline]
    fn force(coefficients: &Coefficients, overlap: f64, closing: f64, step: f64) -> f64 {
        push::<D, Self>(coefficients, overlap, closing, step)
    }

    /// Distance from the centre of a body of this radius at which surface speed and friction are taken \[m\]; `reach`
    /// is the sum of the two radii, infinite for a wall.
    ///
    /// Unless a law says otherwise r (1 - δ/reach): the two arms add up to the distance, so that no angular
    /// momentum is lost, two spheres gear as ω_i r_i = -ω_j r_j, and on a wall rolling is v = ω r, at any overlap.
    #[inline]
    fn arm(radius: f64, overlap: f64, reach: f64) -> f64 {
        radius * (1.0 - overlap / reach)
    }

    /// Energy stored in the normal spring, ∫₀^δ k(δ) δ dδ \[J\].
    fn stored_energy(coefficients: &Coefficients, overlap: f64) -> f64;

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
