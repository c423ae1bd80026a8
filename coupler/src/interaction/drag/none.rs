//! No drag.

use super::{DragLaw, Fitted, Slip};

/// β = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct None;

impl DragLaw for None {
    const NAME: &'static str = "none";
    const FORMULA: &'static str = "β = 0";
    const VALIDITY: &'static str =
        "grains that the fluid moves by its pressure gradient and viscous stress alone";
    const SOURCE: &'static str = "–";
    const FITTED: Fitted = Fitted::AnyGrain;

    fn exchange_coefficient(&self, _: &Slip) -> f64 {
        0.0
    }
}
