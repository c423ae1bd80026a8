//! An area that grows with the overlap.

use std::f64::consts::PI;

use super::{Bodies, Cohesion, CohesionConstants, Proximity};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// A = k times an area, k the pair's density of cohesive energy \[J/m³\], all of it felt by friction: LIGGGHTS-PUBLIC
/// 3.8.0, `cohesion sjkr2`, with d the distance of the centres and δ the overlap:
///
/// | | area |
/// |---|---|
/// | spheres | 4 π R* δ, δ = r_i + r_j - d |
/// | wall | 2 π r δ, δ = r - d: half of what spheres of the same R* have |
///
/// `strength` is k.
#[derive(Clone, Copy, Debug)]
pub struct Sjkr2;

impl Cohesion for Sjkr2 {
    const REMEMBERS: bool = false;

    fn constants(pair: &PairMaterial, _: f64, _: f64) -> CohesionConstants {
        CohesionConstants { strength: pair.cohesion_energy_density, length: 0.0, reach: 0.0 }
    }

    #[inline(always)]
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, proximity: &Proximity<L>) -> L {
        let area = match proximity.bodies {
            Bodies::Spheres(one, other) => {
                L::splat(4.0 * PI) * (one * other / (one + other)) * proximity.overlap
            }
            Bodies::SphereAndWall(radius) => L::splat(2.0 * PI) * radius * proximity.overlap,
        };
        constants.strength * area
    }

    #[inline(always)]
    fn jumps<L: Lanes>(_: &CohesionConstants<L>) -> [L; 2] {
        [L::splat(0.0); 2]
    }

    #[inline(always)]
    fn felt<L: Lanes>(_: &CohesionConstants<L>, attraction: L) -> L {
        attraction
    }
}
