//! What the fluid gained and lost, by what did it.

use case_io::summary::Summary;

use super::text::escape;
use super::{section, table};

/// The section; nothing of a run that audits nothing.
pub(super) fn html(summary: Option<&Summary>) -> String {
    let Some(audits) = summary.map(|summary| &summary.audits).filter(|audits| !audits.is_empty()) else {
        return String::new();
    };
    let row = |(name, value): (&String, &f64)| vec![escape(name), format!("{value:.4e}")];
    section(
        "Audits of the fluid",
        &table(&["at the end", "value"], &audits.iter().map(row).collect::<Vec<_>>()),
    )
}
