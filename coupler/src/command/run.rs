//! `coupler run CASE`.

use super::progress::Progress;
use super::{CaseArguments, complain, say};
use crate::error::CouplerError;
use crate::run::{Request, run as run_case};
use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use case_io::summary::Summary;
use clap::Args;
use interface::participant::Hold;
use interface::run::Who;
use report::report_of_sweep;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{SystemTime, UNIX_EPOCH};

/// Flags of `run`.
#[derive(Args, Clone, Debug)]
pub(super) struct RunArguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Output folder (default runs/<case>-<time>); must be empty.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    manner: Manner,
}

/// How a run is made.
#[derive(Args, Clone, Debug)]
pub(super) struct Manner {
    /// Threads of each solver (default: all cores; only one solver computes at a time).
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    threads: usize,
    /// No progress bar, no closing words.
    #[arg(long)]
    pub(super) quiet: bool,
    /// The summary as JSON on standard output.
    #[arg(long)]
    json: bool,
    /// Folder of the three executables (default: where this one is).
    #[arg(long, value_name = "DIR")]
    bin_dir: Option<PathBuf>,
    /// A participant stays at PROGRAM:WINDOW:COMMAND (for tests of faults).
    #[arg(long, hide = true, value_parser = parse_hold)]
    hold: Option<(Who, u64, String)>,
}

fn parse_hold(text: &str) -> Result<(Who, u64, String), String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [who, window, command] = parts[..] else { return Err("write PROGRAM:WINDOW:COMMAND".into()) };
    let who = Who::ALL.into_iter().find(|known| known.name() == who).ok_or("no such program")?;
    Ok((who, window.parse().map_err(|_| "the window is no number")?, command.to_string()))
}

pub(super) fn run(arguments: RunArguments) -> Result<ExitCode, CouplerError> {
    let RunArguments { case: CaseArguments { case, set, variant }, out, manner } = arguments;
    let cases = Case::load(&case, &Overrides { set: set.clone(), variant: variant.clone() })?;
    let out = out.unwrap_or_else(|| default_folder(&cases[0].name));
    refuse_used_folder(&out)?;
    let request = Request { case, set, variant, ..manner.request(&out) };
    run_all(&cases, &request, &out, None, &manner)
}

impl Manner {
    pub(super) fn request(&self, out: &Path) -> Request {
        let marker = out.join("held");
        let hold = |(who, window, command): (Who, u64, String)| (who, Hold { window, command, marker });
        Request {
            threads: self.threads,
            bin_dir: self.bin_dir.clone(),
            hold: self.hold.clone().map(hold),
            ..Request::default()
        }
    }
}

/// Runs each run of a case; a sweep gets a folder for each, and a summary and a report over all.
pub(super) fn run_all(
    cases: &[Case],
    request: &Request,
    out: &Path,
    resume: Option<&Path>,
    manner: &Manner,
) -> Result<ExitCode, CouplerError> {
    let interrupted = Arc::new(AtomicBool::new(false));
    listen_for_interrupts(&interrupted);
    let mut summaries = Vec::new();
    let mut worst = ExitCode::Done;
    for case in cases {
        let folder = case.run.as_ref().map_or_else(|| out.to_path_buf(), |name| out.join(name));
        let mut progress = Progress::new(case.run.as_deref().unwrap_or(&case.name), manner.quiet);
        let summary = run_case(case, request, &folder, resume, &interrupted, &mut progress)?;
        progress.finish();
        close(case, &summary, &folder, manner);
        if worst == ExitCode::Done {
            worst = summary.exit.code;
        }
        let goes_on = matches!(summary.exit.code, ExitCode::Done | ExitCode::CheckFailed);
        summaries.push((case.run.clone().unwrap_or_default(), summary));
        if !goes_on {
            break;
        }
    }
    if cases.iter().any(|case| case.run.is_some()) {
        gather(&cases[0].name, &summaries, out)?;
    }
    Ok(worst)
}

/// What all runs of a sweep gave, for programs and for people.
fn gather(case: &str, summaries: &[(String, Summary)], out: &Path) -> Result<(), CouplerError> {
    let path = out.join("summary.json");
    let by_name: BTreeMap<&str, &Summary> =
        summaries.iter().map(|(name, summary)| (name.as_str(), summary)).collect();
    let text = serde_json::to_string_pretty(&by_name).unwrap_or_default();
    fs::write(&path, text).map_err(OutputError::system("write", &path))?;
    Ok(report_of_sweep(out, case, summaries)?)
}

/// The first Ctrl-C ends the run at the next commit, the second at once.
fn listen_for_interrupts(interrupted: &Arc<AtomicBool>) {
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::flag;
    for signal in [SIGINT, SIGTERM] {
        // Without a handler the signal still ends the program.
        let _ = flag::register_conditional_shutdown(
            signal,
            i32::from(ExitCode::Interrupted.code()),
            interrupted.clone(),
        );
        let _ = flag::register(signal, interrupted.clone());
    }
}

fn close(case: &Case, summary: &Summary, folder: &Path, manner: &Manner) {
    if manner.json {
        say(&serde_json::to_string(summary).unwrap_or_default());
    }
    if !matches!(summary.exit.code, ExitCode::Done | ExitCode::CheckFailed) {
        let reason = &summary.exit.reason;
        complain(&case.run.as_ref().map_or_else(|| reason.clone(), |run| format!("run {run}: {reason}")));
    }
    if manner.quiet || manner.json {
        return;
    }
    for check in &summary.checks {
        let verdict = if check.pass { "pass" } else { "FAIL" };
        say(&format!(
            "{verdict}  {}: {:.6e} (reference {:.6e} ± {:.1e})",
            check.name, check.value, check.reference, check.tolerance
        ));
    }
    let name = case.run.as_deref().unwrap_or(&case.name);
    let wall: f64 = summary.seconds.values().map(|part| part.wall).sum();
    say(&format!(
        "{name}: t = {} s, {} windows, {:.2} iterations a window, {wall:.1} s; report in {}",
        summary.time,
        summary.counts.windows,
        summary.iterations_per_window(),
        folder.join("report.html").display()
    ));
}

fn default_folder(case: &str) -> PathBuf {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |elapsed| elapsed.as_secs());
    PathBuf::from("runs").join(format!("{case}-{}", stamp(seconds)))
}

/// `20261122-153000` in UTC (civil-from-days: Hinnant 2013).
fn stamp(seconds: u64) -> String {
    let (days, second) = ((seconds / 86_400) as i64 + 719_468, seconds % 86_400);
    let era = days / 146_097;
    let day_of_era = days - era * 146_097;
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}{month:02}{day:02}-{:02}{:02}{:02}", second / 3600, second / 60 % 60, second % 60)
}

fn refuse_used_folder(out: &Path) -> Result<(), CouplerError> {
    let is_used = fs::read_dir(out).is_ok_and(|mut entries| entries.next().is_some());
    if is_used { Err(CouplerError::NotEmpty { path: out.to_path_buf() }) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_named_by_the_calendar() {
        assert_eq!(stamp(0), "19700101-000000");
        assert_eq!(stamp(951_782_400 + 3_661), "20000229-010101");
        assert_eq!(stamp(1_795_316_400), "20261122-030000");
    }
}
