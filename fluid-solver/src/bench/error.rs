//! Why nothing could be measured.

use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use thiserror::Error;

use crate::error::FluidError;

/// What may go wrong.
#[derive(Debug, Error)]
pub enum BenchError {
    /// A number out of its range.
    #[error("{flag}: found {found}; allowed: {allowed}")]
    OutOfRange {
        /// The flag.
        flag: &'static str,
        /// Its value.
        found: usize,
        /// What it may be.
        allowed: &'static str,
    },
    /// No fluid where there must be some.
    #[error("at ({} m, {} m) there is no fluid at {time} s, where the exact solution has some", point[0], point[1])]
    Dry {
        /// The place \[m\].
        point: [f64; 2],
        /// The time \[s\].
        time: f64,
    },
    /// No window is short enough.
    #[error("at {time} s a thousandth of the window is too long still: {reason}")]
    TooLarge {
        /// Start of the window \[s\].
        time: f64,
        /// What the backend says.
        reason: String,
    },
    /// The scene is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The scene cannot be computed.
    #[error(transparent)]
    Fluid(#[from] FluidError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] report::ReportError),
    /// A file cannot be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl BenchError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::OutOfRange { .. } => ExitCode::CommandLine,
            Self::Dry { .. } => ExitCode::Defect,
            Self::TooLarge { .. } => ExitCode::TimeStepTooSmall,
            Self::Case(error) => error.exit_code(),
            Self::Fluid(error) => error.exit_code(),
            Self::Report(_) | Self::Output(_) => ExitCode::Environment,
        }
    }
}
