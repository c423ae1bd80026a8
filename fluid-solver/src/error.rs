//! What ends a fluid solver.

use crate::backend::pfem::flow::FlowFault;
use crate::boundary::BoundaryError;
use crate::mesh::MeshError;
use crate::void_fraction::VoidFractionError;
use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use interface::InterfaceError;
use interface::message::Failure;
use surface::InputError;
use thiserror::Error;

/// An error of the fluid side: what is wrong, where, what to do.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FluidError {
    /// The case was refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A file that the case names was refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The mesh was refused.
    #[error("fluid.mesh: {0}")]
    Mesh(#[from] MeshError),
    /// A step of moving nodes failed.
    #[error("fluid: {0}")]
    Step(#[from] FlowFault),
    /// Nodes between which there is no mesh.
    #[error("fluid: {0}")]
    Delaunay(#[from] delaunay::Error),
    /// The boundary conditions were refused.
    #[error(transparent)]
    Boundary(#[from] BoundaryError),
    /// A matrix cannot be used.
    #[error("fluid: {0}")]
    Linear(#[from] linear::Error),
    /// The grains were refused.
    #[error("fluid: {0}")]
    Grains(#[from] VoidFractionError),
    /// A checkpoint of another mesh.
    #[error(
        "fluid: the checkpoint holds {found} numbers of {name}, but the mesh has {nodes} nodes; resume with the mesh it was written with"
    )]
    OtherMesh {
        /// The field.
        name: &'static str,
        /// Numbers found.
        found: usize,
        /// Nodes of the mesh.
        nodes: usize,
    },
    /// A file could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The other programs.
    #[error(transparent)]
    Interface(#[from] InterfaceError),
    /// A number that is not finite.
    #[error(
        "fluid: {quantity} at node {node} {position:?} is {value} at t = {time} s; reduce time.window or refine the mesh there"
    )]
    NonFinite {
        /// Which field.
        quantity: &'static str,
        /// Which node.
        node: usize,
        /// Where \[m\].
        position: [f64; 3],
        /// What it is.
        value: f64,
        /// When \[s\].
        time: f64,
    },
    /// A stated field that is not finite at a grain.
    #[error(
        "{key}: \"{expression}\" is {value} near grain {grain}, at ({}, {}, {}) m, t = {time} s; allowed: finite numbers; \
         state a field that is finite wherever grains go", .position[0], .position[1], .position[2]
    )]
    FieldNotFinite {
        /// The key of the expression.
        key: String,
        /// The expression.
        expression: String,
        /// The grain's identity.
        grain: u64,
        /// Where \[m\].
        position: [f64; 3],
        /// When \[s\].
        time: f64,
        /// What it is.
        value: f64,
    },
    /// The grains leave too little room for the fluid.
    #[error(
        "fluid: the void fraction at node {node} {position:?} is {value:.4}, below {floor}; \
         the grains overlap or the mesh is too fine for them (cells should not be smaller than grains / 2)"
    )]
    VoidFraction {
        /// Which node.
        node: usize,
        /// Where \[m\].
        position: [f64; 3],
        /// n_f there.
        value: f64,
        /// The floor.
        floor: f64,
    },
    /// The linear solver gave up.
    #[error(
        "fluid: the linear solver stopped after {iterations} iterations at a residual of {residual:.3e} of {target:.3e} \
         allowed, at t = {time} s; reduce time.window, improve the mesh or raise fluid.solve.tolerance"
    )]
    NotConverged {
        /// Iterations done.
        iterations: usize,
        /// Residual reached.
        residual: f64,
        /// Residual allowed.
        target: f64,
        /// When \[s\].
        time: f64,
    },
}

impl FluidError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            FluidError::Case(error) => error.exit_code(),
            FluidError::Input(error) => error.exit_code(),
            FluidError::Mesh(_) | FluidError::Boundary(_) => ExitCode::CaseRefused,
            FluidError::Grains(VoidFractionError::Position { .. }) => ExitCode::NonFinite,
            FluidError::Grains(_) | FluidError::OtherMesh { .. } => ExitCode::CaseRefused,
            FluidError::Step(FlowFault::NonFinite { .. }) | FluidError::Delaunay(_) => ExitCode::NonFinite,
            FluidError::Step(FlowFault::RoundEnd { .. }) => ExitCode::CaseRefused,
            FluidError::Step(_) => ExitCode::NotConverged,
            FluidError::Linear(_) => ExitCode::NotConverged,
            FluidError::Output(_) => ExitCode::Environment,
            FluidError::Interface(error) => u8::try_from(error.exit_code())
                .ok()
                .and_then(|code| ExitCode::try_from(code).ok())
                .unwrap_or(ExitCode::Defect),
            FluidError::NonFinite { .. } | FluidError::FieldNotFinite { .. } => ExitCode::NonFinite,
            FluidError::VoidFraction { .. } => ExitCode::CaseRefused,
            FluidError::NotConverged { .. } => ExitCode::NotConverged,
        }
    }
}

impl From<FluidError> for Failure {
    fn from(error: FluidError) -> Failure {
        Failure { exit_code: i32::from(error.exit_code().code()), message: error.to_string() }
    }
}
