//! The normal force of LIGGGHTS' `model hooke`.

use super::{Hooke, Normal, liggghts, linear_resolving_step};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::contact::restitution::pulling_damping_ratio;
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// F_n = k_n δ + γ_n δ' as LIGGGHTS-PUBLIC 3.8.0 has it (`limitForce off`, `ktToKnUser off`), which pulls at the end
/// of a damped contact; spheres only.
///
/// | symbol | formula |
/// |---|---|
/// | k_n = k_t | 16/15 √R* E* (15 m* V²/(16 √R* E*))^(1/5) |
/// | γ_n = γ_t | 2 ζ √(k_n m*) |
///
/// ζ = -ln e/√(ln² e + π²), the lever arms are r - δ/2 at spheres and walls alike, and δ' is the speed half a step
/// before δ, as velocity Verlet has it there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiggghtsHooke {
    /// LIGGGHTS' `characteristicVelocity` V \[m/s\].
    pub characteristic_velocity: f64,
}

impl<const D: usize> Normal<D> for LiggghtsHooke {
    const ENDS_STIFF: bool = true;

    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let hertz = 16.0 / 15.0 * effective_radius.sqrt() * pair.effective_modulus;
        let stiffness = hertz * (effective_mass * self.characteristic_velocity.powi(2) / hertz).powf(0.2);
        let damping = 2.0 * pulling_damping_ratio(pair.restitution) * (stiffness * effective_mass).sqrt();
        Coefficients {
            normal_stiffness: stiffness,
            normal_damping: damping,
            tangential_stiffness: stiffness,
            tangential_damping: damping,
            sliding_friction: pair.sliding_friction,
            inverse_mass: 1.0 / effective_mass,
        }
    }

    #[inline(always)]
    fn growth<L: Lanes>(overlap: L) -> Growth<L> {
        <Hooke as Normal<D>>::growth(overlap)
    }

    #[inline(always)]
    fn force<L: Lanes>(coefficients: &Coefficients<L>, overlap: L, closing: L, _: L) -> L {
        liggghts::force::<D, Self, L>(coefficients, overlap, closing)
    }

    #[inline(always)]
    fn arm<L: Lanes>(radius: L, overlap: L, _: L) -> L {
        liggghts::arm(radius, overlap)
    }

    #[inline(always)]
    fn wall_spin<L: Lanes>(radius: L, overlap: L) -> L {
        liggghts::wall_spin(radius, overlap)
    }

    #[inline(always)]
    fn stored_energy<L: Lanes>(coefficients: &Coefficients<L>, overlap: L) -> L {
        <Hooke as Normal<D>>::stored_energy(coefficients, overlap)
    }

    #[inline]
    fn slope(coefficients: &Coefficients, overlap: f64) -> f64 {
        <Hooke as Normal<D>>::slope(coefficients, overlap)
    }

    fn resolving_step(&self, pair: &PairMaterial, _: f64, mass: f64, radius: f64) -> f64 {
        let effective_mass = 0.5 * mass;
        let contact = Normal::<D>::coefficients(self, pair, 0.5 * radius, effective_mass);
        linear_resolving_step(contact.normal_stiffness, effective_mass)
    }
}
