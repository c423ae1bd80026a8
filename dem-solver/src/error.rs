//! Errors of the grains' side.

use std::path::PathBuf;

use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use interface::InterfaceError;
use interface::message::Failure;
use thiserror::Error;

use crate::bond::BondError;
use crate::fault::Fault;
use surface::InputError;

/// What may go wrong.
#[derive(Debug, Error)]
pub enum DemError {
    /// Something went wrong while grains moved.
    #[error("at t = {time} s: {fault}; {}", .fault.advice())]
    Fault {
        /// What, and which grain.
        fault: Fault,
        /// Start of the window \[s\].
        time: f64,
    },
    /// A periodic axis is too short.
    #[error(
        "grains.periodic: the domain is {period} m long in {axis}; it must be longer than {least} m, twice the reach of the largest grain; lengthen the domain or use smaller grains"
    )]
    PeriodTooShort {
        /// The axis.
        axis: &'static str,
        /// Its length \[m\].
        period: f64,
        /// Not even this is enough \[m\].
        least: f64,
    },
    /// The time step is above its bound.
    #[error(
        "time.substep: {step} s is above the critical step {limit} s, which {binding} sets; take a smaller substep or a softer material"
    )]
    StepTooLarge {
        /// The step \[s\].
        step: f64,
        /// Its bound \[s\].
        limit: f64,
        /// What sets the bound.
        binding: String,
    },
    /// A window would take too many substeps.
    #[error(
        "time.window: {window} s takes {count:.3e} substeps of {step} s, more than {most} allowed; {binding} sets the substep; take a shorter window or a softer material"
    )]
    TooManySubsteps {
        /// The window \[s\].
        window: f64,
        /// The step \[s\].
        step: f64,
        /// How many.
        count: f64,
        /// How many are allowed.
        most: u32,
        /// What sets the step.
        binding: String,
    },
    /// A window that is not a positive time, or has no substep.
    #[error(
        "time.window: {window} s in {substeps} substeps cannot be stepped through; take a positive, finite window and at least one substep"
    )]
    BadWindow {
        /// The window \[s\].
        window: f64,
        /// Its substeps.
        substeps: u32,
    },
    /// The fluid speaks of other grains than there are.
    #[error(
        "hydro frame: {rows} rows for {grains} grains; the frame must hold one row per grain, in their order"
    )]
    WrongRows {
        /// Rows of the frame.
        rows: usize,
        /// Number of grains.
        grains: usize,
    },
    /// Clumps feel no fluid.
    #[error(
        "clump: there are {clumps} clumps in a fluid, which would not feel it; insert grains, or leave out [fluid]"
    )]
    ClumpsInFluid {
        /// How many.
        clumps: usize,
    },
    /// The fluid asks for a drag or an added mass that would drive the grain.
    #[error(
        "hydro frame, grain {grain}: exchange coefficient {exchange_coefficient} kg/s, added mass {added_mass} kg; neither may be negative or not a number; look at the drag law and the sampled fluid"
    )]
    BadHydro {
        /// Identity of the grain.
        grain: u64,
        /// Exchange coefficient β \[kg/s\].
        exchange_coefficient: f64,
        /// Added mass m_A \[kg\].
        added_mass: f64,
    },
    /// Grains are missing.
    #[error(
        "grains: {found} are left of {born} born and {removed} removed; this is a defect of the program, please report it with the case"
    )]
    Lost {
        /// Grains there are.
        found: usize,
        /// Grains ever born.
        born: u64,
        /// Grains ever removed.
        removed: u64,
    },
    /// Grains do not fit.
    #[error(
        "insertion {insertion}: {fitted} of {wanted} grains fitted: {why}; ask for fewer or smaller grains, or for a larger region"
    )]
    NoRoom {
        /// Name of the insertion.
        insertion: String,
        /// How many fitted.
        fitted: usize,
        /// How many were asked for.
        wanted: usize,
        /// What was in the way of the next.
        why: String,
    },
    /// A file that the case names.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A bond cannot be.
    #[error(transparent)]
    Bond(#[from] BondError),
    /// The case is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A checkpoint cannot be written or read.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The other programs.
    #[error(transparent)]
    Interface(#[from] InterfaceError),
    /// A checkpoint is whole but does not belong to this case.
    #[error("{path}: {what}; resume with the case, and the program, that wrote it")]
    ForeignCheckpoint {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        what: &'static str,
    },
}

impl DemError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Case(error) => error.exit_code(),
            Self::Interface(error) => u8::try_from(error.exit_code())
                .ok()
                .and_then(|code| ExitCode::try_from(code).ok())
                .unwrap_or(ExitCode::Defect),
            Self::Input(error) => error.exit_code(),
            Self::Output(_) | Self::ForeignCheckpoint { .. } => ExitCode::Environment,
            Self::Fault { fault: Fault::NotFinite { .. }, .. } | Self::BadHydro { .. } => ExitCode::NonFinite,
            Self::Fault { .. } | Self::Lost { .. } => ExitCode::Ledger,
            Self::TooManySubsteps { .. } => ExitCode::TimeStepTooSmall,
            Self::WrongRows { .. } => ExitCode::Defect,
            _ => ExitCode::CaseRefused,
        }
    }
}

impl From<DemError> for Failure {
    fn from(error: DemError) -> Failure {
        Failure { exit_code: i32::from(error.exit_code().code()), message: error.to_string() }
    }
}
