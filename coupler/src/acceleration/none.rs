//! No relaxation.

use serde::{Deserialize, Serialize};

use super::Relaxation;

/// ω = 1: converges where the amplification of an error is below 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct None;

impl Relaxation for None {
    const NAME: &'static str = "none";
    const FORMULA: &'static str = "x ← H(x)";
    const SOURCE: &'static str = "–";

    fn open(&mut self) {}

    fn factor(&mut self, _: &[f64]) -> f64 {
        1.0
    }
}
