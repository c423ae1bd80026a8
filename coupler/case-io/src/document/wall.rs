//! `[[wall]]`: what grains touch besides each other, and what holds the fluid of backend `pfem`.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Angle, AngularVelocity, Force, Length, Mass, NumberRate, Time, Velocity};
use super::vector::{Point, VelocityVector, one};

/// `[[wall]]`; exactly one of `plane`, `cylinder`, `sphere`, `polyline`, `stl`, `obj`, `mesh` gives its shape. It holds the fluid
/// (backend `pfem`) if a `[[fluid.boundary]]` names it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Wall {
    /// Name in messages and in the ledger.
    pub name: String,
    /// One of `[materials.*]`; where there are grains.
    pub material: Option<String>,
    /// An infinite plane.
    pub plane: Option<Plane>,
    /// A circular cylinder, with or without ends (3D).
    pub cylinder: Option<Cylinder>,
    /// A sphere (2D: a circle).
    pub sphere: Option<Sphere>,
    /// Straight segments from point to point (2D).
    pub polyline: Option<Polyline>,
    /// Triangles of an STL file, ASCII or binary (3D).
    pub stl: Option<SurfaceFile>,
    /// Triangles of a Wavefront OBJ file (3D).
    pub obj: Option<SurfaceFile>,
    /// Boundary faces of the fluid mesh.
    pub mesh: Option<MeshBoundary>,
    /// Prescribed motion of any wall but `mesh`; default at rest. Shapes are stated as at t = 0.
    pub motion: Option<Motion>,
    /// Slide under a stated force, of any wall but `mesh`, on top of its prescribed motion; default none.
    pub servo: Option<Servo>,
    /// Point, fixed in space, about which `series/walls.csv` tells the torque; default the origin.
    pub torque_about: Option<Point>,
}

impl Wall {
    /// The wall's shape: the one that loading has checked to be stated.
    pub fn shape(&self) -> Option<WallShape<'_>> {
        self.plane
            .as_ref()
            .map(WallShape::Plane)
            .or(self.cylinder.as_ref().map(WallShape::Cylinder))
            .or(self.sphere.as_ref().map(WallShape::Sphere))
            .or(self.polyline.as_ref().map(WallShape::Polyline))
            .or(self.stl.as_ref().map(WallShape::Stl))
            .or(self.obj.as_ref().map(WallShape::Obj))
            .or(self.mesh.as_ref().map(WallShape::Mesh))
    }
}

