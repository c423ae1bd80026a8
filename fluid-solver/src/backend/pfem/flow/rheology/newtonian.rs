//! One viscosity.

use super::Law;

/// μ whatever the rate of shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newtonian {
    /// μ (Pa s).
    pub viscosity: f64,
}

impl Law for Newtonian {
    fn viscosity(&self, _shear_rate: f64) -> f64 {
        self.viscosity
    }

    fn softening(&self, _shear_rate: f64) -> f64 {
        0.0
    }
}
