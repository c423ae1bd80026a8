//! `[[fluid.inlet]]` and `[[fluid.outlet]]`: where fluid of moving nodes comes in and leaves, besides boundaries of its mesh.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::boundary::BoundaryVelocity;
use super::quantity::{Length, Velocity};
use super::vector::{Bounds, Point};
use super::wall::Plane;

/// `[[fluid.inlet]]`: a flat opening that fluid comes in through; exactly one of `box` and `disc` gives its shape. Where there is
/// no fluid before it at the start, one layer of cells is put there.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Inlet {
    /// Name in messages.
    pub name: String,
    /// A box without thickness along one axis (2D: a segment).
    #[serde(rename = "box")]
    pub flat: Option<Bounds>,
    /// A disc (3D).
    pub disc: Option<Disc>,
    /// Its normal, of any length, into the fluid.
    pub normal: Vec<f64>,
    /// Velocity of the fluid there.
    pub velocity: Option<BoundaryVelocity>,
    /// Speed along the normal (instead of `velocity`).
    pub speed: Option<Velocity>,
}

/// A disc across the normal.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Disc {
    /// Its centre.
    pub centre: Point,
    /// Its radius.
    pub radius: Length,
}

/// `[[fluid.outlet]]`: a plane at which fluid leaves, against no pressure.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Outlet {
    /// Name in messages.
    pub name: String,
    /// The fluid leaves where it comes behind this plane: to the side that its normal points away from.
    pub beyond: Plane,
    /// The part of space where it does; default everywhere.
    pub within: Option<Bounds>,
}
