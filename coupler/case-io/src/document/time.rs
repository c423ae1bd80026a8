//! `[time]`: how long, and in which steps.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Time;

/// `[time]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct TimeTable {
    /// The run goes from 0 to this time.
    pub end: Time,
    /// Coupling window: required when both sides run; alone, the interval of the series by default.
    pub window: Option<Time>,
    /// The window is never halved below this; default window / 1024.
    pub smallest_window: Option<Time>,
    /// Step of the grains; default `substep-safety` times the critical step.
    pub substep: Option<Time>,
    /// Fraction of the critical step used when `substep` is absent.
    #[serde(default = "default_substep_safety")]
    pub substep_safety: f64,
}

fn default_substep_safety() -> f64 {
    0.5
}
