//! The case document: every table and key of `case.toml`, in SI.

mod boundary;
mod case;
mod coupling;
#[cfg(test)]
pub(crate) mod fixture;
mod fluid;
mod grains;
mod insertion;
mod load;
mod material;
mod mesh;
mod output;
mod probe;
pub mod quantity;
mod schema;
mod sweep;
mod time;
mod unit;
mod validate;
mod variant;
mod vector;
mod wall;

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use boundary::{Boundary, BoundaryKind, BoundaryVelocity, Profile};
pub use case::{CaseTable, Dimension};
pub use coupling::{Acceleration, Coupling, Drag, Scheme, Tolerance};
pub use fluid::{Backend, Field, Fluid, Solve};
pub use grains::{Escape, Grains, NormalLaw};
pub use insertion::{GrainFile, Insertion, Lattice, LatticeKind, Placement, RandomBox, Rate};
pub use load::{Case, Overrides};
pub use material::{Material, Pair};
pub use mesh::{BoxMesh, GmshFile, Mesh, MeshSource, PipeMesh};
pub use output::{Interval, OutputTable};
pub use probe::Probe;
pub use schema::schema;
pub use time::TimeTable;
pub use variant::{Run, Variant};
pub use vector::{AccelerationVector, Axis, Bounds, Point, Vector, VelocityVector, unit_vector};
pub use wall::{MeshBoundary, Motion, Oscillation, Plane, Rotation, StlFile, Wall, WallShape};

/// A case as `case.toml` states it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Document {
    /// What the case is about.
    pub case: CaseTable,
    /// How long, and in which steps.
    pub time: TimeTable,
    /// What is written, and how often.
    #[serde(default)]
    pub output: OutputTable,
    /// Materials by name.
    #[serde(default)]
    pub materials: BTreeMap<String, Material>,
    /// Pairs of materials that touch, by `NAME-NAME` in either order.
    #[serde(default)]
    pub pairs: BTreeMap<String, Pair>,
    /// The side of the grains.
    pub grains: Option<Grains>,
    /// Where grains come from.
    #[serde(default)]
    pub insertion: Vec<Insertion>,
    /// What grains touch besides each other.
    #[serde(default)]
    pub wall: Vec<Wall>,
    /// The side of the fluid.
    pub fluid: Option<Fluid>,
    /// How the two sides act on each other.
    pub coupling: Option<Coupling>,
    /// Points whose fluid state is recorded.
    #[serde(default)]
    pub probe: Vec<Probe>,
    /// Named changes of the case.
    #[serde(default, skip_serializing)]
    pub variants: BTreeMap<String, Variant>,
    /// The runs of a sweep.
    #[serde(default, skip_serializing)]
    pub run: Vec<Run>,
}

impl Document {
    /// How the two materials touch, if the case states it.
    pub fn pair(&self, one: &str, other: &str) -> Option<&Pair> {
        self.pairs.get(&format!("{one}-{other}")).or_else(|| self.pairs.get(&format!("{other}-{one}")))
    }

    /// The window in s: as stated, else the interval of the series.
    pub fn window(&self) -> f64 {
        self.time.window.map_or_else(|| self.output.series(self.time.end), |window| window.si())
    }

    /// The window is never halved below this, in s.
    pub fn smallest_window(&self) -> f64 {
        self.time.smallest_window.map_or(self.window() / 1024.0, |smallest| smallest.si())
    }

    /// The files that the case names: key and path, relative to the case's folder.
    pub fn files(&self) -> Vec<(String, &Path)> {
        let grains = self.insertion.iter().enumerate().filter_map(|(k, insertion)| {
            Some((format!("insertion[{k}].file.path"), insertion.file.as_ref()?.path.as_path()))
        });
        let walls =
            self.wall.iter().enumerate().filter_map(|(k, wall)| {
                Some((format!("wall[{k}].stl.path"), wall.stl.as_ref()?.path.as_path()))
            });
        let mesh = self.fluid.as_ref().and_then(|fluid| fluid.mesh.as_ref()?.gmsh.as_ref());
        let mesh = mesh.map(|gmsh| ("fluid.mesh.gmsh.path".to_string(), gmsh.path.as_path()));
        grains.chain(walls).chain(mesh).collect()
    }
}
