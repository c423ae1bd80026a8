//! `[[clump]]`: rigid bodies of spheres that insertions may insert.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Angle, AngularVelocity, Length, Mass};
use super::vector::Point;

/// `[[clump]]`: spheres (2D: discs) that touch or overlap, as one rigid body; `clump` of `[[insertion]]` names it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Clump {
    /// Name.
    pub name: String,
    /// Its spheres.
    pub spheres: Vec<ClumpSphere>,
    /// Its mass, spread evenly over the union of the spheres; default that of the insertion's material, what spheres share
    /// counted once.
    pub mass: Option<Mass>,
}

/// A sphere of a clump.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct ClumpSphere {
    /// Its centre, in axes of the clump's own.
    pub centre: Point,
    /// Its radius.
    pub radius: Length,
}

/// A turn about an axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Turn {
    /// Direction of the axis, of any length: three bare numbers (3D only; in 2D the axis is z).
    pub axis: Option<Vec<f64>>,
    /// Angle, right-handed about the axis.
    pub angle: Angle,
}

/// A spin about an axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Spin {
    /// Direction of the axis, of any length: three bare numbers (3D only; in 2D the axis is z).
    pub axis: Option<Vec<f64>>,
    /// Angular velocity, right-handed about the axis.
    pub rate: AngularVelocity,
}
