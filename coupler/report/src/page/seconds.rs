//! Where the time went, and what was saved.

use case_io::summary::{Seconds, Summary};

use super::text::{count, duration, escape};
use super::{nothing, table};
use crate::plot::PALETTE;

pub(super) fn html(summary: Option<&Summary>) -> String {
    let mut parts: Vec<(&String, &Seconds)> = summary.iter().flat_map(|summary| &summary.seconds).collect();
    parts.sort_by(|a, b| b.1.wall.total_cmp(&a.1.wall));
    let total: f64 = parts.iter().map(|(_, seconds)| seconds.wall).filter(|wall| wall.is_finite()).sum();
    if total <= 0.0 {
        return nothing("No time was recorded.");
    }
    let mut bar = String::new();
    let mut rows = Vec::new();
    for (number, (name, seconds)) in parts.into_iter().enumerate() {
        let (r, g, b) = PALETTE[number % PALETTE.len()];
        let share = if seconds.wall.is_finite() { 100.0 * seconds.wall / total } else { 0.0 };
        let name = escape(name);
        bar += &format!("<i style=\"width:{share:.2}%;background:rgb({r},{g},{b})\" title=\"{name}\"></i>");
        rows.push(vec![
            format!("<i class=\"swatch\" style=\"background:rgb({r},{g},{b})\"></i>{name}"),
            duration(seconds.wall),
            format!("{share:.1} %"),
            duration(seconds.cpu),
        ]);
    }
    format!("<div class=\"bar\">{bar}</div>\n{}", table(&["part", "wall", "share", "CPU"], &rows))
}

pub(super) fn thrift(summary: Option<&Summary>) -> String {
    let rows: Vec<Vec<String>> = summary
        .iter()
        .flat_map(|summary| &summary.thrift)
        .map(|(name, &times)| vec![escape(name), count(times)])
        .chain(
            summary
                .iter()
                .flat_map(|summary| &summary.taken)
                .map(|(name, taken)| vec![escape(name), format!("{taken:.4e}")]),
        )
        .collect();
    if rows.is_empty() { nothing("Nothing was counted.") } else { table(&["kind", "times or amount"], &rows) }
}
