//! What a solver implements, and the loop that serves the coupler.

use crate::error::InterfaceError;
use crate::frames::PROTOCOL;
use crate::message::{
    Command, Commit, Committed, Failure, Hello, Opened, Ready, Report, Solved, TooLarge, Usage, Window,
};
use crate::state::State;
use crate::transport::CommandReceiver;
use serde::{Deserialize, Serialize};

/// Answer to an open window.
pub enum Opening {
    /// The state is saved.
    Opened(Opened),
    /// The window is too long.
    TooLarge(TooLarge),
}

/// Answer to an iteration.
pub enum Advance {
    /// This side's part is done.
    Solved(Box<Solved>),
    /// The window is too long for it, and is given up.
    TooLarge(TooLarge),
}

/// One side of the coupling. Errors end the run; they carry their exit code.
pub trait Participant {
    /// Hashes of the case and the plan this side has loaded.
    fn identity(&self) -> (String, String);
    /// Counts and the largest Δt.
    fn ready(&mut self) -> Result<Ready, Failure>;
    /// Saves the state and prepares the window. A window that is open already is offered anew, shorter, after `restore`: the
    /// grains publish their frame again, since the newest belongs to the attempt that was given up.
    fn open(&mut self, window: Window) -> Result<Opening, Failure>;
    /// Does this side's part of the iteration.
    fn advance(&mut self, iteration: u32) -> Result<Advance, Failure>;
    /// Goes back to the state saved at `open`, from wherever the window has come to.
    fn restore(&mut self) -> Result<(), Failure>;
    /// Makes the window history.
    fn commit(&mut self, commit: &Commit) -> Result<Committed, Failure>;
    /// Flushes what is committed.
    fn stop(&mut self, reason: &str) -> Usage;
}

/// A place in the run where a participant stays until it is killed, so that tests strike at a known moment.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Hold {
    /// Window number.
    pub window: u64,
    /// Command that it receives and does not answer.
    pub command: String,
    /// File made when the place is reached.
    pub marker: std::path::PathBuf,
}

/// Serves commands until `stop`, a failure or the loss of the coupler. The participant is set up when it is greeted.
///
/// # Errors
/// The participant's own failure as [`InterfaceError::Participant`] after it was reported; a dead or frozen
/// coupler; an illegal message.
pub fn serve<P: Participant>(
    control: &mut CommandReceiver,
    hold: Option<&Hold>,
    set_up: impl FnOnce(&Hello) -> Result<P, Failure>,
) -> Result<(), InterfaceError> {
    let mut state = State::Launched;
    let mut set_up = Some(set_up);
    let mut participant = None;
    let mut window = 0;
    while state != State::Ended {
        let command = control.wait()?;
        if let Command::Open(opened) = &command {
            window = opened.number;
        }
        if let Some(hold) = hold.filter(|hold| hold.window == window && hold.command == command.name()) {
            control.hold(hold)?;
        }
        let mut respond = || {
            state.check(&command)?;
            if let (Command::Hello(hello), Some(set_up)) = (&command, set_up.take()) {
                participant = Some(set_up(hello)?);
            }
            match &mut participant {
                Some(participant) => answer(participant, &command),
                // Stopped before it was greeted.
                None => Ok(Report::Ended(Usage::default())),
            }
        };
        let report = respond().unwrap_or_else(Report::Failed);
        control.answer(&report)?;
        state = state.after(&report);
        if let Report::Failed(Failure { exit_code, message }) = report {
            control.linger();
            return Err(InterfaceError::Participant { exit_code, message });
        }
    }
    control.linger();
    Ok(())
}

fn greet<P: Participant>(participant: &mut P, hello: &Hello) -> Result<Report, Failure> {
    refuse_difference(hello, participant.identity())?;
    Ok(Report::Ready(participant.ready()?))
}

fn answer<P: Participant>(participant: &mut P, command: &Command) -> Result<Report, Failure> {
    Ok(match command {
        Command::Hello(hello) => greet(participant, hello)?,
        Command::Open(window) => match participant.open(*window)? {
            Opening::Opened(opened) => Report::Opened(opened),
            Opening::TooLarge(refusal) => Report::TooLarge(refusal),
        },
        Command::Advance { iteration } => match participant.advance(*iteration)? {
            Advance::Solved(solved) => Report::Solved(solved),
            Advance::TooLarge(refusal) => Report::TooLarge(refusal),
        },
        Command::Restore => {
            participant.restore()?;
            Report::Restored
        }
        Command::Commit(commit) => Report::Committed(participant.commit(commit)?),
        Command::Stop { reason } => Report::Ended(participant.stop(reason)),
    })
}

fn refuse_difference(hello: &Hello, (case_hash, plan_hash): (String, String)) -> Result<(), Failure> {
    let pairs = [
        ("protocol", PROTOCOL.to_string(), hello.protocol.to_string()),
        ("version", env!("CARGO_PKG_VERSION").to_string(), hello.version.clone()),
        ("case", case_hash, hello.case_hash.clone()),
        ("plan", plan_hash, hello.plan_hash.clone()),
    ];
    for (field, own, theirs) in pairs {
        if own != theirs {
            return Err(InterfaceError::Difference { field, own, theirs }.into());
        }
    }
    Ok(())
}
