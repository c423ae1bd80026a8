//! Linear spring and dashpot.

use std::f64::consts::FRAC_PI_4;

use super::{Normal, linear_resolving_step};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// Linear contact: F_n = max(0, k_n δ + c_n δ').
///
/// | symbol | code | unit | formula |
/// |---|---|---|---|
/// | k_n, 3D | `normal_stiffness` | N/m | 16/15 √R* E* (15 m* V²/(16 √R* E*))^(1/5): the largest overlap at speed V is that of a Hertz contact |
/// | k_n, 2D | | N/m | π/4 E* b: line contact of the slab's depth b, the same at every speed |
/// | c_n | `normal_damping` | N s/m | 2 ζ √(k_n m*) |
/// | k_t | `tangential_stiffness` | N/m | 2/7 k_n: a rolling contact of spheres then swings as fast sideways as it rebounds |
/// | c_t | `tangential_damping` | N s/m | 2 ζ √(k_t m*) |
///
/// Source: Cundall & Strack, Géotechnique 29 (1979) 47–65; k_t: Schäfer, Dippel & Wolf, J. Phys. I France 6
/// (1996) 5–20; line contact: Popov, Contact Mechanics and Friction (2nd ed. 2017), Eq. 2.23.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hooke {
    /// Speed V of the impact that is as deep as Hertz's \[m/s\] (3D).
    pub characteristic_velocity: f64,
    /// Depth b of the slab \[m\] (2D).
    pub depth: f64,
}

impl<const D: usize> Normal<D> for Hooke {
    const ENDS_STIFF: bool = true;

    #[inline]
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let stiffness = if D == 2 {
            FRAC_PI_4 * pair.effective_modulus * self.depth
        } else {
            let hertz = 16.0 / 15.0 * effective_radius.sqrt() * pair.effective_modulus;
            hertz * (effective_mass * self.characteristic_velocity.powi(2) / hertz).powf(0.2)
        };
        let tangential_stiffness = 2.0 / 7.0 * stiffness;
        let damping = |k: f64| 2.0 * pair.damping_ratio * (k * effective_mass).sqrt();
        Coefficients {
            normal_stiffness: stiffness,
            normal_damping: damping(stiffness),
            tangential_stiffness,
            tangential_damping: damping(tangential_stiffness),
            sliding_friction: pair.sliding_friction,
            inverse_mass: 1.0 / effective_mass,
        }
    }

    #[inline(always)]
    fn growth<L: Lanes>(_: L) -> Growth<L> {
        Growth::none()
    }

    #[inline(always)]
    fn stored_energy<L: Lanes>(coefficients: &Coefficients<L>, overlap: L) -> L {
        L::splat(0.5) * coefficients.normal_stiffness * overlap * overlap
    }

    #[inline]
    fn slope(coefficients: &Coefficients, _: f64) -> f64 {
        coefficients.normal_stiffness
    }

    fn resolving_step(&self, pair: &PairMaterial, _: f64, mass: f64, radius: f64) -> f64 {
        let effective_mass = 0.5 * mass;
        let contact = Normal::<D>::coefficients(self, pair, 0.5 * radius, effective_mass);
        linear_resolving_step(contact.normal_stiffness, effective_mass)
    }
}
