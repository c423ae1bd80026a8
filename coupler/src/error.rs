//! What ends a coupled run.

use crate::convergence::Residuals;
use crate::interaction::InteractionError;
use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use interface::InterfaceError;
use report::ReportError;
use std::path::PathBuf;
use thiserror::Error;

/// An error of the coupler: what is wrong, where, what to do.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CouplerError {
    /// The case was refused.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A file could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The report could not be made.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The other programs.
    #[error(transparent)]
    Interface(#[from] InterfaceError),
    /// The interaction laws.
    #[error(transparent)]
    Interaction(#[from] InteractionError),
    /// A participant's own failure.
    #[error("{who}: {message}")]
    Participant {
        /// Which program.
        who: &'static str,
        /// Its exit code.
        exit_code: i32,
        /// What it said.
        message: String,
    },
    /// A coupled window did not converge.
    #[error(
        "coupling: window {window} at t = {time} s has not converged after {iterations} iterations: changes in parts of \
         the tolerance are velocity {:.2}, pressure {:.2}, force {:.2}; shorten time.window, raise \
         coupling.max-iterations or use coupling.acceleration = \"aitken\"",
        .residuals.velocity, .residuals.pressure, .residuals.force
    )]
    NotConverged {
        /// Window number.
        window: u64,
        /// Its start \[s\].
        time: f64,
        /// Iterations done.
        iterations: u32,
        /// Changes of the last iteration.
        residuals: Residuals,
    },
    /// A ledger row is out of tolerance.
    #[error(
        "ledger: {row} of window {window} at t = {time} s is off by {residual:.3e} of the sum of impulses and momenta; \
         allowed: coupling.ledger-tolerance = {tolerance:.1e}; resume with a shorter window, and report the case"
    )]
    Ledger {
        /// Which row.
        row: &'static str,
        /// Window number.
        window: u64,
        /// Its start \[s\].
        time: f64,
        /// Relative residual.
        residual: f64,
        /// What is allowed.
        tolerance: f64,
    },
    /// The participants want windows that are too small.
    #[error(
        "time: a window of {bound:.3e} s is wanted by {who} at t = {time} s{}; allowed: time.smallest-window = {smallest:.3e} s; \
         {advice}", because(.reason)
    )]
    StepTooSmall {
        /// Who wants it.
        who: &'static str,
        /// Why, if it told.
        reason: String,
        /// What it wants \[s\].
        bound: f64,
        /// When \[s\].
        time: f64,
        /// What the case allows \[s\].
        smallest: f64,
        /// What to do.
        advice: &'static str,
    },
    /// An executable is missing.
    #[error("{}: there is no such executable; build all three with `cargo build --release` or name their folder with --bin-dir", path.display())]
    ExecutableMissing {
        /// Where it was looked for.
        path: PathBuf,
    },
    /// An executable cannot be started.
    #[error("{}: cannot be started: {detail}; check its permissions", path.display())]
    NotStarted {
        /// The executable.
        path: PathBuf,
        /// The system's words.
        detail: String,
    },
    /// A participant ended before it joined the run.
    #[error("{who} ended with {status} before it joined the run; its last words are in {}", log.display())]
    NotJoined {
        /// Which program.
        who: &'static str,
        /// Exit status.
        status: String,
        /// Where it wrote.
        log: PathBuf,
    },
    /// An output folder that is in use.
    #[error("--out {}: the folder is not empty; name another or remove it", path.display())]
    NotEmpty {
        /// The folder.
        path: PathBuf,
    },
    /// Nothing to go on from.
    #[error("{}: no complete restart point{skipped}; start again with `coupler run`", path.display())]
    NoRestartPoint {
        /// The folder.
        path: PathBuf,
        /// What was found instead.
        skipped: String,
    },
    /// The command line is wrong.
    #[error("{message}")]
    CommandLine {
        /// What is wrong and what to do.
        message: String,
    },
    /// The user stopped the run.
    #[error("interrupted; the run ended at a commit, at t = {time} s; go on with `coupler resume`")]
    Interrupted {
        /// Time reached \[s\].
        time: f64,
    },
}

impl CouplerError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            CouplerError::Case(error) => error.exit_code(),
            CouplerError::Interface(error) => code(error.exit_code()),
            CouplerError::Participant { exit_code, .. } => code(*exit_code),
            CouplerError::Interaction(InteractionError::OutOfRange { value, .. }) if !value.is_finite() => {
                ExitCode::NonFinite
            }
            CouplerError::Interaction(_) => ExitCode::CaseRefused,
            CouplerError::NotConverged { .. } => ExitCode::NotConverged,
            CouplerError::Ledger { residual, .. } if !residual.is_finite() => ExitCode::NonFinite,
            CouplerError::Ledger { .. } => ExitCode::Ledger,
            CouplerError::StepTooSmall { .. } => ExitCode::TimeStepTooSmall,
            CouplerError::Interrupted { .. } => ExitCode::Interrupted,
            CouplerError::CommandLine { .. } | CouplerError::NotEmpty { .. } => ExitCode::CommandLine,
            CouplerError::Output(_)
            | CouplerError::Report(_)
            | CouplerError::ExecutableMissing { .. }
            | CouplerError::NotStarted { .. }
            | CouplerError::NotJoined { .. }
            | CouplerError::NoRestartPoint { .. } => ExitCode::Environment,
        }
    }
}

fn because(reason: &str) -> String {
    if reason.is_empty() { String::new() } else { format!(", because {reason}") }
}

fn code(number: i32) -> ExitCode {
    u8::try_from(number).ok().and_then(|number| ExitCode::try_from(number).ok()).unwrap_or(ExitCode::Defect)
}
