//! The normal force of LIGGGHTS' `model hertz`.

use super::{Hertz, Normal};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::contact::restitution::pulling_damping_ratio;
use crate::material::PairMaterial;

/// F_n = k_n δ + γ_n δ' as LIGGGHTS-PUBLIC 3.8.0 has it (`limitForce off`), which pulls at the end of a damped
/// contact; spheres only.
///
/// | symbol | formula |
/// |---|---|
/// | k_n | 4/3 E* √(R* δ) |
/// | k_t | 8 G* √(R* δ) |
/// | γ_n | 2 √(5/6) ζ √(2 E* √(R* δ) m*) |
/// | γ_t | 2 √(5/6) ζ √(k_t m*) |
///
/// ζ = -ln e/√(ln² e + π²), the lever arms are r - δ/2 at spheres and walls alike, and δ' is the speed half a step
/// before δ, as velocity Verlet has it there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiggghtsHertz;

/// Whose stiffness, growth and resolution it has.
const HERTZ: Hertz = Hertz { depth: 1.0 };

impl<const D: usize> Normal<D> for LiggghtsHertz {
    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let damping_ratio = pulling_damping_ratio(pair.restitution);
        let pair = PairMaterial { damping_ratio, ..*pair };
        Normal::<D>::coefficients(&HERTZ, &pair, effective_radius, effective_mass)
    }

    #[inline]
    fn growth(overlap: f64) -> Growth {
        <Hertz as Normal<D>>::growth(overlap)
    }

    #[inline]
    fn force(coefficients: &Coefficients, overlap: f64, closing: f64, _: f64) -> f64 {
        let growth = <Self as Normal<D>>::growth(overlap);
        coefficients.normal_stiffness * growth.stiffness * overlap
            + coefficients.normal_damping * growth.damping * closing
    }

    #[inline]
    fn arm(radius: f64, overlap: f64, _: f64) -> f64 {
        radius - 0.5 * overlap
    }

    #[inline]
    fn stored_energy(coefficients: &Coefficients, overlap: f64) -> f64 {
        <Hertz as Normal<D>>::stored_energy(coefficients, overlap)
    }

    #[inline]
    fn slope(coefficients: &Coefficients, overlap: f64) -> f64 {
        <Hertz as Normal<D>>::slope(coefficients, overlap)
    }

    fn resolving_step(&self, pair: &PairMaterial, poissons_ratio: f64, mass: f64, radius: f64) -> f64 {
        Normal::<D>::resolving_step(&HERTZ, pair, poissons_ratio, mass, radius)
    }
}
