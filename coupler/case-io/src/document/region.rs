//! Regions of space.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Length;
use super::vector::{Point, one};

/// A sphere (2D: a circle).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct SphereRegion {
    /// Its centre.
    pub centre: Point,
    /// Its radius.
    pub radius: Length,
}

/// A circular cylinder with flat ends (3D only).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct CylinderRegion {
    /// Centre of one end.
    pub from: Point,
    /// Centre of the other end.
    pub to: Point,
    /// Its radius.
    pub radius: Length,
}

/// The inside of a closed surface of triangles (3D only).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct StlRegion {
    /// An STL file, relative to the case's folder.
    pub path: PathBuf,
    /// Such files have no unit: their coordinates times `scale` are metres.
    #[serde(default = "one")]
    pub scale: f64,
}

/// A region, however a table states it.
#[derive(Clone, Copy, Debug)]
pub enum Region<'a> {
    /// A box along the axes, by the corners of smallest and of largest coordinates.
    Box(&'a Point, &'a Point),
    /// A sphere, by centre and radius.
    Sphere(&'a Point, Length),
    /// A cylinder, by the centres of its ends and its radius.
    Cylinder(&'a Point, &'a Point, Length),
    /// The inside of a closed surface, by its file and the scale of that.
    Stl(&'a Path, f64),
}

impl StlRegion {
    /// The region.
    pub fn region(&self) -> Region<'_> {
        Region::Stl(&self.path, self.scale)
    }
}

impl SphereRegion {
    /// The region.
    pub fn region(&self) -> Region<'_> {
        Region::Sphere(&self.centre, self.radius)
    }
}

impl CylinderRegion {
    /// The region.
    pub fn region(&self) -> Region<'_> {
        Region::Cylinder(&self.from, &self.to, self.radius)
    }
}
