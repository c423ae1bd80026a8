//! `dem-solver export CASE --to PEER`: the deck alone.

use case_io::exit_code::ExitCode;
use clap::Args;

use super::{CaseArguments, folder, say};
use crate::peer::Program;
use crate::peer::error::PeerError;
use crate::peer::launch::write_deck;
use crate::peer::task::Task;

/// Flags of `export`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// The program whose input is written.
    #[arg(long, value_name = "PEER")]
    to: Program,
}

pub(super) fn export(arguments: &Arguments) -> Result<ExitCode, PeerError> {
    let peer = arguments.to.peer();
    let (cases, out) = arguments.case.open(arguments.to)?;
    for case in &cases {
        let task = Task::new(case, |law| peer.computes_alike(law))?;
        let folder = folder(case, &out);
        write_deck(&folder, &peer.deck(case, &task, Some(task.recording))?)?;
        let call = [&[peer.executable()], peer.arguments()].concat().join(" ");
        say(&format!(
            "{}: {} grains, {} steps of {:.4e} s for {} {}; run `{call}` in {}",
            case.run.as_ref().unwrap_or(&case.name),
            task.grains.len(),
            task.steps(),
            task.step,
            peer.name(),
            peer.version(),
            folder.display()
        ));
    }
    Ok(ExitCode::Done)
}
