//! The case's checks, evaluated on what the run left.

use crate::error::CouplerError;
use case_io::check::Checks;
use case_io::document::Case;
use case_io::exit_code::ExitCode;
use case_io::summary::{Exit, Summary};
use std::path::Path;

/// Evaluates `check.toml` of the case folder, if there is one, and enters the verdict.
///
/// # Errors
/// A check that cannot be understood.
pub fn judge(case: &Case, out: &Path, summary: &mut Summary) -> Result<(), CouplerError> {
    let Some(checks) = Checks::load(&case.folder)? else { return Ok(()) };
    summary.checks = checks.of(case)?.evaluate_run(out);
    let failed: Vec<&str> =
        summary.checks.iter().filter(|check| !check.pass).map(|check| check.name.as_str()).collect();
    if !failed.is_empty() {
        let reason = format!("checks failed: {}", failed.join(", "));
        summary.exit = Exit { code: ExitCode::CheckFailed, reason };
    }
    Ok(())
}
