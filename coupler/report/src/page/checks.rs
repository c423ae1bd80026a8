//! The table of checks.

use case_io::summary::Summary;

use super::text::{escape, number};
use super::{nothing, table};

pub(super) fn html(summary: Option<&Summary>) -> String {
    let checks = summary.map_or(&[][..], |summary| &summary.checks);
    if checks.is_empty() {
        return nothing("No check was evaluated.");
    }
    let rows: Vec<Vec<String>> = checks
        .iter()
        .map(|check| {
            let (class, word) = if check.pass { ("good", "pass") } else { ("bad", "fail") };
            vec![
                format!("<span class=\"mark {class}\">{word}</span>"),
                escape(&check.name),
                number(check.value),
                number(check.reference),
                number(check.value - check.reference),
                number(check.tolerance),
                escape(&check.why),
            ]
        })
        .collect();
    table(&["", "check", "value", "reference", "difference", "tolerance", "why"], &rows)
}
