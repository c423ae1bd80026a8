//! Linear contact of an effective area.

use std::f64::consts::PI;

use super::{Hooke, Normal, linear_resolving_step};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// Two bodies as a bar between their centres, of the effective area Ā = α π r_c² and the length d = r_i + r_j:
/// F_n = max(0, K_n δ + C_n δ'), with [`crate::contact::tangential::Coulomb`].
///
/// | symbol | code | unit | formula |
/// |---|---|---|---|
/// | K_n, 3D | `normal_stiffness` | N/m | E Ā/d = α π E R*, r_c² = r_i r_j; on a wall d = r_c = r |
/// | K_n, 2D | | N/m | α E b: Ā = 2 α r_c b of the slab's depth b, r_c = d/2 |
/// | C_n | `normal_damping` | N s/m | 2 ξ √(m* K_n) |
/// | K_s | `tangential_stiffness` | N/m | K_n/(2 (1 + ν)) |
/// | C_s | `tangential_damping` | N s/m | 2 ξ √(m* K_s) |
///
/// E of two materials is that of two halves in a row, 2/(1/E_i + 1/E_j), ν the mean. ξ follows from the restitution
/// ([`crate::contact::damping_ratio`]).
///
/// Source: Idelsohn, Oñate & Becker (2017), Eqs. 109–115; Oñate et al., Comput. Part. Mech. 2 (2015) 139–160.
/// Departures: their C_n makes of ξ no damping ratio, here it is one; they leave r_c open, say nothing of walls and unlike
/// materials, and name the damping of shear without a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Onate {
    /// α, for packings that are not optimal; about 1.
    pub area_factor: f64,
    /// Depth b of the slab \[m\] (2D).
    pub depth: f64,
}

impl<const D: usize> Normal<D> for Onate {
    const ENDS_STIFF: bool = true;

    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let area_over_length = if D == 2 { self.depth } else { PI * effective_radius };
        let normal = self.area_factor * pair.youngs_modulus * area_over_length;
        let tangential = normal / (2.0 * (1.0 + pair.poissons_ratio));
        let damping = |k: f64| 2.0 * pair.damping_ratio * (k * effective_mass).sqrt();
        Coefficients {
            normal_stiffness: normal,
            normal_damping: damping(normal),
            tangential_stiffness: tangential,
            tangential_damping: damping(tangential),
            sliding_friction: pair.sliding_friction,
            inverse_mass: 1.0 / effective_mass,
        }
    }

    #[inline(always)]
    fn growth<L: Lanes>(overlap: L) -> Growth<L> {
        <Hooke as Normal<D>>::growth(overlap)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Material;

    #[test]
    fn two_unlike_grains_have_the_constants_of_the_formulas() {
        let soft = Material { density: 2500.0, youngs_modulus: 2e6, poissons_ratio: 0.2 };
        let hard = Material { density: 2500.0, youngs_modulus: 6e6, poissons_ratio: 0.3 };
        let pair = PairMaterial::new(&soft, &hard, 0.5, 0.4);
        let (i, j, mass) = (1e-3_f64, 3e-3, 2e-5_f64);
        let found =
            Normal::<3>::coefficients(&Onate { area_factor: 0.9, depth: 1.0 }, &pair, i * j / (i + j), mass);
        // 0.9 · 3 MPa · π · 3 mm² / 4 mm, and 1/(2 · 1.25) of it.
        let (normal, shear) = (6_361.725_123_519_331, 2_544.690_049_407_732_5);
        assert!((found.normal_stiffness / normal - 1.0).abs() < 1e-14, "{}", found.normal_stiffness);
        assert!((found.tangential_stiffness / shear - 1.0).abs() < 1e-14);
        let xi = pair.damping_ratio;
        assert!((found.normal_damping / (2.0 * xi * (mass * normal).sqrt()) - 1.0).abs() < 1e-14);
        assert!((found.tangential_damping / (2.0 * xi * (mass * shear).sqrt()) - 1.0).abs() < 1e-14);
        let discs =
            Normal::<2>::coefficients(&Onate { area_factor: 0.9, depth: 0.5 }, &pair, i * j / (i + j), mass);
        assert!((discs.normal_stiffness / (0.9 * 3e6 * 0.5) - 1.0).abs() < 1e-14);
    }
}
