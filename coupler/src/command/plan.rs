//! `coupler plan CASE`: what is on, what is off, and why.

use super::{CaseArguments, say};
use crate::error::CouplerError;
use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;
use case_io::plan::Plan;

pub(super) fn plan(arguments: &CaseArguments) -> Result<ExitCode, CouplerError> {
    let overrides = Overrides { set: arguments.set.clone(), variant: arguments.variant.clone() };
    for case in Case::load(&arguments.case, &overrides)? {
        if let Some(run) = &case.run {
            say(&format!("run {run}"));
        }
        say(&Plan::of(&case.document).to_string());
    }
    Ok(ExitCode::Done)
}
