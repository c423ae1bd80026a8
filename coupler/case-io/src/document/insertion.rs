//! `[[insertion]]`: where grains come from.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::clump::{Spin, Turn};
use super::quantity::{Angle, Length, MassRate, NumberRate, Time};
use super::region::{CylinderRegion, Region, SphereRegion, StlRegion};
use super::sizes::Distribution;
use super::vector::{Point, VelocityVector, one};

/// `[[insertion]]`; exactly one of `at`, `lattice`, `random-box`, `random-sphere`, `random-cylinder`, `random-stl`, `file`,
/// `rate` places the grains, exactly one of `diameter`, `diameter-range`, `diameter-distribution` sizes them; or `clump`
/// names what is inserted in place of grains.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Insertion {
    /// Name in messages and in the ledger.
    pub name: String,
    /// One of `[materials.*]`.
    pub material: String,
    /// Diameter of all grains (with `file`, the file's own diameters by default).
    pub diameter: Option<Length>,
    /// Smallest and largest diameter of a uniform distribution.
    pub diameter_range: Option<[Length; 2]>,
    /// Another distribution of diameters.
    pub diameter_distribution: Option<Distribution>,
    /// One of `[[clump]]`, in place of grains: places are those of its centre of mass, and random ones leave room for the
    /// sphere around it.
    pub clump: Option<String>,
    /// How clumps are turned; default as `[[clump]]` states them.
    pub orientation: Option<Turn>,
    /// Whether each clump is turned at random, uniformly.
    #[serde(default)]
    pub random_orientation: bool,
    /// Initial spin of clumps; default none.
    pub spin: Option<Spin>,
    /// Initial velocity; default at rest.
    pub velocity: Option<VelocityVector>,
    /// Whether the grains are fixed in place.
    #[serde(default)]
    pub frozen: bool,
    /// Centres, one by one.
    pub at: Option<Vec<Point>>,
    /// A regular lattice in a box.
    pub lattice: Option<Lattice>,
    /// Random places without overlap in a box.
    pub random_box: Option<RandomBox>,
    /// Random places without overlap in a sphere (2D: a circle).
    pub random_sphere: Option<RandomSphere>,
    /// Random places without overlap in a cylinder (3D).
    pub random_cylinder: Option<RandomCylinder>,
    /// Random places without overlap inside a closed surface of triangles (3D).
    pub random_stl: Option<RandomStl>,
    /// Places from a file.
    pub file: Option<GrainFile>,
    /// A region that is fed over time.
    pub rate: Option<Rate>,
}

impl Insertion {
    /// How the grains are placed: the one way that loading has checked to be stated.
    pub fn placement(&self) -> Option<Placement<'_>> {
        let random = [
            self.random_box.as_ref().map(RandomBox::fill),
            self.random_sphere.as_ref().map(RandomSphere::fill),
            self.random_cylinder.as_ref().map(RandomCylinder::fill),
            self.random_stl.as_ref().map(RandomStl::fill),
        ];
        self.at
            .as_deref()
            .map(Placement::At)
            .or(self.lattice.as_ref().map(Placement::Lattice))
            .or(random.into_iter().flatten().next().map(Placement::Random))
            .or(self.file.as_ref().map(Placement::File))
            .or(self.rate.as_ref().map(Placement::Rate))
    }

    /// Smallest and largest diameter in m; nothing if a file states them.
    pub fn diameters(&self) -> Option<[f64; 2]> {
        self.diameter
            .map(|d| [d.si(); 2])
            .or(self.diameter_range.map(|range| range.map(Length::si)))
            .or(self.diameter_distribution.as_ref().and_then(Distribution::ends))
    }

    /// Whether the case itself, or a file it names for that, sizes the grains.
    pub fn is_sized(&self) -> bool {
        self.diameter.is_some() || self.diameter_range.is_some() || self.diameter_distribution.is_some()
    }
}

/// How the grains of an insertion are placed.
#[derive(Clone, Copy, Debug)]
pub enum Placement<'a> {
    /// Centres, one by one.
    At(&'a [Point]),
    /// A regular lattice in a box.
    Lattice(&'a Lattice),
    /// Random places without overlap in a region.
    Random(RandomFill<'a>),
    /// Places from a file.
    File(&'a GrainFile),
    /// A region that is fed over time.
    Rate(&'a Rate),
}

/// Random places without overlap in a region.
#[derive(Clone, Copy, Debug)]
pub struct RandomFill<'a> {
    /// The key that states it.
    pub key: &'static str,
    /// The region.
    pub region: Region<'a>,
    /// Number of grains.
    pub count: Option<u64>,
    /// Fraction of the region that the grains fill.
    pub solid_fraction: Option<f64>,
}

/// A regular lattice of grains in a box.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Lattice {
    /// Lower corner of the box.
    pub lower: Point,
    /// Upper corner of the box.
    pub upper: Point,
    /// Distance of nearest neighbours.
    pub spacing: Length,
    /// Which lattice.
    #[serde(default)]
    pub kind: LatticeKind,
    /// Turn of the lattice about the last axis (2D: in the plane); default none.
    pub turn: Option<Angle>,
}

/// The lattices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LatticeKind {
    /// Cubes (2D: squares).
    #[default]
    SimpleCubic,
    /// Densest layers: 2D triangles, 3D hexagonal close packing.
    Hexagonal,
}

/// Random places without overlap in a box; exactly one of `count` and `solid-fraction`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct RandomBox {
    /// Lower corner of the box.
    pub lower: Point,
    /// Upper corner of the box.
    pub upper: Point,
    /// Number of grains.
    pub count: Option<u64>,
    /// Fraction of the box that the grains fill.
    pub solid_fraction: Option<f64>,
}

