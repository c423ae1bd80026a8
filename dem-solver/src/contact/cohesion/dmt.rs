//! Adhesion of small, hard spheres.

use std::f64::consts::PI;

use super::{Cohesion, CohesionConstants, Proximity};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// A = 2 π w R* as long as the bodies touch, w the pair's work of adhesion \[J/m²\]; the area of contact is that of
/// the normal law. Pull-off force 2 π w R*.
///
/// Friction follows F_p + A = F_n + 2 F_c, F_c the pull-off force.
///
/// `strength` is A. For μ = (w² R*/(E*² z₀³))^(1/3) < 0.1, z₀ the distance of atoms.
///
/// Source: Derjaguin, Muller & Toporov, J. Colloid Interface Sci. 53 (1975) 314–326; friction: Thornton, J. Phys. D 24
/// (1991) 1942–1946, as LAMMPS' `pair granular` has it.
#[derive(Clone, Copy, Debug)]
pub struct Dmt;

impl Cohesion for Dmt {
    const REMEMBERS: bool = false;

    fn constants(pair: &PairMaterial, effective_radius: f64, _: f64) -> CohesionConstants {
        let pull_off = 2.0 * PI * pair.work_of_adhesion * effective_radius;
        CohesionConstants { strength: pull_off, length: 0.0, reach: 0.0 }
    }

    #[inline(always)]
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, _: &Proximity<L>) -> L {
        constants.strength
    }

    #[inline(always)]
    fn jumps<L: Lanes>(constants: &CohesionConstants<L>) -> [L; 2] {
        [constants.strength; 2]
    }

    #[inline(always)]
    fn felt<L: Lanes>(_: &CohesionConstants<L>, attraction: L) -> L {
        -attraction
    }
}
