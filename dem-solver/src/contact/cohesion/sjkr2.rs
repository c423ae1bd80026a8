//! An area that grows with the overlap.

use std::f64::consts::PI;

use super::Cohesion;
use crate::lanes::Lanes;

/// LIGGGHTS-PUBLIC 3.8.0, `cohesion sjkr2`, with d the distance of the centres and δ the overlap:
///
/// | | area |
/// |---|---|
/// | spheres | 4 π R* δ, δ = r_i + r_j - d |
/// | wall | 2 π r δ, δ = r - d: half of what spheres of the same R* have |
#[derive(Clone, Copy, Debug)]
pub struct Sjkr2;

impl Cohesion for Sjkr2 {
    #[inline(always)]
    fn area_of_spheres<L: Lanes>(radius_i: L, radius_j: L, distance: L) -> L {
        let sum = radius_i + radius_j;
        L::splat(4.0 * PI) * (radius_i * radius_j / sum) * (sum - distance)
    }

    #[inline(always)]
    fn area_on_wall<L: Lanes>(radius: L, distance: L) -> L {
        L::splat(2.0 * PI) * radius * (radius - distance)
    }
}
