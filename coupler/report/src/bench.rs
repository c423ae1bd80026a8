//! Error against work: what a benchmark has measured, as curves.

use crate::ReportError;
use crate::page;
use case_io::output::replace_file;
use std::path::Path;

/// What an axis counts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Amount {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
}

/// Curves of error against work, both on logarithmic scales.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkPrecision {
    /// What was computed.
    pub title: String,
    /// What the work is measured in.
    pub work: Amount,
    /// What the error is.
    pub error: String,
    /// By name, points (work, error).
    pub curves: Vec<(String, Vec<(f64, f64)>)>,
}

/// Writes `report.html` over the plots of a benchmark.
///
/// # Errors
/// A plot that cannot be drawn, a report that cannot be written.
pub fn report_of_bench(directory: &Path, title: &str, plots: &[WorkPrecision]) -> Result<(), ReportError> {
    let html = page::bench_html(title, plots)?;
    Ok(replace_file(&directory.join("report.html"), &[html.as_bytes()])?)
}
