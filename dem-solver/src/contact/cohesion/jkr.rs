//! Adhesion of large, soft spheres.

use std::f64::consts::PI;

use super::{Cohesion, CohesionConstants, Proximity, divisor};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// Hertz's force at the radius a of the contact less √(8 π w E* a³), with w the pair's work of adhesion \[J/m²\]:
///
/// F = 4 E* a³/(3 R*) - √(8 π w E* a³),  δ = a²/R* - √(2 π w a/E*).
///
/// Bodies meet at δ = 0, where a contact springs open, and are torn apart at δ = -3 ℓ, ℓ = a_t²/R*,
/// a_t³ = π w R*²/(8 E*), with 5/9 of the pull-off force F_c = 3/2 π w R*. In x = √(a/a_t) all is
///
/// δ = ℓ (x⁴ - 4 x),  a²/R* = ℓ x⁴,  A = π w R* x³.
///
/// Friction follows F_n + 2 F_c.
///
/// | constant | |
/// |---|---|
/// | `strength` | π w R* |
/// | `length` | ℓ |
/// | `reach` | 3 ℓ |
///
/// Spheres (3D) with a normal law of Hertz only. For μ = (w² R*/(E*² z₀³))^(1/3) > 5, z₀ the distance of atoms.
///
/// Source: Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301–313; friction: Thornton, J. Phys. D 24 (1991)
/// 1942–1946, as LAMMPS' `pair granular` has it.
#[derive(Clone, Copy, Debug)]
pub struct Jkr;

impl Cohesion for Jkr {
    const REMEMBERS: bool = true;

    fn constants(pair: &PairMaterial, effective_radius: f64, _: f64) -> CohesionConstants {
        let strength = PI * pair.work_of_adhesion * effective_radius;
        let torn = (strength * effective_radius / (8.0 * pair.effective_modulus)).cbrt();
        let length = torn * torn / effective_radius;
        CohesionConstants { strength, length, reach: 3.0 * length }
    }

    #[inline(always)]
    fn indentation<L: Lanes>(constants: &CohesionConstants<L>, overlap: L) -> L {
        let x = root(overlap / divisor(constants.length));
        let square = x * x;
        let adheres = L::splat(0.0).less(constants.length);
        L::select(adheres, constants.length * (square * square), overlap)
    }

    #[inline(always)]
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, proximity: &Proximity<L>) -> L {
        let x = root(proximity.overlap / divisor(constants.length));
        constants.strength * (x * x * x)
    }

    #[inline(always)]
    fn jumps<L: Lanes>(constants: &CohesionConstants<L>) -> [L; 2] {
        [L::splat(4.0 / 3.0) * constants.strength, L::splat(5.0 / 6.0) * constants.strength]
    }

    #[inline(always)]
    fn felt<L: Lanes>(constants: &CohesionConstants<L>, attraction: L) -> L {
        attraction - L::splat(3.0) * constants.strength
    }
}

/// The root x ≥ 1 of x⁴ - 4 x = d, d ≥ -3, to rounding: four of Newton's steps from √(1 + √(d + 3)), which is at most 9 %
/// of x - 1 too large where the root is double, and less than 5 % of x elsewhere. All steps but for rounding come from above.
#[inline(always)]
fn root<L: Lanes>(d: L) -> L {
    let (one, four) = (L::splat(1.0), L::splat(4.0));
    let mut x = (one + (d + L::splat(3.0)).max(L::splat(0.0)).sqrt()).sqrt();
    for _ in 0..4 {
        let cube = x * x * x;
        // At the double root x = 1 both are 0.
        let slope = (four * (cube - one)).max(L::splat(1e-8));
        x = (x - (cube * x - four * x - d) / slope).max(one);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_is_found_to_rounding() {
        for k in 0..4000 {
            let x = 1.0 + 1e-6 * 1.01_f64.powi(k);
            if x > 1e8 {
                break;
            }
            // Near the double root x itself is known to √ε only.
            let known = 1e-15 / (1.0 - 1.0 / x.powi(3)) + 1e-15;
            let found = root(x.powi(4) - 4.0 * x);
            assert!((found / x - 1.0).abs() < 2.0 * known, "{x}: {found}");
        }
        assert!((root(-3.0_f64) - 1.0).abs() < 1e-8);
    }
}
