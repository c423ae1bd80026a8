//! Plots of the series.

use case_io::output::series::{Column, Series};

use super::nothing;
use super::text::escape;
use crate::ReportError;
use crate::plot::{PALETTE, Plot, Scale, plots_of, svg};
use crate::run::Run;

/// Series with a section of their own.
const CONVERGENCE: &str = "convergence";
pub(super) const LEDGER: &str = "ledger";

/// Every series but the special ones, each under its name.
pub(super) fn time_series(run: &Run) -> Result<String, ReportError> {
    let mut html = String::new();
    for (name, series) in run.series.iter().filter(|(name, _)| name != CONVERGENCE && name != LEDGER) {
        html += &format!("<h3>{}</h3>\n", escape(name));
        html += &plots(name, series, |_| Scale::Linear)?;
    }
    Ok(if html.is_empty() { nothing("The run has left no series.") } else { html })
}

/// Iterations and residuals per window.
pub(super) fn convergence(run: &Run) -> Result<String, ReportError> {
    named(
        run,
        CONVERGENCE,
        "No convergence was recorded: there was no coupling, or one iteration per window.",
    )
}

/// A series of residuals by name, or a sentence.
pub(super) fn named(run: &Run, name: &str, otherwise: &str) -> Result<String, ReportError> {
    match run.series.iter().find(|(found, _)| found == name) {
        Some((name, series)) => plots(name, series, scale_of_residuals),
        None => Ok(nothing(otherwise)),
    }
}

fn scale_of_residuals(columns: &[&Column]) -> Scale {
    Scale::for_residuals(columns.iter().flat_map(|column| column.values.iter().copied()))
}

fn plots(name: &str, series: &Series, scale: fn(&[&Column]) -> Scale) -> Result<String, ReportError> {
    if series.rows() == 0 {
        return Ok(nothing("No row was written."));
    }
    let figures: Vec<String> = plots_of(name, series, scale).iter().map(figure).collect::<Result<_, _>>()?;
    Ok(format!("<div class=\"plots\">\n{}</div>\n", figures.concat()))
}

/// A plot with its legend.
pub(super) fn figure(plot: &Plot) -> Result<String, ReportError> {
    let legend: String = plot
        .curves
        .iter()
        .zip(PALETTE)
        .map(|(curve, (r, g, b))| {
            format!("<span><i style=\"background:rgb({r},{g},{b})\"></i>{}</span>", escape(&curve.name))
        })
        .collect();
    Ok(format!("<figure><figcaption>{legend}</figcaption>\n{}</figure>\n", svg(plot)?))
}
