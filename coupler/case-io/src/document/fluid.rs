//! `[fluid]`: the side of the fluid; present, a fluid-solver runs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::boundary::{Boundary, BoundaryVelocity};
use super::gate::{Inlet, Outlet};
use super::mesh::Mesh;
use super::pfem::{Body, Pfem};
use super::quantity::{Density, Viscosity};
use super::vector::AccelerationVector;
use crate::expression::Expression;

/// `[fluid]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Fluid {
    /// What computes the fluid.
    pub backend: Backend,
    /// Mass density of the fluid.
    pub density: Density,
    /// Dynamic viscosity.
    pub viscosity: Viscosity,
    /// Initial velocity, of t = 0; default at rest.
    pub velocity: Option<BoundaryVelocity>,
    /// Extra acceleration besides gravity; default none.
    pub body_force: Option<AccelerationVector>,
    /// The flow itself (`imposed` only).
    pub field: Option<Field>,
    /// Settings of the linear solver.
    pub solve: Option<Solve>,
    /// The mesh (not for `imposed`).
    pub mesh: Option<Mesh>,
    /// Conditions on the mesh's boundaries (not for `imposed`).
    #[serde(default)]
    pub boundary: Vec<Boundary>,
    /// More fluid at the start (`pfem` only).
    #[serde(default)]
    pub body: Vec<Body>,
    /// Where fluid comes in besides boundaries of the mesh (`pfem` only).
    #[serde(default)]
    pub inlet: Vec<Inlet>,
    /// Where fluid leaves besides boundaries of the mesh (`pfem` only).
    #[serde(default)]
    pub outlet: Vec<Outlet>,
    /// Settings of `pfem`.
    pub pfem: Option<Pfem>,
}

impl Fluid {
    /// Relative residual at which the linear solver stops.
    pub fn solve_tolerance(&self) -> f64 {
        self.solve.as_ref().map_or(default_tolerance(), |solve| solve.tolerance)
    }
}

/// What computes the fluid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Backend {
    /// The flow is stated by expressions.
    Imposed,
    /// Stabilised finite elements on a fixed mesh.
    Eulerian,
    /// Finite elements whose nodes move with the fluid, with free surfaces.
    Pfem,
}

/// A flow stated by expressions of x, y, z, t in SI.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Field {
    /// Velocity in m/s, one expression for each dimension.
    pub velocity: Vec<Expression>,
    /// Pressure in Pa.
    pub pressure: Expression,
}

/// Settings of the linear solver.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Solve {
    /// Relative residual at which the linear solver stops.
    #[serde(default = "default_tolerance")]
    pub tolerance: f64,
}

fn default_tolerance() -> f64 {
    1e-8
}
