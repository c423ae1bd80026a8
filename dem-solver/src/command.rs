//! The subcommands of `dem-solver` itself.

use case_io::exit_code::ExitCode;
use clap::Subcommand;

use crate::{bench, peer, stress};

/// What can be asked of the grains' side alone.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    #[command(flatten)]
    Peer(peer::Command),
    /// Time the steps of known scenes, here and by other programs.
    Bench(bench::Arguments),
    /// Find out what the solver bears: steps, ratios, bad starts, fast impacts, rest; exit code 4 if anything fails.
    Stress(stress::Arguments),
}

impl Command {
    /// Does it; returns the exit code.
    pub fn run(self) -> ExitCode {
        match self {
            Self::Peer(command) => command.run(),
            Self::Bench(arguments) => bench::run(&arguments),
            Self::Stress(arguments) => stress::run(&arguments),
        }
    }
}
