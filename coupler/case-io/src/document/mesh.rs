//! `[fluid.mesh]`: where the mesh of the fluid comes from.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Angle, Length};
use super::vector::{Axis, Point, one};
use crate::expression::Expression;

/// `[fluid.mesh]`; exactly one of `box`, `pipe`, `gmsh`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Mesh {
    /// An axis-aligned box; boundaries `x-min`, `x-max`, `y-min`, …
    #[serde(rename = "box")]
    pub box_mesh: Option<BoxMesh>,
    /// A pipe (3D), straight or bent; boundaries `inlet`, `outlet`, `wall`.
    pub pipe: Option<PipeMesh>,
    /// A Gmsh file (MSH 2.2 or 4.1); boundaries are its physical groups.
    pub gmsh: Option<GmshFile>,
}

impl Mesh {
    /// Where the mesh comes from: the one source that loading has checked to be stated.
    pub fn source(&self) -> Option<MeshSource<'_>> {
        self.box_mesh
            .as_ref()
            .map(MeshSource::Box)
            .or(self.pipe.as_ref().map(MeshSource::Pipe))
            .or(self.gmsh.as_ref().map(MeshSource::Gmsh))
    }
}

/// Where a mesh comes from.
#[derive(Clone, Copy, Debug)]
pub enum MeshSource<'a> {
    /// An axis-aligned box.
    Box(&'a BoxMesh),
    /// A pipe.
    Pipe(&'a PipeMesh),
    /// A Gmsh file.
    Gmsh(&'a GmshFile),
}

/// An axis-aligned box; exactly one of `cells` and `size`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct BoxMesh {
    /// Lower corner.
    pub lower: Point,
    /// Upper corner.
    pub upper: Point,
    /// Number of cells along each axis, before they are split into simplices.
    pub cells: Option<Vec<u32>>,
    /// Largest edge of a cell.
    pub size: Option<Length>,
    /// Axes that wrap.
    #[serde(default)]
    pub periodic: Vec<Axis>,
    /// Random shift of inner nodes, as a fraction of the cell's edge, in [0, 0.5).
    #[serde(default)]
    pub jitter: f64,
    /// Where the top is at the start (`pfem` only): its height, along the last axis, in m as an expression of x and y. The
    /// nodes below are moved in proportion. Default: the upper corner's.
    pub surface: Option<Expression>,
}

impl BoxMesh {
    /// Number of cells along each of the first `D` axes: as stated, or the fewest whose edges are not longer
    /// than `size`.
    pub fn cells<const D: usize>(&self) -> [usize; D] {
        let extent = super::vector::extent(&self.lower, &self.upper);
        std::array::from_fn(|axis| match (&self.cells, self.size) {
            (Some(cells), _) => cells.get(axis).map_or(1, |&count| count as usize),
            // 1e-9: an extent that is a multiple of the size but for round-off takes no extra cell.
            (None, Some(size)) => (extent[axis] / size.si() - 1e-9).ceil().max(1.0) as usize,
            (None, None) => 1,
        })
    }
}

/// A pipe along z from the origin, straight or with a bend in the x–z plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct PipeMesh {
    /// Radius of the pipe.
    pub radius: Length,
    /// Length of the (first) straight part.
    pub length: Length,
    /// Edge of a cell.
    pub size: Length,
    /// Radius of the bend's centre line; with `bend-angle`.
    pub bend_radius: Option<Length>,
    /// Angle of the bend; with `bend-radius`.
    pub bend_angle: Option<Angle>,
    /// Length of the straight part behind the bend; default none.
    pub outlet_length: Option<Length>,
}

/// A Gmsh file.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct GmshFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
    /// Its coordinates times `scale` are metres.
    #[serde(default = "one")]
    pub scale: f64,
}
