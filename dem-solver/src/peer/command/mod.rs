//! The subcommands about peers.

mod export;
mod validate;

use std::io::Write;
use std::path::{Path, PathBuf};

use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;
use clap::{Args, Subcommand};

use super::Program;
use super::error::PeerError;

/// What can be asked about peers.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// Write a case as the input of another program.
    Export(export::Arguments),
    /// Run a case here and in another program, and compare.
    Validate(validate::Arguments),
}

/// Which case, changed how, and where what comes of it goes.
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
    /// Output folder (default runs/<case>-<peer>); must be empty.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Command {
    /// Does it; returns the exit code.
    pub fn run(self) -> ExitCode {
        let result = match self {
            Self::Export(arguments) => export::export(&arguments),
            Self::Validate(arguments) => validate::validate(&arguments),
        };
        result.unwrap_or_else(|error| {
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            error.exit_code()
        })
    }
}

impl CaseArguments {
    /// The runs of the case, and an empty folder for what comes of them.
    fn open(&self, program: Program) -> Result<(Vec<Case>, PathBuf), PeerError> {
        let overrides = Overrides { set: self.set.clone(), variant: self.variant.clone() };
        let cases = Case::load(&self.case, &overrides)?;
        let default = || Path::new("runs").join(format!("{}-{}", cases[0].name, program.word()));
        let out = self.out.clone().unwrap_or_else(default);
        if std::fs::read_dir(&out).is_ok_and(|mut entries| entries.next().is_some()) {
            return Err(PeerError::NotEmpty { path: out });
        }
        Ok((cases, out))
    }
}

/// The folder of a run: of its own where the case is a sweep.
fn folder(case: &Case, out: &Path) -> PathBuf {
    case.run.as_ref().map_or_else(|| out.to_path_buf(), |run| out.join(run))
}

/// A line on standard output; a closed pipe is the reader's business.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
