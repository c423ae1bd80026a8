//! The area where two spheres cut each other.

use std::f64::consts::{FRAC_PI_4, PI};

use super::{Bodies, Cohesion, CohesionConstants, Proximity};
use crate::lanes::Lanes;
use crate::material::PairMaterial;

/// A = k times an area, k the pair's density of cohesive energy \[J/m³\], all of it felt by friction: LIGGGHTS-PUBLIC
/// 3.8.0, `cohesion sjkr`, with d the distance of the centres:
///
/// | | area |
/// |---|---|
/// | spheres | π/4 (r_i + r_j - d)(d + r_i - r_j)(d - r_i + r_j)(d + r_i + r_j)/d², the circle where they cut |
/// | wall | π (r² - d²), the circle that the wall cuts out |
///
/// `strength` is k.
#[derive(Clone, Copy, Debug)]
pub struct Sjkr;

impl Cohesion for Sjkr {
    const REMEMBERS: bool = false;

    fn constants(pair: &PairMaterial, _: f64, _: f64) -> CohesionConstants {
        CohesionConstants { strength: pair.cohesion_energy_density, length: 0.0, reach: 0.0 }
    }

    #[inline(always)]
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, proximity: &Proximity<L>) -> L {
        let distance = proximity.distance;
        let area = match proximity.bodies {
            Bodies::Spheres(one, other) => {
                let (sum, difference) = (one + other, one - other);
                let squares =
                    (sum - distance) * (distance + difference) * (distance - difference) * (distance + sum);
                L::splat(FRAC_PI_4) * squares / (distance * distance)
            }
            Bodies::SphereAndWall(radius) => L::splat(PI) * (radius * radius - distance * distance),
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
