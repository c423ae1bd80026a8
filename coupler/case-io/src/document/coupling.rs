//! `[coupling]`: how the two sides act on each other.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Force, Pressure, Time, Velocity};

/// `[coupling]`, required when both sides run.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Coupling {
    /// Order of the staggered iterations.
    pub scheme: Scheme,
    /// Law of the drag; in 2D `none` or `di-felice-cylinder`, which is of 2D only.
    pub drag: Drag,
    /// Coefficient of added mass C_A (sphere: 0.5); default 0.
    #[serde(default)]
    pub added_mass: f64,
    /// Whether the drag is corrected for the grain's own disturbance of the fluid.
    #[serde(default = "yes")]
    pub self_disturbance: bool,
    /// When the iterations of a window have converged.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Most iterations of a window (`serial-implicit` only).
    #[serde(default = "default_max_iterations")]
    pub max_iterations: u32,
    /// How the iterations are accelerated (`serial-implicit` only).
    #[serde(default)]
    pub acceleration: Acceleration,
    /// Relaxation factor of `constant`, first factor of `aitken`, in (0, 1].
    #[serde(default = "default_relaxation")]
    pub relaxation: f64,
    /// The run fails when a row of the ledger is off by more, relative.
    #[serde(default = "default_ledger_tolerance")]
    pub ledger_tolerance: f64,
    /// A peer that shows no sign of life for this long is taken for frozen.
    #[serde(default = "default_peer_deadline")]
    pub peer_deadline: Time,
    /// Longest computation of one answer.
    #[serde(default = "default_answer_deadline")]
    pub answer_deadline: Time,
}

/// Order of the staggered iterations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scheme {
    /// One pass a window: grains, then fluid.
    SerialExplicit,
    /// Passes until the window has converged.
    SerialImplicit,
    /// The fluid pushes the grains, and is not pushed.
    OneWay,
}

/// Law of the drag.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Drag {
    /// No drag.
    None,
    /// Stokes 1851.
    Stokes,
    /// Schiller & Naumann 1933.
    SchillerNaumann,
    /// Haider & Levenspiel 1989.
    HaiderLevenspiel,
    /// Wen & Yu 1966.
    WenYu,
    /// Ergun 1952.
    Ergun,
    /// Gidaspow 1994: Ergun in dense, Wen & Yu in dilute beds.
    Gidaspow,
    /// Di Felice 1994.
    DiFelice,
    /// White 1991, Kaplun 1957 and Di Felice 1994: the discs of 2D.
    DiFeliceCylinder,
}

/// How the iterations are accelerated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Acceleration {
    /// Each iterate is taken as it comes.
    None,
    /// A constant fraction of each change is taken.
    Constant,
    /// Aitken's Δ² factor.
    #[default]
    Aitken,
}

/// When the iterations of a window have converged; each change is held against the value or its floor.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Tolerance {
    /// Relative change of the fluid's velocity.
    pub velocity: f64,
    /// Relative change of the pressure.
    pub pressure: f64,
    /// Relative change of the forces on the grains.
    pub force: f64,
    /// Velocities below this are taken for 0.
    pub velocity_floor: Velocity,
    /// Pressures below this are taken for 0.
    pub pressure_floor: Pressure,
    /// Forces below this are taken for 0.
    pub force_floor: Force,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self {
            velocity: 1e-3,
            pressure: 1e-3,
            force: 1e-3,
            velocity_floor: Velocity::from_si(1e-9),
            pressure_floor: Pressure::from_si(1e-6),
            force_floor: Force::from_si(1e-15),
        }
    }
}

fn yes() -> bool {
    true
}

fn default_max_iterations() -> u32 {
    20
}

fn default_relaxation() -> f64 {
    0.7
}

fn default_ledger_tolerance() -> f64 {
    1e-12
}

fn default_peer_deadline() -> Time {
    Time::from_si(10.0)
}

fn default_answer_deadline() -> Time {
    Time::from_si(600.0)
}
