//! `[fluid.rheology]`: a fluid that its yield stress holds.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{NumberRate, Pressure};

/// `[fluid.rheology]` (`pfem` only): the stress at a rate of shear γ̇ is `yield-stress` + `viscosity` γ̇ (γ̇ in 1/s)^(`index` − 1).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Rheology {
    /// Law of the stress.
    pub law: RheologyLaw,
    /// Stress below which the fluid is not sheared.
    pub yield_stress: Pressure,
    /// Exponent of the rate of shear (`herschel-bulkley` only): below 1 the fluid thins, above it thickens.
    pub index: Option<f64>,
    /// Rate of shear below which the stress falls to 0 instead of staying at that of yield: what is arrested creeps at
    /// rates of this order; default a thousandth of that at which yield stress and viscosity are even.
    pub creep_rate: Option<NumberRate>,
}

/// Law of the stress.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RheologyLaw {
    /// `fluid.viscosity` is that of what is sheared, beyond the yield stress.
    Bingham,
    /// `fluid.viscosity` is that at a rate of 1/s, and a power of the rate.
    HerschelBulkley,
}

impl Rheology {
    /// The exponent of the rate of shear.
    pub fn exponent(&self) -> f64 {
        self.index.unwrap_or(1.0)
    }

    /// The rate of creep (1/s) where viscosity is `consistency` (Pa sⁿ).
    pub fn creep_rate(&self, consistency: f64) -> f64 {
        let even = || (self.yield_stress.si() / consistency).powf(1.0 / self.exponent());
        self.creep_rate.map_or_else(|| 1e-3 * even(), |rate| rate.si())
    }
}
