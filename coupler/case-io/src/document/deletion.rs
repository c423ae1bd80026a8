//! `[[deletion]]`: where grains are taken out.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::region::{CylinderRegion, Region, SphereRegion, StlRegion};
use super::vector::Bounds;
use super::wall::Plane;

/// `[[deletion]]`: a grain whose centre is in the region at the end of a window is removed, and counted in
/// `series/turnover.csv`; exactly one of `box`, `sphere`, `cylinder`, `stl`, `beyond` gives the region.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Deletion {
    /// Name in messages and in the series.
    pub name: String,
    /// A box along the axes.
    #[serde(rename = "box")]
    pub cuboid: Option<Bounds>,
    /// A sphere (2D: a circle).
    pub sphere: Option<SphereRegion>,
    /// A cylinder with ends (3D).
    pub cylinder: Option<CylinderRegion>,
    /// The inside of a closed surface of triangles (3D).
    pub stl: Option<StlRegion>,
    /// All that is behind a plane: on the side that its normal points away from.
    pub beyond: Option<Plane>,
}

impl Deletion {
    /// The region, where it is one with ends.
    pub fn region(&self) -> Option<Region<'_>> {
        self.cuboid
            .as_ref()
            .map(|bounds| Region::Box(&bounds.lower, &bounds.upper))
            .or(self.sphere.as_ref().map(SphereRegion::region))
            .or(self.cylinder.as_ref().map(CylinderRegion::region))
            .or(self.stl.as_ref().map(StlRegion::region))
    }
}
