//! A sphere alone in creeping flow.

use super::{DragLaw, Fitted, Slip};

/// β = 3π μ d, C_D = 24/Re; the void fraction does not enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stokes;

impl DragLaw for Stokes {
    const NAME: &'static str = "stokes";
    const FORMULA: &'static str = "β = 3π μ d";
    const VALIDITY: &'static str = "a sphere alone, Re < 0.1 (2 % at 0.1); the void fraction does not enter";
    const SOURCE: &'static str = "Stokes 1851, Trans. Camb. Phil. Soc. 9:8";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        slip.stokes_coefficient()
    }
}
