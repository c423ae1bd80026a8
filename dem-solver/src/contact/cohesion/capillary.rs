//! Bridges of liquid.

use std::f64::consts::PI;

use super::{Cohesion, CohesionConstants, Proximity, divisor};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// A = 2 π R̄ γ cos θ/(1 + 1.05 ŝ + 2.5 ŝ²),  ŝ = s √(R̄/V),  s the gap, 0 where the bodies touch.
///
/// | symbol | | unit |
/// |---|---|---|
/// | R̄ | 2 R*: the radius of equal spheres, twice that of a sphere on a wall | m |
/// | γ | surface tension | N/m |
/// | θ | contact angle of liquid and solid | rad |
/// | V | volume of the bridge, the pair's ratio times r³ of the smaller sphere | m³ |
///
/// A bridge forms where bodies touch and lasts until the gap is s_c = (1 + θ/2) V^(1/3); the liquid is then back on the
/// bodies. Friction does not feel it: it follows the push of the solids, which bears A.
///
/// `strength` is 2 π R̄ γ cos θ, `length` √(V/R̄), `reach` s_c. For V < 0.1 R̄³, θ < 50°, grains so small that weight does not
/// shape the bridge (γ/(ρ g R̄²) > 1), and motion so slow that viscosity does not.
///
/// Source: Willett, Adams, Johnson & Seville, Langmuir 16 (2000) 9396–9405, their simple form, with Derjaguin's R̄ for unequal
/// bodies; s_c: Lian, Thornton & Adams, J. Colloid Interface Sci. 161 (1993) 138–147.
#[derive(Clone, Copy, Debug)]
pub struct Capillary;

impl Cohesion for Capillary {
    const REMEMBERS: bool = true;

    fn constants(pair: &PairMaterial, effective_radius: f64, smaller_radius: f64) -> CohesionConstants {
        let radius = 2.0 * effective_radius;
        let volume = pair.bridge_volume_ratio * smaller_radius.powi(3);
        CohesionConstants {
            strength: 2.0 * PI * radius * pair.surface_tension * pair.contact_angle.cos(),
            length: (volume / radius).sqrt(),
            reach: (1.0 + 0.5 * pair.contact_angle) * volume.cbrt(),
        }
    }

    #[inline(always)]
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, proximity: &Proximity<L>) -> L {
        constants.strength * falling(constants, (-proximity.overlap).max(L::splat(0.0)))
    }

    #[inline(always)]
    fn jumps<L: Lanes>(constants: &CohesionConstants<L>) -> [L; 2] {
        [constants.strength, constants.strength * falling(constants, constants.reach)]
    }

    #[inline(always)]
    fn felt<L: Lanes>(_: &CohesionConstants<L>, _: L) -> L {
        L::splat(0.0)
    }
}

/// The pull at this gap over that at touch.
#[inline(always)]
fn falling<L: Lanes>(constants: &CohesionConstants<L>, gap: L) -> L {
    let (one, scaled) = (L::splat(1.0), gap / divisor(constants.length));
    one / (one + scaled * (L::splat(1.05) + L::splat(2.5) * scaled))
}
