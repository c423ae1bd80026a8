//! `[[insertion]]`: where grains come from.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Angle, Length, MassRate, NumberRate, Time};
use super::vector::{Point, VelocityVector};

/// `[[insertion]]`; exactly one of `at`, `lattice`, `random-box`, `file`, `rate` places the grains.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Insertion {
    /// Name in messages and in the ledger.
    pub name: String,
    /// One of `[materials.*]`.
    pub material: String,
    /// Diameter of all grains (or `diameter-range`; with `file`, the file's own diameters by default).
    pub diameter: Option<Length>,
    /// Smallest and largest diameter of a uniform distribution.
    pub diameter_range: Option<[Length; 2]>,
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
    /// Places from a file.
    pub file: Option<GrainFile>,
    /// A box that is fed over time.
    pub rate: Option<Rate>,
}

impl Insertion {
    /// How the grains are placed: the one way that loading has checked to be stated.
    pub fn placement(&self) -> Option<Placement<'_>> {
        self.at
            .as_deref()
            .map(Placement::At)
            .or(self.lattice.as_ref().map(Placement::Lattice))
            .or(self.random_box.as_ref().map(Placement::RandomBox))
            .or(self.file.as_ref().map(Placement::File))
            .or(self.rate.as_ref().map(Placement::Rate))
    }

    /// Smallest and largest diameter in m; nothing if the file states them.
    pub fn diameters(&self) -> Option<[f64; 2]> {
        self.diameter.map(|d| [d.si(); 2]).or(self.diameter_range.map(|range| range.map(Length::si)))
    }
}

/// How the grains of an insertion are placed.
#[derive(Clone, Copy, Debug)]
pub enum Placement<'a> {
    /// Centres, one by one.
    At(&'a [Point]),
    /// A regular lattice in a box.
    Lattice(&'a Lattice),
    /// Random places without overlap in a box.
    RandomBox(&'a RandomBox),
    /// Places from a file.
    File(&'a GrainFile),
    /// A box that is fed over time.
    Rate(&'a Rate),
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

/// Grains from a csv file (`x[m],y[m],z[m]`, and if wanted `vx[m/s]`…, `diameter[m]`) or a LIGGGHTS dump.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct GrainFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
}

/// A box that is fed over time; exactly one of `mass-rate` and `number-rate`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Rate {
    /// Lower corner of the box.
    pub lower: Point,
    /// Upper corner of the box.
    pub upper: Point,
    /// Mass fed per time.
    pub mass_rate: Option<MassRate>,
    /// Grains fed per time.
    pub number_rate: Option<NumberRate>,
    /// From this time; default 0.
    pub start: Option<Time>,
    /// Until this time; default the end of the run.
    pub stop: Option<Time>,
}
