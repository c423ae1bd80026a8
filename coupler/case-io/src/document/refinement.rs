//! `[[fluid.pfem.refine]]`: where the cells of a fluid of moving nodes are finer.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Length;
use super::region::{Region, SphereRegion};
use super::vector::Bounds;

/// `[[fluid.pfem.refine]]`: exactly one of `near`, `box` and `sphere` says where.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Refinement {
    /// What the cells are fine near to.
    pub near: Option<Near>,
    /// An axis-aligned box in which they are.
    #[serde(rename = "box")]
    pub box_region: Option<Bounds>,
    /// A sphere (2D: a circle) in which they are.
    pub sphere: Option<SphereRegion>,
    /// Distance between neighbouring nodes there.
    pub size: Length,
}

/// What cells may be fine near to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Near {
    /// The free surface.
    Surface,
    /// Walls.
    Walls,
    /// Grains.
    Grains,
}

impl Refinement {
    /// The box or the sphere, if it is one.
    pub fn region(&self) -> Option<Region<'_>> {
        let of_box = self.box_region.as_ref().map(|bounds| Region::Box(&bounds.lower, &bounds.upper));
        of_box.or(self.sphere.as_ref().map(SphereRegion::region))
    }
}
