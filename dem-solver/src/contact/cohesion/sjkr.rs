//! The area where two spheres cut each other.

use std::f64::consts::{FRAC_PI_4, PI};

use super::Cohesion;
use crate::lanes::Lanes;

/// LIGGGHTS-PUBLIC 3.8.0, `cohesion sjkr`, with d the distance of the centres:
///
/// | | area |
/// |---|---|
/// | spheres | π/4 (r_i + r_j - d)(d + r_i - r_j)(d - r_i + r_j)(d + r_i + r_j)/d², the circle where they cut |
/// | wall | π (r² - d²), the circle that the wall cuts out |
#[derive(Clone, Copy, Debug)]
pub struct Sjkr;

impl Cohesion for Sjkr {
    #[inline(always)]
    fn area_of_spheres<L: Lanes>(radius_i: L, radius_j: L, distance: L) -> L {
        let (sum, difference) = (radius_i + radius_j, radius_i - radius_j);
        let squares = (sum - distance) * (distance + difference) * (distance - difference) * (distance + sum);
        L::splat(FRAC_PI_4) * squares / (distance * distance)
    }

    #[inline(always)]
    fn area_on_wall<L: Lanes>(radius: L, distance: L) -> L {
        L::splat(PI) * (radius * radius - distance * distance)
    }
}
