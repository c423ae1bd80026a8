//! `[grains]`: the side of the grains; present, a dem-solver runs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Velocity;
use super::vector::{Axis, Bounds};

/// `[grains]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Grains {
    /// Law of the normal contact force.
    pub normal_law: NormalLaw,
    /// Velocity from which the stiffness of a linear law is found (`hooke` and `liggghts-hooke` only).
    pub characteristic_velocity: Option<Velocity>,
    /// Where grains may be; default: the box around the fluid mesh, the walls and the insertions.
    pub domain: Option<Bounds>,
    /// What happens when a grain leaves the domain.
    #[serde(default)]
    pub escape: Escape,
    /// Axes of the domain that wrap.
    #[serde(default)]
    pub periodic: Vec<Axis>,
}

/// Law of the normal contact force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NormalLaw {
    /// Linear spring and dashpot.
    Hooke,
    /// Hertz's force with a dashpot that gives the stated restitution.
    Hertz,
    /// LIGGGHTS 3.8.0, `model hooke tangential history` (3D).
    LiggghtsHooke,
    /// LIGGGHTS 3.8.0, `model hertz tangential history` (3D).
    LiggghtsHertz,
    /// No contact at all.
    None,
}

/// What happens when a grain leaves the domain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Escape {
    /// The run stops.
    #[default]
    Stop,
    /// The grain is removed and counted in the ledger.
    Remove,
}
