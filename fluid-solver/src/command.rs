//! The subcommands of `fluid-solver` itself.

use case_io::exit_code::ExitCode;
use clap::Subcommand;

use crate::{bench, stress};

/// What can be asked of the fluid's side alone.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// Measure error against processor time on flows with an exact solution.
    Bench(bench::Arguments),
    /// Map what is right, stable or refused at the extremes; exit code 4 if anything breaks.
    Stress(stress::Arguments),
}

impl Command {
    /// Does it; returns the exit code.
    pub fn run(self) -> ExitCode {
        match self {
            Self::Bench(arguments) => bench::run(&arguments),
            Self::Stress(arguments) => stress::run(&arguments),
        }
    }
}
