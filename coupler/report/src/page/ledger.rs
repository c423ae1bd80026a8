//! The ledger: the largest residual of every row against its tolerance, and the residuals in time.

use super::series::{LEDGER, named};
use super::text::{escape, number};
use super::{nothing, table};
use crate::ReportError;
use crate::run::Run;

pub(super) fn html(run: &Run) -> Result<String, ReportError> {
    let rows: Vec<Vec<String>> = run
        .summary
        .iter()
        .flat_map(|summary| &summary.ledger)
        .map(|(name, row)| {
            // A residual that is not a number is not within its tolerance.
            let within = row.residual <= row.tolerance;
            let (class, word) = if within { ("good", "within") } else { ("bad", "beyond") };
            vec![
                format!("<span class=\"mark {class}\">{word}</span>"),
                escape(name),
                number(row.residual),
                number(row.tolerance),
            ]
        })
        .collect();
    let maxima = if rows.is_empty() {
        nothing("No ledger was kept.")
    } else {
        table(&["", "row", "largest residual", "tolerance"], &rows)
    };
    Ok(maxima + &named(run, LEDGER, "No ledger series was written.")?)
}
