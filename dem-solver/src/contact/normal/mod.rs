//! Normal contact laws.

mod hertz;
mod hooke;

use super::coefficients::{Coefficients, Growth};
use crate::material::PairMaterial;

pub use hertz::Hertz;
pub use hooke::Hooke;

/// A law for the normal force of two bodies in contact,
///
/// F_n = max(0, k(δ) δ + c(δ) δ'),  δ overlap, δ' its rate, k(δ) = k₁ s(δ), c(δ) = c₁ √s(δ) in [`Growth`]:
///
/// it pushes or vanishes, and never pulls.
pub trait Normal<const D: usize>: Copy + Send + Sync {
    /// The constants of two bodies of effective radius R* \[m\] and effective mass m* \[kg\].
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients;

    /// Growth of stiffness and damping at this overlap \[m\].
    fn growth(overlap: f64) -> Growth;

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
    /// `"none"`: grains pass through each other and through walls.
    None,
}

/// Steps in one linear contact: the fewest that a safety factor of 1 allows, half of the customary 30.
const STEPS_PER_CONTACT: f64 = 15.0;

/// t_c/15 with t_c = π √(m*/k_n), the duration of an undamped linear contact \[s\].
fn linear_resolving_step(stiffness: f64, effective_mass: f64) -> f64 {
    std::f64::consts::PI * (effective_mass / stiffness).sqrt() / STEPS_PER_CONTACT
}
