//! `[[wall]]`: what grains touch besides each other.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{AngularVelocity, Length, NumberRate};
use super::vector::{Point, VelocityVector, one};

/// `[[wall]]`; exactly one of `plane`, `stl`, `mesh` gives its shape.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Wall {
    /// Name in messages and in the ledger.
    pub name: String,
    /// One of `[materials.*]`.
    pub material: String,
    /// An infinite plane.
    pub plane: Option<Plane>,
    /// Triangles of an STL file (3D).
    pub stl: Option<StlFile>,
    /// Boundary faces of the fluid mesh.
    pub mesh: Option<MeshBoundary>,
    /// Prescribed motion of a `plane` or `stl` wall; default at rest. Shapes are stated as at t = 0.
    pub motion: Option<Motion>,
    /// Point, fixed in space, about which `series/walls.csv` tells the torque; default the origin.
    pub torque_about: Option<Point>,
}

impl Wall {
    /// The wall's shape: the one that loading has checked to be stated.
    pub fn shape(&self) -> Option<WallShape<'_>> {
        self.plane
            .as_ref()
            .map(WallShape::Plane)
            .or(self.stl.as_ref().map(WallShape::Stl))
            .or(self.mesh.as_ref().map(WallShape::Mesh))
    }
}

/// The shape of a wall.
#[derive(Clone, Copy, Debug)]
pub enum WallShape<'a> {
    /// An infinite plane.
    Plane(&'a Plane),
    /// Triangles of an STL file.
    Stl(&'a StlFile),
    /// Boundary faces of the fluid mesh.
    Mesh(&'a MeshBoundary),
}

/// An infinite plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Plane {
    /// A point of the plane.
    pub point: Point,
    /// Its normal, of any length, towards the grains: `dimension` bare numbers.
    pub normal: Vec<f64>,
}

/// Triangles of an STL file, ASCII or binary.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct StlFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
    /// STL has no unit: its coordinates times `scale` are metres.
    #[serde(default = "one")]
    pub scale: f64,
}

/// Boundary faces of the fluid mesh as contact triangles (2D: segments).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct MeshBoundary {
    /// Names of boundaries of the fluid mesh.
    pub boundary: Vec<String>,
}

/// Prescribed motion: the sum of what is stated; the axis of a rotation goes along with translation and oscillation.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Motion {
    /// Constant velocity.
    pub translation: Option<VelocityVector>,
    /// Rotation at a constant rate.
    pub rotation: Option<Rotation>,
    /// Harmonic oscillation.
    pub oscillation: Option<Oscillation>,
}

/// Rotation about an axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Rotation {
    /// Direction of the axis, of any length: three bare numbers (3D only; in 2D the axis is z).
    pub axis: Option<Vec<f64>>,
    /// A point of the axis at t = 0.
    pub point: Point,
    /// Angular velocity, right-handed about the axis.
    pub rate: AngularVelocity,
}

/// Displacement amplitude · sin(2π · frequency · t) along a direction.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Oscillation {
    /// The direction, of any length: `dimension` bare numbers.
    pub direction: Vec<f64>,
    /// Largest displacement.
    pub amplitude: Length,
    /// Oscillations per time.
    pub frequency: NumberRate,
}
