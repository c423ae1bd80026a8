//! `[grains]`: the side of the grains; present, a dem-solver runs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Velocity;
use super::sleep::Sleep;
use super::vector::{Axis, Bounds};

/// `[grains]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Grains {
    /// Law of the normal contact force.
    pub normal_law: NormalLaw,
    /// Velocity from which the stiffness of a linear law is found (`hooke` and `liggghts-hooke` only).
    pub characteristic_velocity: Option<Velocity>,
    /// Law of the torque that resists rolling; default: nothing does.
    pub rolling_law: Option<RollingLaw>,
    /// Law of the cohesion of bodies that touch; default: they do not cohere.
    pub cohesion_law: Option<CohesionLaw>,
    /// Where grains may be; default: the box around the fluid mesh, the walls and the insertions.
    pub domain: Option<Bounds>,
    /// What happens when a grain leaves the domain.
    #[serde(default)]
    pub escape: Escape,
    /// Axes of the domain that wrap.
    #[serde(default)]
    pub periodic: Vec<Axis>,
    /// Deepest overlap at the start, of grains and with walls, as a fraction of the diameter.
    #[serde(default = "default_start_overlap")]
    pub start_overlap: f64,
    /// When idle grains sleep; default: none does.
    pub sleep: Option<Sleep>,
}

fn default_start_overlap() -> f64 {
    0.01
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

/// Law of the torque that resists rolling, as LIGGGHTS 3.8.0 has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RollingLaw {
    /// Constant torque against the relative spin.
    Cdt,
    /// Elastic–plastic spring and dashpot.
    Epsd,
    /// Elastic–plastic spring as stiff as the tangential one.
    Epsd2,
}

/// Law of the cohesion of bodies that touch, as LIGGGHTS 3.8.0 has it (3D).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CohesionLaw {
    /// Energy density times the area where the bodies cut each other.
    Sjkr,
    /// Energy density times an area that grows with the overlap.
    Sjkr2,
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
