//! The command line that both solvers share: `run` alone, `participate` for the coupler, and what a solver adds.

use crate::assignment::Assignment;
use crate::command_line::{in_one_line, is_help};
use crate::error::InterfaceError;
use crate::run::{Who, leave_interrupts_to_coupler};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::io::Write;
use std::process::{Command, ExitCode};

/// One side of a coupled run; alone on a case without the other.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Arguments<Own: Subcommand> {
    #[command(subcommand)]
    task: Task<Own>,
}

#[derive(Subcommand)]
enum Task<Own: Subcommand> {
    /// Run a case that has no other side, with the flags and the output of `coupler run`.
    Run {
        /// Case and flags, as for `coupler run`.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Take part in a coupled run (used by the coupler).
    #[command(hide = true)]
    Participate {
        /// What the coupler wants.
        assignment: String,
    },
    #[command(flatten)]
    Own(Own),
}

/// A command line that is not understood.
const COMMAND_LINE: u8 = 2;
/// The coupler beside the solver cannot be started.
const ENVIRONMENT: u8 = 5;

/// Runs the command line of a solver, which does what is said `about` it and may have subcommands of its `own`; returns
/// the exit code.
pub fn main<Own: Subcommand>(
    (who, about): (Who, &'static str),
    participate: impl FnOnce(&Assignment) -> Result<(), InterfaceError>,
    own: impl FnOnce(Own) -> ExitCode,
) -> ExitCode {
    let command = || Arguments::<Own>::command().name(who.name()).about(about);
    let arguments =
        command().try_get_matches().and_then(|matches| Arguments::<Own>::from_arg_matches(&matches));
    match arguments {
        Ok(Arguments { task: Task::Own(asked) }) => own(asked),
        Ok(Arguments { task: Task::Run { arguments } }) => run_by_coupler(&arguments),
        Ok(Arguments { task: Task::Participate { assignment } }) => {
            leave_interrupts_to_coupler();
            match Assignment::from_argument(&assignment).and_then(|part| participate(&part)) {
                Ok(()) => ExitCode::SUCCESS,
                Err(error) => {
                    say(&format!("{who}: {error}"));
                    u8::try_from(error.exit_code()).map_or(ExitCode::FAILURE, ExitCode::from)
                }
            }
        }
        Err(error) => refuse(&error, &command()),
    }
}

/// Help and version in full, where they are asked for or nothing is; what is wrong in one line.
fn refuse(error: &clap::Error, command: &clap::Command) -> ExitCode {
    if is_help(error) {
        // Nothing can be done where not even this can be printed.
        let _ = error.print();
    } else {
        say(&format!("error: {}", in_one_line(error, command)));
    }
    if error.use_stderr() { ExitCode::from(COMMAND_LINE) } else { ExitCode::SUCCESS }
}

/// Runs `coupler run` with these arguments; its exit code is this program's.
fn run_by_coupler(arguments: &[String]) -> ExitCode {
    let coupler = std::env::current_exe().map(|own| own.with_file_name("coupler")).unwrap_or_default();
    match Command::new(&coupler).arg("run").args(arguments).status() {
        Ok(status) => {
            status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::FAILURE, ExitCode::from)
        }
        Err(error) => {
            let path = coupler.display();
            say(&format!("error: {path}: {error}; build all three programs with `cargo build --release`"));
            ExitCode::from(ENVIRONMENT)
        }
    }
}

fn say(line: &str) {
    // Nothing can be done where not even this can be printed.
    let _ = writeln!(std::io::stderr(), "{line}");
}
