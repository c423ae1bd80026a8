//! The command line.

mod check;
mod clean;
mod explain;
mod plan;
mod progress;
mod resume;
mod run;

use crate::error::CouplerError;
use case_io::exit_code::ExitCode;
use clap::{Args, CommandFactory, Parser, Subcommand};
use interface::command_line::{in_one_line, is_help};
use std::io::Write;
use std::path::PathBuf;

/// Grains and fluids, solved apart, coupled tight.
#[derive(Parser)]
#[command(name = "coupler", version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a case: launches what it needs, shows progress, writes the report.
    Run(run::RunArguments),
    /// Go on from the last complete restart point of an output folder.
    Resume(resume::ResumeArguments),
    /// Validate a case without running it.
    Check(CaseArguments),
    /// What is on, what is off, and why.
    Plan(CaseArguments),
    /// Explain a law, a family of laws, or an exit code.
    Explain {
        /// A word: drag, di-felice, exit, 9, …
        word: Option<String>,
    },
    /// Sweep what dead runs and checks left.
    Clean,
}

/// Which case, changed how.
#[derive(Args, Clone, Debug)]
struct CaseArguments {
    /// Case folder (with case.toml) or file.
    case: PathBuf,
    /// Change a key: --set time.end="1 s" (repeatable).
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Apply one of the case's variants.
    #[arg(long)]
    variant: Option<String>,
}

/// Runs the command line; returns the exit code.
pub fn main() -> std::process::ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return refuse(&error).into(),
    };
    let result = match arguments.command {
        Command::Run(arguments) => run::run(arguments),
        Command::Resume(arguments) => resume::resume(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Plan(arguments) => plan::plan(&arguments),
        Command::Explain { word } => explain::explain(word.as_deref()),
        Command::Clean => clean::clean(),
    };
    result.unwrap_or_else(|error| fail(&error)).into()
}

/// Help and version in full, where they are asked for or nothing is; what is wrong in one line.
fn refuse(error: &clap::Error) -> ExitCode {
    if is_help(error) {
        // Nothing can be done where not even this can be printed.
        let _ = error.print();
        return if error.use_stderr() { ExitCode::CommandLine } else { ExitCode::Done };
    }
    let message = in_one_line(error, &Arguments::command());
    fail(&CouplerError::CommandLine { message })
}

/// The one line of an error.
fn fail(error: &CouplerError) -> ExitCode {
    complain(&error.to_string());
    error.exit_code()
}

fn complain(message: &str) {
    let _ = writeln!(std::io::stderr(), "error: {message}");
}

/// A line on standard output; a closed pipe is the reader's business.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
