//! `[fluid.pfem]` and `[[fluid.body]]`: what only a fluid of moving nodes has.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::boundary::BoundaryVelocity;
use super::quantity::{Length, Pressure};
use super::refinement::Refinement;
use super::region::{Region, SphereRegion};
use super::vector::Bounds;

/// `[fluid.pfem]`
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Pfem {
    /// Distance between neighbouring nodes that remeshing keeps; default that of the mesh at the start.
    pub size: Option<Length>,
    /// How the cells that are fluid are found between nodes that moved.
    #[serde(default)]
    pub recognition: Recognition,
    /// Where cells are finer than `size`.
    #[serde(default)]
    pub refine: Vec<Refinement>,
    /// What the size of cells gains per way from where they are fine; default 0.3.
    pub growth: Option<f64>,
    /// How velocity and pressure of a step are found.
    #[serde(default)]
    pub scheme: FlowScheme,
    /// On which nodes grains act, and which they sample.
    #[serde(default)]
    pub grains: GrainNodes,
    /// Pressure over the relative change of volume that it makes; default: the fluid keeps its volume.
    pub bulk_modulus: Option<Pressure>,
}

/// How the cells that are fluid are found between nodes that moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Recognition {
    /// What lies inside of the moved surface; surfaces merge where they close a thin gap (in the plane) or have met (in space).
    #[default]
    MovedDomain,
    /// Cells whose circumscribed circle or ball is at most 1.25 sizes in radius: the usual rule, for comparison.
    AlphaShape,
}

/// How velocity and pressure of a step are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FlowScheme {
    /// Both at once, until nothing is left of the equations.
    #[default]
    Monolithic,
    /// One after the other, as in the papers of the method, of first order in time: for comparison.
    Segregated,
    /// Three corrections of the pressure, whatever is left: cheaper.
    FractionalStep,
}

/// On which nodes grains act, and which they sample.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GrainNodes {
    /// On all nodes around, by a kernel as wide as a grain or a cell.
    #[default]
    Kernel,
    /// On a node of its own, which remeshing puts where the grain is: for few grains, smaller than the cells.
    Nodal,
}

/// `[[fluid.body]]`: fluid besides that of the mesh; exactly one of `box` and `sphere` gives its shape.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Body {
    /// An axis-aligned box.
    #[serde(rename = "box")]
    pub box_region: Option<Bounds>,
    /// A sphere (2D: a circle).
    pub sphere: Option<SphereRegion>,
    /// Velocity at the start; default that of the fluid.
    pub velocity: Option<BoundaryVelocity>,
}

impl Body {
    /// Its shape: the one that loading has checked to be stated.
    pub fn region(&self) -> Option<Region<'_>> {
        let of_box = self.box_region.as_ref().map(|bounds| Region::Box(&bounds.lower, &bounds.upper));
        of_box.or(self.sphere.as_ref().map(SphereRegion::region))
    }
}
