//! `[grains.sleep]`: idle grains are held at rest.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Acceleration, Velocity};

/// `[grains.sleep]`: chunks of neighbouring grains that are all idle are held where they are, until one of them would move.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Sleep {
    /// Idle grains are slower, for a time of 10 speed/acceleration; default 1e-4 √(g d) of the smallest grain.
    pub speed: Option<Velocity>,
    /// A sleeping grain wakes when it would accelerate by more, force over mass plus torque over inertia times radius;
    /// default 1e-3 of gravity.
    pub acceleration: Option<Acceleration>,
}
