//! The command: a table on standard output and in a file.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use clap::Args;

use super::finding::Finding;
use super::{Effort, TRIALS};

/// Flags of `stress`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Let the pile rest for 2e4 steps instead of 1e6.
    #[arg(long)]
    quick: bool,
    /// The table as a file.
    #[arg(long, value_name = "FILE", default_value = "runs/stress.csv")]
    out: PathBuf,
}

/// Tries everything; the exit code says whether all came as expected.
pub fn run(arguments: &Arguments) -> ExitCode {
    match table(arguments) {
        Ok(0) => ExitCode::Done,
        Ok(_) => ExitCode::CheckFailed,
        Err(error) => {
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::Environment
        }
    }
}

/// How many findings fail.
fn table(arguments: &Arguments) -> Result<usize, OutputError> {
    let effort = if arguments.quick { Effort::Quick } else { Effort::Full };
    let mut file = String::from("topic,what,expected,found,verdict\n");
    // An unwritable file is told before the work is done.
    save(&arguments.out, &file)?;
    let (mut all, mut failed) = (0, 0);
    for trial in &TRIALS {
        say(trial.topic);
        for finding in (trial.findings)(effort) {
            let Finding { what, expected, found, holds } = &finding;
            let verdict = if *holds { "pass" } else { "FAIL" };
            say(&format!("  {verdict}  {what}: {found} (expected: {expected})"));
            let fields = [trial.topic, what, expected, found, verdict].map(quoted);
            let _ = writeln!(file, "{}", fields.join(","));
            all += 1;
            failed += usize::from(!holds);
        }
    }
    save(&arguments.out, &file)?;
    say(&format!("{} of {all} as expected; table in {}", all - failed, arguments.out.display()));
    Ok(failed)
}

fn save(path: &Path, text: &str) -> Result<(), OutputError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(OutputError::system("make", folder))?;
    }
    fs::write(path, text).map_err(OutputError::system("write", path))
}

/// A field of a csv file.
fn quoted(field: &str) -> String {
    format!("\"{}\"", field.replace('"', "\"\""))
}

/// A line on standard output; a closed pipe is the reader's business.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
