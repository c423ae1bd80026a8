//! The command: a map on standard output and in a file.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::PathBuf;

use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use clap::Args;

use super::outcome::Verdict;
use super::runner;
use super::trial::{Effort, trials};

/// Flags of `stress`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// Shorter runs: 500 steps of sloshing instead of 10000.
    #[arg(long)]
    quick: bool,
    /// Only trials whose topic or name contains this.
    #[arg(long, value_name = "WORD", default_value = "")]
    only: String,
    /// Folder of the table and the cases.
    #[arg(long, value_name = "DIR", default_value = "runs/fluid-stress")]
    out: PathBuf,
}

/// Tries everything; the exit code says whether nothing broke.
pub fn run(arguments: &Arguments) -> ExitCode {
    match map(arguments) {
        Ok(0) => ExitCode::Done,
        Ok(_) => ExitCode::CheckFailed,
        Err(error) => {
            // Nothing can be done where not even this can be printed.
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::Environment
        }
    }
}

/// How many trials broke.
fn map(arguments: &Arguments) -> Result<usize, OutputError> {
    let Arguments { quick, only, out } = arguments;
    fs::create_dir_all(out).map_err(OutputError::system("make", out))?;
    let path = out.join("stress.csv");
    let mut file = String::from("topic,what,verdict,found\n");
    let mut broken = 0;
    let effort = if *quick { Effort::Quick } else { Effort::Full };
    for trial in trials(effort).iter().filter(|trial| trial.topic.contains(only) || trial.what.contains(only))
    {
        let folder = out.join(format!("{}-{}", trial.topic, trial.what).replace([' ', '/'], "-"));
        let outcome = runner::run(trial, &folder)?;
        let verdict = outcome.verdict(trial.expected);
        broken += usize::from(verdict == Verdict::Broken);
        say(&format!("{:<8} {:<12} {:<28} {}", verdict.word(), trial.topic, trial.what, outcome.told()));
        let fields = [trial.topic, &trial.what, verdict.word(), &outcome.told()];
        let fields = fields.map(|field| format!("\"{}\"", field.replace('"', "\"\"")));
        let _ = writeln!(file, "{}", fields.join(","));
        fs::write(&path, &file).map_err(OutputError::system("write", &path))?;
    }
    say(&format!("{broken} broken; table in {}", path.display()));
    Ok(broken)
}

/// A line on standard output; a closed pipe is the reader's business.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}
