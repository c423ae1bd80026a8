//! The states of a participant and the messages that each allows.

use crate::error::InterfaceError;
use crate::message::{Command, Report};

/// Where a participant stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Started, not greeted.
    Launched,
    /// Between windows.
    Ready,
    /// Inside a window, before this iteration's work.
    Open,
    /// Inside a window, this iteration's work done.
    Solved,
    /// Told to stop.
    Ended,
}

impl State {
    /// The word for the state.
    pub fn name(self) -> &'static str {
        match self {
            State::Launched => "launched",
            State::Ready => "ready",
            State::Open => "open",
            State::Solved => "solved",
            State::Ended => "ended",
        }
    }

    fn allowed(self) -> &'static str {
        match self {
            State::Launched => "hello, stop",
            State::Ready => "open, stop",
            State::Open => "open, advance, restore, stop",
            State::Solved => "restore, commit, stop",
            State::Ended => "nothing",
        }
    }

    /// Refuses a command that this state does not allow.
    ///
    /// # Errors
    /// [`InterfaceError::IllegalMessage`].
    pub fn check(self, command: &Command) -> Result<(), InterfaceError> {
        let legal = match command {
            Command::Hello(_) => self == State::Launched,
            Command::Open(_) => matches!(self, State::Ready | State::Open),
            Command::Advance { .. } => self == State::Open,
            Command::Restore => matches!(self, State::Open | State::Solved),
            Command::Commit(_) => self == State::Solved,
            Command::Stop { .. } => self != State::Ended,
        };
        if legal {
            return Ok(());
        }
        Err(InterfaceError::IllegalMessage {
            state: self.name(),
            command: command.name(),
            allowed: self.allowed(),
        })
    }

    /// The state after a report.
    pub fn after(self, report: &Report) -> State {
        match report {
            Report::Ready(_) | Report::Committed(_) => State::Ready,
            Report::Opened(_) | Report::Restored => State::Open,
            Report::TooLarge(_) => self,
            Report::Solved(_) => State::Solved,
            Report::Ended(_) | Report::Failed(_) => State::Ended,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::{Commit, Hello, TooLarge, Window};

    fn commands() -> Vec<Command> {
        let hello = Hello {
            protocol: 1,
            version: String::new(),
            case_hash: String::new(),
            plan_hash: String::new(),
            surface: None,
        };
        vec![
            Command::Hello(hello),
            Command::Open(Window { number: 0, time: 0.0, step: 1.0, grains_changed: false }),
            Command::Advance { iteration: 1 },
            Command::Restore,
            Command::Commit(Commit::default()),
            Command::Stop { reason: String::new() },
        ]
    }

    #[test]
    fn every_pair_of_state_and_command_is_allowed_exactly_as_the_protocol_says() {
        // Columns: hello, open, advance, restore, commit, stop.
        let table = [
            (State::Launched, [true, false, false, false, false, true]),
            (State::Ready, [false, true, false, false, false, true]),
            (State::Open, [false, true, true, true, false, true]),
            (State::Solved, [false, false, false, true, true, true]),
            (State::Ended, [false, false, false, false, false, false]),
        ];
        for (state, row) in table {
            for (command, legal) in commands().iter().zip(row) {
                assert_eq!(state.check(command).is_ok(), legal, "{} {}", state.name(), command.name());
            }
        }
    }

    #[test]
    fn an_illegal_message_says_what_is_allowed() {
        let error = State::Ready.check(&Command::Restore).unwrap_err().to_string();
        assert_eq!(error, "restore is not allowed when the participant is ready; allowed: open, stop");
    }

    #[test]
    fn a_refused_window_is_neither_open_nor_solved() {
        let refusal = Report::TooLarge(TooLarge { bound: 1e-3, reason: String::new() });
        assert_eq!(State::Ready.after(&refusal), State::Ready);
        assert_eq!(State::Open.after(&refusal), State::Open);
    }
}
