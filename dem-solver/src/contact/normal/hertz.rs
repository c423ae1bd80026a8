//! Hertz's contact with Mindlin's tangential stiffness.

use std::f64::consts::{FRAC_PI_4, PI};

use super::{Normal, linear_resolving_step};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::grains::volume;
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// Elastic spheres: F_n = max(0, 4/3 E* √(R* δ) δ + c_n δ'); S_n = 2 E* √(R* δ) its slope.
///
/// | symbol | code | 3D | 2D (cylinders of the slab's depth b) |
/// |---|---|---|---|
/// | k_n | `normal_stiffness` | 4/3 E* √R* · δ^(1/2) | π/4 E* b |
/// | k_t | `tangential_stiffness` | 8 G* √R* · δ^(1/2) | 4 G*/E* · k_n, the spheres' ratio of slopes |
/// | c_n | `normal_damping` | 2 √(5/6) ζ √(S_n m*) ∝ δ^(1/4) | 2 ζ √(k_n m*) |
/// | c_t | `tangential_damping` | 2 √(5/6) ζ √(k_t m*) ∝ δ^(1/4) | 2 ζ √(k_t m*) |
///
/// Source: Johnson, Contact Mechanics (1985), Eqs. 4.23 and 7.43; damping: Tsuji, Tanaka & Ishida, Powder
/// Technol. 71 (1992) 239–250, with ζ for a contact that does not pull ([`crate::contact::damping_ratio`]);
/// line contact: Popov, Contact Mechanics and Friction (2nd ed. 2017), Eq. 2.23.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hertz {
    /// Depth b of the slab \[m\] (2D).
    pub depth: f64,
}

/// Fraction of Rayleigh's time that a safety factor of 1 allows; at 0.5 it is the customary 0.2.
const FRACTION_OF_RAYLEIGH: f64 = 0.4;

impl<const D: usize> Normal<D> for Hertz {
    const ENDS_STIFF: bool = D == 2;

    #[inline]
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let (normal, tangential, normal_slope, tuning) = if D == 2 {
            let normal = FRAC_PI_4 * pair.effective_modulus * self.depth;
            (normal, 4.0 * pair.effective_shear_modulus / pair.effective_modulus * normal, normal, 1.0)
        } else {
            let root = effective_radius.sqrt();
            let normal = 4.0 / 3.0 * pair.effective_modulus * root;
            (normal, 8.0 * pair.effective_shear_modulus * root, 1.5 * normal, (5.0_f64 / 6.0).sqrt())
        };
        let damping = |slope: f64| 2.0 * tuning * pair.damping_ratio * (slope * effective_mass).sqrt();
        Coefficients {
            normal_stiffness: normal,
            normal_damping: damping(normal_slope),
            tangential_stiffness: tangential,
            tangential_damping: damping(tangential),
            sliding_friction: pair.sliding_friction,
            inverse_mass: 1.0 / effective_mass,
        }
    }

    #[inline(always)]
    fn growth<L: Lanes>(overlap: L) -> Growth<L> {
        if D == 2 {
            return Growth::none();
        }
        let inverse = overlap.inverse_fourth_root();
        let stiffness = overlap * (inverse * inverse);
        Growth { stiffness, damping: stiffness * inverse }
    }

    #[inline(always)]
    fn stored_energy<L: Lanes>(coefficients: &Coefficients<L>, overlap: L) -> L {
        let order = L::splat(if D == 2 { 0.5 } else { 0.4 });
        let stiffness = coefficients.normal_stiffness * <Self as Normal<D>>::growth(overlap).stiffness;
        order * stiffness * overlap * overlap
    }

    #[inline]
    fn slope(coefficients: &Coefficients, overlap: f64) -> f64 {
        let order = if D == 2 { 1.0 } else { 1.5 };
        order * coefficients.normal_stiffness * <Self as Normal<D>>::growth(overlap).stiffness
    }

    /// 3D: 0.4 t_R with Rayleigh's time t_R = π r √(ρ/G)/(0.1631 ν + 0.8766), in which a surface wave crosses the
    /// grain, and 2 (2 - ν) G* for the shear modulus: that is G where a grain touches its like
    /// (Li, Xu & Thornton, Powder Technol. 160 (2005) 219–228). 2D: as for any linear contact.
    fn resolving_step(&self, pair: &PairMaterial, poissons_ratio: f64, mass: f64, radius: f64) -> f64 {
        if D == 2 {
            let effective_mass = 0.5 * mass;
            let contact = Normal::<D>::coefficients(self, pair, 0.5 * radius, effective_mass);
            return linear_resolving_step(contact.normal_stiffness, effective_mass);
        }
        let nu = poissons_ratio;
        let shear_modulus = 2.0 * (2.0 - nu) * pair.effective_shear_modulus;
        let density = mass / volume::<D>(radius, self.depth);
        FRACTION_OF_RAYLEIGH * PI * radius * (density / shear_modulus).sqrt() / (0.1631 * nu + 0.8766)
    }
}
