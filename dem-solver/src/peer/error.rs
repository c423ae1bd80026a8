//! Why a peer could not be asked, or did not answer.

use std::io;
use std::path::PathBuf;

use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use report::ReportError;
use thiserror::Error;

use crate::error::DemError;

/// What may go wrong between this program and a peer.
#[derive(Debug, Error)]
pub enum PeerError {
    /// The peer is not installed.
    #[error(
        "{peer}: no executable \"{executable}\" found ({source}); install it, {install}, or name it with --program PATH"
    )]
    NotInstalled {
        /// Name of the peer.
        peer: &'static str,
        /// What was looked for.
        executable: String,
        /// How to install it.
        install: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// The peer is there in a version whose input or formulas may be others.
    #[error(
        "{peer}: {executable} is version \"{found}\"; allowed: {wanted}; install that one, {install}, or name it with --program PATH"
    )]
    OtherVersion {
        /// Name of the peer.
        peer: &'static str,
        /// What was asked.
        executable: String,
        /// What it said.
        found: String,
        /// The version that is known.
        wanted: &'static str,
        /// How to install it.
        install: &'static str,
    },
    /// The peer is there, but does not start or does not tell its version.
    #[error(
        "{peer}: {executable} tells no version, it says \"{said}\"; allowed: {wanted}; install that one, {install}, or name it with --program PATH"
    )]
    NoVersion {
        /// Name of the peer.
        peer: &'static str,
        /// What was asked.
        executable: String,
        /// What it said first.
        said: String,
        /// The version that is known.
        wanted: &'static str,
        /// How to install it.
        install: &'static str,
    },
    /// The peer gave up.
    #[error("{peer} failed ({how}): {tail}; all of it is in {}", log.display())]
    Failed {
        /// Name of the peer.
        peer: &'static str,
        /// Exit status, or what is missing.
        how: String,
        /// The last lines it wrote.
        tail: String,
        /// Everything it wrote.
        log: PathBuf,
    },
    /// What the peer wrote cannot be used.
    #[error("{}: {problem}; expected {expected}; look at log.txt beside it", path.display())]
    BadResult {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
        /// What should be there.
        expected: String,
    },
    /// This program's own run did not get to its end.
    #[error("the run of this program ended with exit code {}: {}; its folder is {}", code.code(), code.meaning(), out.display())]
    OwnRun {
        /// How it ended.
        code: ExitCode,
        /// Its folder.
        out: PathBuf,
    },
    /// The coupler, which runs the case, cannot be started.
    #[error("{}: {source}; build all three programs with `cargo build --release`", path.display())]
    NoCoupler {
        /// Where it should be.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A folder that holds something already.
    #[error("{}: the folder is not empty; name another or remove it", path.display())]
    NotEmpty {
        /// The folder.
        path: PathBuf,
    },
    /// The case is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The case cannot be set up.
    #[error(transparent)]
    Dem(#[from] DemError),
    /// A file cannot be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl PeerError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::NotEmpty { .. } => ExitCode::CommandLine,
            Self::OwnRun { code, .. } => *code,
            Self::Case(error) => error.exit_code(),
            Self::Dem(error) => error.exit_code(),
            Self::NotInstalled { .. }
            | Self::OtherVersion { .. }
            | Self::NoVersion { .. }
            | Self::Failed { .. }
            | Self::BadResult { .. }
            | Self::NoCoupler { .. }
            | Self::Output(_)
            | Self::Report(_) => ExitCode::Environment,
        }
    }
}
