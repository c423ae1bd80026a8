//! A check, once its table makes sense and its reference is read.

use std::path::Path;

use super::Measured;
use super::table::{CheckTable, ColumnTable, ReferenceTable, Take};
use super::trace::{Trace, Window, column};
use crate::error::CaseError;
use crate::output::series::{Series, Title};
use crate::tree::Source;

#[derive(Clone, Debug)]
pub(super) struct Planned {
    pub run: Option<String>,
    pub name: String,
    pub measured: Measured,
    pub window: Window,
    pub question: Question,
    pub tolerance: Tolerance,
    pub why: String,
}

/// One number of a trace.
pub(super) type Reduction = fn(&Trace) -> f64;

#[derive(Clone, Debug)]
pub(super) enum Question {
    /// Is one number of the run this number?
    Number(Reduction, f64),
    /// Is one number of the run that of the reference?
    Reduced(Reduction, Trace),
    /// Is the difference between run and reference small in this norm?
    Difference(Reduction, Trace),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Tolerance {
    /// Times the reference.
    Relative(f64),
    /// In the unit of the quantity.
    Absolute(f64),
}

/// Refuses a table that could not be held against a run.
pub(super) fn plan(
    check: CheckTable,
    index: usize,
    folder: &Path,
    source: &Source,
) -> Result<Planned, CaseError> {
    let key = |name: &str| format!("check[{index}].{name}");
    let refuse = |name: &str, found: &str, allowed: &str| Err(source.error(&key(name), found, allowed, ""));
    let measured = check.quantity.split_once('.').and_then(|(file, title)| {
        let title = title.parse().ok()?;
        (!file.is_empty() && !file.contains(['/', '\\'])).then(|| Measured { file: file.into(), title })
    });
    let Some(measured) = measured else {
        let found = format!("found \"{}\"", check.quantity);
        return refuse("quantity", &found, "FILE.NAME[UNIT], for example \"grains.vz[m/s]\"");
    };
    if check.why.trim().is_empty() {
        return refuse("why", "is empty", "the source of the reference");
    }
    let window = Window { from: check.from.map(|time| time.si()), to: check.to.map(|time| time.si()) };
    if let (Some(from), Some(to)) = (check.from, check.to)
        && from.si() > to.si()
    {
        return refuse("to", &format!("found {to}"), &format!("from {from} on"));
    }
    let (reduction, is_error): (Reduction, bool) = match check.take {
        Take::Last => (Trace::last, false),
        Take::Max => (Trace::largest, false),
        Take::Min => (Trace::smallest, false),
        Take::Mean => (Trace::mean, false),
        Take::AbsMax => (Trace::largest_magnitude, false),
        Take::ErrorL2 => (Trace::root_mean_square, true),
        Take::ErrorMax => (Trace::largest_magnitude, true),
    };
    let question = match &check.reference {
        ReferenceTable::Number(_) if is_error => {
            return refuse("reference", "an error over time needs a column", "{ file, column, time-column }");
        }
        ReferenceTable::Number(number) => Question::Number(reduction, *number),
        ReferenceTable::Column(column) => {
            let reference = reference(column, &measured.title, folder).map_err(|(name, problem)| {
                source.error(&key(&format!("reference.{name}")), problem, "", "")
            })?;
            if is_error {
                Question::Difference(reduction, reference)
            } else {
                Question::Reduced(reduction, reference)
            }
        }
    };
    let tolerance = tolerance(&check, &question, index, source)?;
    Ok(Planned { run: check.run, name: check.name, measured, window, question, tolerance, why: check.why })
}

fn tolerance(
    check: &CheckTable,
    question: &Question,
    index: usize,
    source: &Source,
) -> Result<Tolerance, CaseError> {
    let refuse = |key: &str, found: &str, allowed: &str| {
        Err(source.error(&format!("check[{index}]{key}"), found, allowed, ""))
    };
    let tolerance = match (check.tolerance, check.absolute_tolerance) {
        (Some(relative), None) => Tolerance::Relative(relative),
        (None, Some(absolute)) => Tolerance::Absolute(absolute),
        _ => {
            return refuse("", "how near is not stated once", "exactly one of tolerance, absolute-tolerance");
        }
    };
    let (name, bound) = match tolerance {
        Tolerance::Relative(bound) => ("tolerance", bound),
        Tolerance::Absolute(bound) => ("absolute-tolerance", bound),
    };
    if bound < 0.0 {
        return refuse(&format!(".{name}"), &format!("found {bound}"), "0 or more");
    }
    if matches!((question, tolerance), (Question::Number(_, 0.0), Tolerance::Relative(_))) {
        return refuse(".tolerance", "a fraction of the reference 0 allows nothing", "absolute-tolerance");
    }
    Ok(tolerance)
}

/// The reference's trace, or the key that is wrong and why.
fn reference(table: &ColumnTable, measured: &Title, folder: &Path) -> Result<Trace, (&'static str, String)> {
    if table.column.unit != measured.unit {
        return Err(("column", format!("found the unit {}, not {}", table.column.unit, measured.unit)));
    }
    let series = Series::read(&folder.join(&table.file)).map_err(|error| ("file", error.to_string()))?;
    let time = column(series.columns(), &table.time_column).map_err(|problem| ("time-column", problem))?;
    let values = column(series.columns(), &table.column).map_err(|problem| ("column", problem))?;
    Trace::new(time.values.clone(), values.values.clone()).map_err(|problem| ("file", problem))
}
