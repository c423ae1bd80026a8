//! `[[wall]]`: what grains touch besides each other.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::vector::{Point, one};

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

impl Plane {
    /// The normal of length 1, its first `D` components.
    pub fn unit_normal<const D: usize>(&self) -> [f64; D] {
        let largest = self.normal.iter().fold(0.0, |largest: f64, n| largest.max(n.abs()));
        let length = largest * self.normal.iter().map(|n| (n / largest).powi(2)).sum::<f64>().sqrt();
        std::array::from_fn(|axis| self.normal.get(axis).map_or(0.0, |n| n / length))
    }
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
