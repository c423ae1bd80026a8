//! The case document: every table and key of `case.toml`, in SI.

mod bond;
mod boundary;
mod case;
mod clump;
mod coupling;
mod deletion;
#[cfg(test)]
pub(crate) mod fixture;
mod fluid;
mod gate;
mod grain_field;
mod grains;
mod insertion;
mod load;
mod material;
mod mesh;
mod output;
mod pfem;
mod probe;
pub mod quantity;
mod refinement;
mod region;
mod rheology;
mod schema;
mod sizes;
mod sleep;
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

pub use bond::{Bond, BondLaw};
pub use boundary::{Boundary, BoundaryKind, BoundaryVelocity, Profile};
pub use case::{CaseTable, Dimension};
pub use clump::{Clump, ClumpSphere, Spin, Turn};
pub use coupling::{Acceleration, Coupling, Drag, Scheme, Tolerance};
pub use deletion::Deletion;
pub use fluid::{Backend, Field, Fluid, Solve};
pub use gate::{Disc, Inlet, Outlet};
pub use grain_field::GrainField;
pub use grains::{
    CohesionLaw, Escape, Grains, Lubrication, NormalLaw, RollingLaw, TangentialLaw, TwistingLaw,
};
pub use insertion::{
    GrainFile, Insertion, Lattice, LatticeKind, Placement, RandomBox, RandomCylinder, RandomFill,
    RandomSphere, RandomStl, Rate,
};
pub use load::{Case, Overrides};
pub use material::{Material, Pair};
pub use mesh::{BoxMesh, GmshFile, Mesh, MeshSource, PipeMesh};
pub use output::{Interval, OutputTable};
pub use pfem::{Body, FlowScheme, GrainNodes, Pfem, Recognition};
pub use probe::{GaugeFace, Probe};
pub use refinement::{Near, Refinement};
pub use region::{CylinderRegion, Region, SphereRegion, StlRegion};
pub use rheology::{Rheology, RheologyLaw};
pub use schema::schema;
pub use sizes::{Distribution, LognormalSizes, MixtureSize, NormalSizes, SieveFile};
pub use sleep::Sleep;
pub use time::TimeTable;
pub use variant::{Run, Variant};
pub use vector::{AccelerationVector, Axis, Bounds, Point, Vector, VelocityVector, unit_vector};
pub use wall::{
    Cylinder, MeshBoundary, Motion, MotionTable, Oscillation, Plane, Polyline, Rotation, Servo, Side, Sphere,
    SurfaceFile, Wall, WallShape,
};

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
    /// Rigid bodies of spheres that insertions may insert.
    #[serde(default)]
    pub clump: Vec<Clump>,
    /// Where grains come from.
    #[serde(default)]
    pub insertion: Vec<Insertion>,
    /// Which grains are glued together.
    #[serde(default)]
    pub bond: Vec<Bond>,
    /// Where grains are taken out.
    #[serde(default)]
    pub deletion: Vec<Deletion>,
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
        let grains = self.insertion.iter().enumerate().flat_map(|(k, insertion)| {
            let sieve = insertion.diameter_distribution.as_ref().and_then(|sizes| sizes.sieve.as_ref());
            let files = [
                ("file.path", insertion.file.as_ref().map(|file| file.path.as_path())),
                ("random-stl.path", insertion.random_stl.as_ref().map(|fill| fill.path.as_path())),
                (
                    "rate.stl.path",
                    insertion.rate.as_ref().and_then(|rate| Some(rate.stl.as_ref()?.path.as_path())),
                ),
                ("diameter-distribution.sieve.path", sieve.map(|sieve| sieve.path.as_path())),
            ];
            files.into_iter().filter_map(move |(key, path)| Some((format!("insertion[{k}].{key}"), path?)))
        });
        let walls = self.wall.iter().enumerate().flat_map(|(k, wall)| {
            let table = wall.motion.as_ref().and_then(|motion| motion.table.as_ref()?.path.as_deref());
            let files = [
                ("stl.path", wall.stl.as_ref().map(|file| file.path.as_path())),
                ("obj.path", wall.obj.as_ref().map(|file| file.path.as_path())),
                ("motion.table.path", table),
            ];
            files.into_iter().filter_map(move |(key, path)| Some((format!("wall[{k}].{key}"), path?)))
        });
        let deletions = self.deletion.iter().enumerate().filter_map(|(k, deletion)| {
            Some((format!("deletion[{k}].stl.path"), deletion.stl.as_ref()?.path.as_path()))
        });
        let mesh = self.fluid.as_ref().and_then(|fluid| fluid.mesh.as_ref()?.gmsh.as_ref());
        let mesh = mesh.map(|gmsh| ("fluid.mesh.gmsh.path".to_string(), gmsh.path.as_path()));
        grains.chain(deletions).chain(walls).chain(mesh).collect()
    }
}
