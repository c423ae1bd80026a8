//! `coupler clean`: sweeps what this user's dead runs and checks left in shared memory and among temporary files.

use super::say;
use crate::error::CouplerError;
use case_io::exit_code::ExitCode;
use interface::run::sweep;

pub(super) fn clean() -> Result<ExitCode, CouplerError> {
    match sweep() {
        0 => say("nothing to sweep"),
        count => say(&format!("swept {count} dead runs")),
    }
    Ok(ExitCode::Done)
}
