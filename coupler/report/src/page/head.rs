//! Title, verdict and the facts of the run.

use case_io::exit_code::ExitCode;
use case_io::summary::Summary;

use super::text::{bytes, count, duration, escape, number};
use crate::run::Run;

pub(super) fn html(run: &Run) -> String {
    let Some(summary) = &run.summary else {
        let rows = run.series.iter().map(|(_, series)| series.rows()).max().unwrap_or(0);
        return format!(
            "<header>\n<h1>Unfinished run</h1>\n</header>\n<div class=\"verdict bad\"><strong>No verdict</strong>\
             <span>There is no readable summary.json: the run was killed, or it still goes on. What it wrote so far, {} \
             rows of series, is below; coupler resume goes on from the last restart point.</span></div>\n",
            count(rows as u64)
        );
    };
    let (class, word, sentence) = verdict(summary);
    let facts: String = facts(summary)
        .into_iter()
        .map(|(name, value)| format!("<div><dt>{name}</dt><dd>{value}</dd></div>\n"))
        .collect();
    format!(
        "<header>\n<h1>{}</h1>\n<p class=\"origin\">silt {} · case {}</p>\n</header>\n\
         <div class=\"verdict {class}\"><strong>{word}</strong><span>{}</span></div>\n<dl class=\"facts\">\n{facts}</dl>\n",
        escape(&summary.case),
        escape(&summary.program_version),
        escape(summary.case_hash.get(..12).unwrap_or(&summary.case_hash)),
        escape(&sentence)
    )
}

/// Class, word and sentence.
pub(super) fn verdict(summary: &Summary) -> (&'static str, &'static str, String) {
    let code = summary.exit.code;
    let checks = summary.checks.len();
    let failed = summary.checks.iter().filter(|check| !check.pass).count();
    let number = code.code();
    match code {
        ExitCode::Done => ("good", "Passed", format!("{checks} of {checks} checks pass.")),
        ExitCode::CheckFailed => {
            ("bad", "Failed", format!("{failed} of {checks} checks failed. {}", summary.exit.reason))
        }
        ExitCode::Interrupted => {
            ("fair", "Interrupted", format!("{} To go on: {}.", summary.exit.reason, code.advice()))
        }
        _ => (
            "bad",
            "Stopped",
            format!(
                "{} (exit code {number}: {}). To do: {}.",
                summary.exit.reason,
                code.meaning(),
                code.advice()
            ),
        ),
    }
}

fn facts(summary: &Summary) -> Vec<(&'static str, String)> {
    let counts = &summary.counts;
    let wall: f64 = summary.seconds.values().map(|seconds| seconds.wall).sum();
    let mut facts = vec![
        ("simulated", format!("{} s", number(summary.time))),
        ("wall time", duration(wall)),
        ("windows", count(counts.windows)),
        ("iterations per window", number(summary.iterations_per_window())),
        ("substeps", count(counts.substeps)),
    ];
    if counts.refused > 0 {
        facts.push(("windows offered anew", count(counts.refused)));
    }
    if counts.grains > 0 {
        facts.push(("grains", count(counts.grains)));
    }
    if counts.nodes > 0 {
        facts.push(("fluid nodes", count(counts.nodes)));
    }
    facts.push(("peak memory", bytes(summary.peak_memory)));
    facts
}
