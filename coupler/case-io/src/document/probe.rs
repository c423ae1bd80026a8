//! `[[probe]]`: points and discs whose fluid state goes to `series/probes.csv`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Length;
use super::vector::Point;

/// `[[probe]]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Probe {
    /// Name of its columns.
    pub name: String,
    /// Where it is.
    pub at: Point,
    /// The face of a gauge about it: the probe reads means over that.
    pub disc: Option<GaugeFace>,
}

/// The face of a gauge. The pressure is the mean over all of it, 0 where no fluid is; the rest over what is wet.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct GaugeFace {
    /// Its radius.
    pub radius: Length,
    /// Normal of its plane, of any length: `dimension` bare numbers.
    pub normal: Vec<f64>,
}
