//! The normal force of LIGGGHTS' `model hertz`.

use super::{Hertz, Normal, liggghts};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::contact::restitution::pulling_damping_ratio;
use crate::lanes::Lanes;
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
    const ENDS_STIFF: bool = D == 2;

    fn coefficients(&self, pair: &PairMaterial, effective_radius: f64, effective_mass: f64) -> Coefficients {
        let damping_ratio = pulling_damping_ratio(pair.restitution);
        let pair = PairMaterial { damping_ratio, ..*pair };
        Normal::<D>::coefficients(&HERTZ, &pair, effective_radius, effective_mass)
    }

    #[inline(always)]
    fn growth<L: Lanes>(overlap: L) -> Growth<L> {
        <Hertz as Normal<D>>::growth(overlap)
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