/// The shape of a wall.
#[derive(Clone, Copy, Debug)]
pub enum WallShape<'a> {
    /// An infinite plane.
    Plane(&'a Plane),
    /// A circular cylinder.
    Cylinder(&'a Cylinder),
    /// A sphere.
    Sphere(&'a Sphere),
    /// Straight segments.
    Polyline(&'a Polyline),
    /// Triangles of an STL file.
    Stl(&'a SurfaceFile),
    /// Triangles of an OBJ file.
    Obj(&'a SurfaceFile),
    /// Boundary faces of the fluid mesh.
    Mesh(&'a MeshBoundary),
}

/// An infinite plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Plane {
    /// A point of the plane.
    pub point: Point,
    /// Its normal, of any length, towards grains and fluid: `dimension` bare numbers.
    pub normal: Vec<f64>,
}

/// A circular cylinder. Without `length` it has no ends, and grains are on one side of it; with `length` it is a thin
/// shell that is felt from both sides.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Cylinder {
    /// A point of the axis; with `length` the centre of one end.
    pub point: Point,
    /// Direction of the axis, of any length: three bare numbers.
    pub axis: Vec<f64>,
    /// Radius.
    pub radius: Length,
    /// Where grains, and the fluid, are (without `length` only).
    pub grains: Option<Side>,
    /// Length from `point` along `axis`; default without ends.
    pub length: Option<Length>,
    /// Whether discs close both ends (with `length` only).
    #[serde(default)]
    pub closed: bool,
}

/// A sphere (2D: a circle).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Sphere {
    /// Its centre.
    pub centre: Point,
    /// Radius.
    pub radius: Length,
    /// Where grains, and the fluid, are.
    pub grains: Side,
}

/// Straight segments from point to point (2D). Grains feel them from both sides; a fluid is on the left of the way along them.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Polyline {
    /// The points, two or more.
    pub points: Vec<Point>,
    /// Whether it goes on from the last point to the first.
    #[serde(default)]
    pub closed: bool,
}

impl Polyline {
    /// Ends of the segments (m).
    pub fn segments(&self) -> Vec<[[f64; 2]; 2]> {
        let points: Vec<[f64; 2]> = self.points.iter().map(Point::to_array).collect();
        let back = self.closed.then(|| points.first().copied()).flatten();
        let all: Vec<[f64; 2]> = points.into_iter().chain(back).collect();
        all.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}

/// On which side of a round wall grains and fluid are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// In it.
    Inside,
    /// Around it.
    Outside,
}

/// Triangles of a file. Grains feel them from both sides; a fluid is on the side that they face: from there their vertices go
/// round anticlockwise, as those of a solid body do from outside.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct SurfaceFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
    /// Such files have no unit: their coordinates times `scale` are metres.
    #[serde(default = "one")]
    pub scale: f64,
    /// How many rims the surface is meant to have: 0 if it is closed, 2 for a tube; another number is refused, as there is a
    /// hole.
    #[serde(default)]
    pub rims: usize,
}

/// Boundary faces of the fluid mesh as contact triangles (2D: segments).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct MeshBoundary {
    /// Names of boundaries of the fluid mesh.
    pub boundary: Vec<String>,
}

/// Prescribed motion: the sum of what is stated; the axis of a rotation goes along with translation and oscillation.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Motion {
    /// Constant velocity.
    pub translation: Option<VelocityVector>,
    /// Rotation at a constant rate.
    pub rotation: Option<Rotation>,
    /// Harmonic oscillation.
    pub oscillation: Option<Oscillation>,
    /// Places and angles over time.
    pub table: Option<MotionTable>,
}

/// Slide of a wall of stated mass along one direction under a stated force and that of the grains: at rest they hold the
/// force (a stress times the area under it).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Servo {
    /// Direction in which it pushes, of any length: `dimension` bare numbers.
    pub direction: Vec<f64>,
    /// The force; its weight is not added.
    pub force: Force,
    /// Its inertia: the larger, the slower it answers.
    pub mass: Mass,
    /// Largest speed.
    pub largest_speed: Velocity,
}

/// Rotation about an axis.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Rotation {
    /// Direction of the axis, of any length: three bare numbers (3D only; in 2D the axis is z).
    pub axis: Option<Vec<f64>>,
    /// A point of the axis at t = 0.
    pub point: Point,
    /// Angular velocity, right-handed about the axis.
    pub rate: AngularVelocity,
}

/// Displacement amplitude · sin(2π · frequency · t) along a direction.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Oscillation {
    /// The direction, of any length: `dimension` bare numbers.
    pub direction: Vec<f64>,
    /// Largest displacement.
    pub amplitude: Length,
    /// Oscillations per time.
    pub frequency: NumberRate,
}

/// Places and angles over time, from a csv file or from the lists `time` and `place` or `angle`; they count from the first
/// row, between rows they change linearly, before the first and after the last the wall rests.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct MotionTable {
    /// A csv file, relative to the case's folder, with the columns `t[s]`, and of `x[m],y[m],z[m],angle[rad]` what moves.
    pub path: Option<PathBuf>,
    /// Times, ascending.
    pub time: Option<Vec<Time>>,
    /// Place of any one point of the wall at each time.
    pub place: Option<Vec<Point>>,
    /// Angle at each time, right-handed about the axis.
    pub angle: Option<Vec<Angle>>,
    /// Direction of the axis of the angle, of any length: three bare numbers (3D only; in 2D the axis is z).
    pub axis: Option<Vec<f64>>,
    /// A point of the axis of the angle as the wall is stated.
    pub point: Option<Point>,
}
