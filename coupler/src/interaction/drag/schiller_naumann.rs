//! A sphere alone, up to the critical Reynolds number.

use super::{DragLaw, Fitted, Slip};

/// Reynolds number where C_D becomes constant.
const NEWTON_RANGE: f64 = 1000.0;

/// C_D = (24/Re)(1 + 0.15 Re^0.687) below Re = 1000, 0.44 from there (C_D jumps by +0.4 %).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SchillerNaumann;

/// C_D Re/24 \[-\] of Schiller & Naumann at a Reynolds number; 1 at Re = 0.
pub(super) fn stokes_multiple(reynolds: f64) -> f64 {
    if reynolds < NEWTON_RANGE { 1.0 + 0.15 * reynolds.powf(0.687) } else { 0.44 * reynolds / 24.0 }
}

impl DragLaw for SchillerNaumann {
    const NAME: &'static str = "schiller-naumann";
    const FORMULA: &'static str =
        "β = 3π μ d·C_D Re/24; C_D Re/24 = 1 + 0.15 Re^0.687 for Re < 1000, else 0.44 Re/24";
    const VALIDITY: &'static str =
        "a sphere alone, Re < 2e5 (4–7 % of measurements); the void fraction does not enter";
    const SOURCE: &'static str = "Schiller & Naumann 1933, Z. Ver. Dtsch. Ing. 77:318";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        slip.stokes_coefficient() * stokes_multiple(slip.particle_reynolds())
    }
}
