//! The page over all runs of a sweep: what each gave, and where its own report is.

use case_io::exit_code::ExitCode;
use case_io::summary::Summary;

use super::text::{duration, escape, number};
use super::{checks, document, head};

/// The whole page, the runs by name in their order.
pub(crate) fn html(title: &str, runs: &[(String, Summary)]) -> String {
    let passed = runs.iter().filter(|(_, summary)| summary.exit.code == ExitCode::Done).count();
    let (class, word) = if passed == runs.len() { ("good", "Passed") } else { ("bad", "Not passed") };
    let sections: String = runs.iter().map(|(name, summary)| section(name, summary)).collect();
    let body = format!(
        "<header>\n<h1>{}</h1>\n</header>\n<div class=\"verdict {class}\"><strong>{word}</strong>\
         <span>{passed} of {} runs pass.</span></div>\n{sections}",
        escape(title),
        runs.len()
    );
    document(title, &body)
}

fn section(name: &str, summary: &Summary) -> String {
    let (class, word, sentence) = head::verdict(summary);
    let wall: f64 = summary.seconds.values().map(|seconds| seconds.wall).sum();
    let name = escape(name);
    format!(
        "<section>\n<h2><span class=\"mark {class}\">{word}</span> <a href=\"{name}/report.html\">{name}</a></h2>\n\
         <p class=\"origin\">{} · {} s simulated in {} · {}</p>\n{}\n</section>\n",
        escape(&summary.case),
        number(summary.time),
        duration(wall),
        escape(&sentence),
        checks::html(Some(summary))
    )
}
