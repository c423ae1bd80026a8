//! A row of the table.

use std::ops::RangeInclusive;

use crate::error::DemError;

/// What was tried, what should come of it, and what did.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What was tried.
    pub what: String,
    /// What should come of it.
    pub expected: String,
    /// What came of it.
    pub found: String,
    /// Whether that is what should.
    pub holds: bool,
}

impl Finding {
    /// A number that should lie in a range; `name` says what it is.
    pub fn number(
        what: impl Into<String>,
        name: &str,
        found: Result<f64, DemError>,
        allowed: RangeInclusive<f64>,
    ) -> Self {
        let (low, high) = (allowed.start(), allowed.end());
        let expected = match (low.is_finite(), high.is_finite()) {
            (true, true) => format!("{name} from {low:?} to {high:?}"),
            (true, false) => format!("{name} at least {low:?}"),
            _ => format!("{name} at most {high:?}"),
        };
        let holds = found.as_ref().is_ok_and(|value| allowed.contains(value));
        let found = found.map_or_else(|error| error.to_string(), |value| format!("{value:.4e}"));
        Self { what: what.into(), expected, found, holds }
    }

    /// What should be refused with a message that says why.
    pub fn refusal<T>(what: impl Into<String>, outcome: Result<T, DemError>, why: &str) -> Self {
        let expected = format!("refused: \"{why}\"");
        let message = outcome.err().map(|error| error.to_string());
        let holds = message.as_ref().is_some_and(|message| message.contains(why));
        Self { what: what.into(), expected, found: message.unwrap_or_else(|| "accepted".into()), holds }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn failed() -> DemError {
        DemError::BadWindow { window: 0.0, substeps: 0 }
    }

    #[test]
    fn a_number_holds_in_its_range_alone() {
        let holds = |found| Finding::number("", "", found, 1.0..=2.0).holds;
        assert!(holds(Ok(1.0)) && holds(Ok(2.0)));
        assert!(!holds(Ok(2.1)) && !holds(Ok(0.9)) && !holds(Ok(f64::NAN)) && !holds(Err(failed())));
    }

    #[test]
    fn a_refusal_holds_if_its_message_says_why() {
        assert!(Finding::refusal::<()>("", Err(failed()), "cannot be stepped through").holds);
        assert!(!Finding::refusal::<()>("", Err(failed()), "centres coincide").holds);
        assert!(!Finding::refusal("", Ok(()), "cannot be stepped through").holds);
    }
}
