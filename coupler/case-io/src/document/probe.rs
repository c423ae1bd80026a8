//! `[[probe]]`: points whose fluid state goes to `series/probes.csv`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::vector::Point;

/// `[[probe]]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Probe {
    /// Name of its columns.
    pub name: String,
    /// Where it is.
    pub at: Point,
}
