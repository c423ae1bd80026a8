//! A check held against a run.

use super::plan::{Planned, Question, Tolerance};
use super::trace::Trace;
use crate::summary::Check;

/// The verdict; a quantity that was not measured fails and says why.
pub(super) fn verdict(check: &Planned, measured: Result<Trace, String>) -> Check {
    let failed = |why: String| Check {
        name: check.name.clone(),
        value: f64::NAN,
        reference: f64::NAN,
        tolerance: f64::NAN,
        pass: false,
        why,
    };
    match measured.and_then(|measured| compare(check, &measured)) {
        Err(problem) => failed(problem),
        Ok((value, reference, tolerance)) => Check {
            name: check.name.clone(),
            value,
            reference,
            tolerance,
            // An infinite reference would allow everything; NaN compares false.
            pass: value.is_finite() && reference.is_finite() && (value - reference).abs() <= tolerance,
            why: check.why.clone(),
        },
    }
}

/// Value, reference and allowed absolute difference.
fn compare(check: &Planned, measured: &Trace) -> Result<(f64, f64, f64), String> {
    let relative_to = |scale: f64| match check.tolerance {
        Tolerance::Absolute(bound) => bound,
        Tolerance::Relative(bound) => bound * scale.abs(),
    };
    match &check.question {
        Question::Number(reduction, reference) => {
            Ok((reduction(&measured.within(check.window)?), *reference, relative_to(*reference)))
        }
        Question::Reduced(reduction, reference) => {
            let reference = reduction(&reference.within(check.window)?);
            Ok((reduction(&measured.within(check.window)?), reference, relative_to(reference)))
        }
        Question::Difference(norm, reference) => {
            let reference = reference.within(check.window)?;
            Ok((norm(&reference.error_of(measured)?), 0.0, relative_to(norm(&reference))))
        }
    }
}