impl RandomBox {
    fn fill(&self) -> RandomFill<'_> {
        let Self { count, solid_fraction, .. } = *self;
        RandomFill { key: "random-box", region: Region::Box(&self.lower, &self.upper), count, solid_fraction }
    }
}

/// Random places without overlap in a sphere; exactly one of `count` and `solid-fraction`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct RandomSphere {
    /// Centre of the sphere.
    pub centre: Point,
    /// Radius of the sphere.
    pub radius: Length,
    /// Number of grains.
    pub count: Option<u64>,
    /// Fraction of the sphere that the grains fill.
    pub solid_fraction: Option<f64>,
}

impl RandomSphere {
    fn fill(&self) -> RandomFill<'_> {
        let Self { count, solid_fraction, .. } = *self;
        let region = Region::Sphere(&self.centre, self.radius);
        RandomFill { key: "random-sphere", region, count, solid_fraction }
    }
}

/// Random places without overlap in a cylinder with flat ends; exactly one of `count` and `solid-fraction`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct RandomCylinder {
    /// Centre of one end.
    pub from: Point,
    /// Centre of the other end.
    pub to: Point,
    /// Radius of the cylinder.
    pub radius: Length,
    /// Number of grains.
    pub count: Option<u64>,
    /// Fraction of the cylinder that the grains fill.
    pub solid_fraction: Option<f64>,
}

impl RandomCylinder {
    fn fill(&self) -> RandomFill<'_> {
        let Self { count, solid_fraction, .. } = *self;
        let region = Region::Cylinder(&self.from, &self.to, self.radius);
        RandomFill { key: "random-cylinder", region, count, solid_fraction }
    }
}

/// Random places without overlap inside a closed surface of triangles; exactly one of `count` and `solid-fraction`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct RandomStl {
    /// An STL file, relative to the case's folder.
    pub path: PathBuf,
    /// Such files have no unit: their coordinates times `scale` are metres.
    #[serde(default = "one")]
    pub scale: f64,
    /// Number of grains.
    pub count: Option<u64>,
    /// Fraction of the inside that the grains fill.
    pub solid_fraction: Option<f64>,
}

impl RandomStl {
    fn fill(&self) -> RandomFill<'_> {
        let Self { count, solid_fraction, .. } = *self;
        let region = Region::Stl(&self.path, self.scale);
        RandomFill { key: "random-stl", region, count, solid_fraction }
    }
}

/// Grains from a csv file (`x[m],y[m],z[m]`, and if wanted `vx[m/s]`…, `wx[rad/s]`…, `diameter[m]`), a LIGGGHTS dump or an
/// XYZ file (plain or extended), the latter in SI units; of several snapshots the last.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct GrainFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
}

/// A region that is fed over time: a box by `lower` and `upper`, or `sphere`, or `cylinder`, or `stl`; exactly one of `mass-rate` and
/// `number-rate`. What finds no room waits, and is counted in `series/turnover.csv`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Rate {
    /// Lower corner of the box.
    pub lower: Option<Point>,
    /// Upper corner of the box.
    pub upper: Option<Point>,
    /// A sphere (2D: a circle).
    pub sphere: Option<SphereRegion>,
    /// A cylinder with ends (3D).
    pub cylinder: Option<CylinderRegion>,
    /// The inside of a closed surface of triangles (3D).
    pub stl: Option<StlRegion>,
    /// Mass fed per time.
    pub mass_rate: Option<MassRate>,
    /// Grains fed per time.
    pub number_rate: Option<NumberRate>,
    /// From this time; default 0.
    pub start: Option<Time>,
    /// Until this time; default the end of the run.
    pub stop: Option<Time>,
}

impl Rate {
    /// The region: the one that loading has checked to be stated.
    pub fn region(&self) -> Option<Region<'_>> {
        let corners = self.lower.as_ref().zip(self.upper.as_ref());
        corners
            .map(|(lower, upper)| Region::Box(lower, upper))
            .or(self.sphere.as_ref().map(SphereRegion::region))
            .or(self.cylinder.as_ref().map(CylinderRegion::region))
            .or(self.stl.as_ref().map(StlRegion::region))
    }
}
