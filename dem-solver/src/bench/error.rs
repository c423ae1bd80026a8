//! Why nothing could be measured.

use std::path::PathBuf;

use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use thiserror::Error;

use crate::error::DemError;
use crate::peer::PeerError;

/// What may go wrong.
#[derive(Debug, Error)]
pub enum BenchError {
    /// Lanes that this processor lacks.
    #[error("--lanes: this processor has no {wanted}; it has {available}; name one of these, or \"all\"")]
    NoLanes {
        /// What was asked for.
        wanted: &'static str,
        /// What there is.
        available: String,
    },
    /// A number out of its range.
    #[error("{flag}: found {found}; allowed: {allowed}")]
    OutOfRange {
        /// The flag.
        flag: &'static str,
        /// Its value.
        found: usize,
        /// What it may be.
        allowed: String,
    },
    /// Grains that do not come to rest.
    #[error(
        "{}: after {seconds} s the grains still move at {speed:.1e} m/s (root mean square); allowed: {allowed:.0e} m/s; take another number of grains",
        folder.display()
    )]
    Restless {
        /// The folder of the scene.
        folder: PathBuf,
        /// How long they had \[s\].
        seconds: f64,
        /// Root mean square of their speeds \[m/s\].
        speed: f64,
        /// What is taken for rest \[m/s\].
        allowed: f64,
    },
    /// The process that was to tell its memory did not.
    #[error("{}: the process that computes it once more to tell its memory failed ({told})", folder.display())]
    NoMemory {
        /// The folder of the scene.
        folder: PathBuf,
        /// What it said.
        told: String,
    },
    /// Nothing counts instructions.
    #[error(
        "--instructions: valgrind cannot count them ({told}); install it, `apt-get install valgrind`, or leave the flag out"
    )]
    NoCounter {
        /// What it, or the system, said.
        told: String,
    },
    /// The scene is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The scene cannot be computed.
    #[error(transparent)]
    Dem(#[from] DemError),
    /// A peer is missing or fails.
    #[error(transparent)]
    Peer(#[from] PeerError),
    /// A file cannot be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl BenchError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::NoLanes { .. } | Self::OutOfRange { .. } => ExitCode::CommandLine,
            Self::Case(error) => error.exit_code(),
            Self::Dem(error) => error.exit_code(),
            Self::Peer(error) => error.exit_code(),
            Self::Restless { .. } => ExitCode::Defect,
            Self::NoMemory { .. } | Self::NoCounter { .. } | Self::Output(_) => ExitCode::Environment,
        }
    }
}
