//! `coupler check CASE`: keys, units, files, meshes, steps, sizes; nothing is run.

use super::{CaseArguments, say};
use crate::error::CouplerError;
use crate::run::{Request, survey};
use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;

pub(super) fn check(arguments: &CaseArguments) -> Result<ExitCode, CouplerError> {
    let overrides = Overrides { set: arguments.set.clone(), variant: arguments.variant.clone() };
    for case in Case::load(&arguments.case, &overrides)? {
        let CaseArguments { case: path, set, variant } = arguments.clone();
        let request = Request { case: path, set, variant, run: case.run.clone(), ..Request::default() };
        let notes = survey(&case, &request)?;
        let name = case.run.as_deref().unwrap_or(&case.name);
        say(&format!("{name}: can be run"));
        notes.iter().for_each(|note| say(&format!("  {note}")));
    }
    Ok(ExitCode::Done)
}
