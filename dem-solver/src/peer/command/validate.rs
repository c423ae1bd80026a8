//! `dem-solver validate CASE --against PEER`: both programs compute the case, and a report says how far apart they are.

use std::path::{Path, PathBuf};

use ::report::report_of_sweep;
use case_io::document::Case;
use case_io::exit_code::ExitCode;
use case_io::summary::{Check, Summary};
use clap::Args;

use super::{CaseArguments, folder, say};
use crate::peer::Program;
use crate::peer::comparison::{compare_statistics, compare_trajectories};
use crate::peer::error::PeerError;
use crate::peer::launch::{Installed, write_deck};
use crate::peer::own_run::OwnRun;
use crate::peer::report::report;
use crate::peer::results;
use crate::peer::task::{Recording, Task};

/// Flags of `validate`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// The program to be compared with.
    #[arg(long, value_name = "PEER")]
    against: Program,
    /// Its executable (default: looked up by its usual name).
    #[arg(long, value_name = "PATH")]
    program: Option<PathBuf>,
    /// Allowed deviation, relative to the scale of each quantity (default 1e-5 of trajectories, 0.05 of statistics).
    #[arg(long, value_name = "SHARE", value_parser = share)]
    tolerance: Option<f64>,
    /// Threads of this program's run (default: all cores); the peer has one.
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    threads: usize,
    /// No closing words.
    #[arg(long)]
    quiet: bool,
}

fn share(text: &str) -> Result<f64, String> {
    let share = text.parse().ok().filter(|share: &f64| share.is_finite() && *share > 0.0);
    share.ok_or_else(|| "write a number above 0, for example 0.02".to_string())
}

pub(super) fn validate(arguments: &Arguments) -> Result<ExitCode, PeerError> {
    let peer = arguments.against.peer();
    let (cases, out) = arguments.case.open(arguments.against)?;
    let installed = Installed::find(peer, arguments.program.as_deref())?;
    let mut summaries = Vec::new();
    for case in &cases {
        let summary = compare(arguments, case, &installed, &folder(case, &out))?;
        summaries.push((case.run.clone().unwrap_or_default(), summary));
    }
    if cases.iter().any(|case| case.run.is_some()) {
        report_of_sweep(
            &out,
            &format!("{} against {} {}", cases[0].name, peer.name(), peer.version()),
            &summaries,
        )?;
    }
    let failed = summaries.iter().any(|(_, summary)| summary.exit.code == ExitCode::CheckFailed);
    Ok(if failed { ExitCode::CheckFailed } else { ExitCode::Done })
}

/// One run: deck, peer, this program, report.
fn compare(
    arguments: &Arguments,
    case: &Case,
    installed: &Installed,
    out: &Path,
) -> Result<Summary, PeerError> {
    let (peer, tolerance) = (arguments.against.peer(), arguments.tolerance);
    let task = Task::new(case, |law| peer.computes_alike(law))?;
    let folder = out.join(arguments.against.word());
    write_deck(&folder, &peer.deck(case, &task, Some(task.recording))?)?;
    let seconds = installed.run(&folder)?;
    let run_here = |name: &str, task: &Task| OwnRun::run(out.join(name), case, task, arguments.threads);
    let (comparison, own, how) = match task.recording {
        Recording::Trajectories => {
            let theirs = results::trajectories(&folder, &task)?;
            let own = run_here("silt", &task)?;
            let ours = own.trajectories(&task)?;
            (compare_trajectories(&task, peer.name(), &ours, &theirs, tolerance), own, "trajectories")
        }
        Recording::Statistics => {
            let theirs = results::statistics(&folder, &task)?;
            let own = run_here("silt", &task)?;
            let twin = run_here("silt-twin", &task.twin())?;
            let ours = [&own.statistics(&task)?, &twin.statistics(&task)?];
            (compare_statistics(&task, peer.name(), ours, &theirs, tolerance), own, "statistics")
        }
    };
    let summary = report(out, &own.out, (peer, seconds), &task, comparison)?;
    if !arguments.quiet {
        summary.checks.iter().for_each(|check| say(&line(check)));
        say(&format!(
            "{}: {} {} {} in {how}; report in {}",
            case.run.as_ref().unwrap_or(&case.name),
            if summary.exit.code == ExitCode::Done { "agrees with" } else { "differs from" },
            peer.name(),
            peer.version(),
            out.join("report.html").display()
        ));
    }
    Ok(summary)
}

fn line(check: &Check) -> String {
    let verdict = if check.pass { "pass" } else { "FAIL" };
    format!("{verdict}  {}: {:.3e} (allowed {:.1e})", check.name, check.value, check.tolerance)
}
