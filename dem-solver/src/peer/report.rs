//! The report on a comparison: that of a run, whose checks are the verdicts and whose series show both programs.

use std::fs;
use std::path::Path;

use case_io::exit_code::ExitCode;
use case_io::output::OutputError;
use case_io::output::series::SeriesWriter;
use case_io::summary::{Exit, Seconds, Summary};

use super::Peer;
use super::comparison::{Comparison, Curves};
use super::error::PeerError;
use super::task::Task;

/// Writes `summary.json`, `series/` and `report.html`; `own_run` is the folder of this program's run, whose counts
/// and seconds are told too, and `seconds` the peer's wall time. Returns the summary.
///
/// # Errors
/// The disk's.
pub fn report(
    out: &Path,
    own_run: &Path,
    (peer, seconds): (&dyn Peer, f64),
    task: &Task,
    comparison: Comparison,
) -> Result<Summary, PeerError> {
    let Comparison { checks, curves } = comparison;
    let folder = out.join("series");
    fs::create_dir_all(&folder).map_err(OutputError::system("make", &folder))?;
    for Curves { name, columns } in &curves {
        write(&folder.join(format!("{name}.csv")), task, columns)?;
    }
    let failed = checks.iter().filter(|check| !check.pass).count();
    let mut summary = Summary::read(&own_run.join("summary.json"))?;
    summary.case = format!("{}: silt against {} {}", task.title, peer.name(), peer.version());
    summary.exit = match failed {
        0 => Exit { code: ExitCode::Done, reason: format!("all checks against {} pass", peer.name()) },
        _ => Exit { code: ExitCode::CheckFailed, reason: format!("silt and {} differ", peer.name()) },
    };
    summary.checks = checks;
    summary.seconds.insert(peer.name().to_string(), Seconds { wall: seconds, cpu: seconds });
    summary.write(&out.join("summary.json"))?;
    report::report(out)?;
    Ok(summary)
}

fn write(path: &Path, task: &Task, columns: &[(String, Vec<f64>)]) -> Result<(), PeerError> {
    let titles: Vec<&str> =
        std::iter::once("t[s]").chain(columns.iter().map(|(title, _)| title.as_str())).collect();
    let mut series = SeriesWriter::create(path, &titles)?;
    for sample in 0..task.samples as usize {
        let time = task.interval() * (sample + 1) as f64;
        let values = columns.iter().map(|(_, values)| values[sample]);
        series.row(&std::iter::once(time).chain(values).collect::<Vec<_>>())?;
    }
    Ok(())
}
