//! Constant under-relaxation.

use serde::{Deserialize, Serialize};

use super::Relaxation;

/// ω constant: an amplification −λ of errors becomes 1 − ω(1 + λ).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Constant {
    factor: f64,
}

impl Constant {
    /// Relaxation by this factor, in (0, 1]; `None` for any other.
    pub fn new(factor: f64) -> Option<Self> {
        (factor > 0.0 && factor <= 1.0).then_some(Self { factor })
    }
}

impl Relaxation for Constant {
    const NAME: &'static str = "constant";
    const FORMULA: &'static str = "x ← x + ω(H(x) − x)";
    const SOURCE: &'static str = "Richardson 1911, Phil. Trans. R. Soc. A 210:307";

    fn open(&mut self) {}

    fn factor(&mut self, _: &[f64]) -> f64 {
        self.factor
    }
}
