//! `coupler resume DIR`: goes on from the last complete restart point, all participants or none.

use super::run::{Manner, run_all};
use crate::error::CouplerError;
use crate::run::{Origin, Request};
use case_io::checkpoint::latest;
use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;
use clap::Args;
use std::path::PathBuf;

/// Flags of `resume`.
#[derive(Args, Clone, Debug)]
pub(super) struct ResumeArguments {
    /// Output folder of the run to go on with.
    dir: PathBuf,
    #[command(flatten)]
    manner: Manner,
}

pub(super) fn resume(arguments: &ResumeArguments) -> Result<ExitCode, CouplerError> {
    let ResumeArguments { dir, manner } = arguments;
    let Origin { case, set, variant, run } = Origin::read(dir)?;
    let search = latest(&dir.join("restart"))?;
    let skipped: Vec<String> =
        search.skipped.iter().map(|found| format!("{}: {}", found.directory.display(), found.why)).collect();
    let Some(found) = search.found else {
        let skipped = if skipped.is_empty() { String::new() } else { format!(" ({})", skipped.join("; ")) };
        return Err(CouplerError::NoRestartPoint { path: dir.clone(), skipped });
    };
    let (written, own) = (&found.manifest.program_version, env!("CARGO_PKG_VERSION"));
    if written != own {
        let place = found.directory.display();
        return Err(CouplerError::CommandLine {
            message: format!(
                "{place}: written by version {written}, this program is version {own}; resume with version {written} or start again"
            ),
        });
    }
    let mut cases = Case::load(&case, &Overrides { set: set.clone(), variant: variant.clone() })?;
    cases.retain(|case| case.run == run);
    if let Some(case) = cases.first().filter(|case| case.hash != found.manifest.case_hash) {
        return Err(CouplerError::CommandLine {
            message: format!(
                "{}: the case {} has changed since the run (hash {} then, {} now); restore it or start again",
                dir.display(),
                case.name,
                found.manifest.case_hash,
                case.hash
            ),
        });
    }
    // The run's folder is the one given, whichever run of a sweep it was.
    for case in &mut cases {
        case.run = None;
    }
    let request = Request { case, set, variant, run, ..manner.request(dir) };
    run_all(&cases, &request, dir, Some(&found.directory), manner)
}
