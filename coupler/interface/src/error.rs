//! What can go wrong between the programs.

use crate::message::Failure;
use crate::run::Who;
use thiserror::Error;

/// An error of the wall between the programs: what is wrong, where, what to do.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InterfaceError {
    /// The transport could not be set up or used.
    #[error(
        "shared memory: {what} failed: {detail}; check that the folder {path} is writable and run `coupler clean`"
    )]
    Transport {
        /// The call.
        what: &'static str,
        /// Its own words.
        detail: String,
        /// The folder in question.
        path: String,
    },
    /// The folder of the runs cannot be used.
    #[error("{path}: {found}; allowed: a folder of user {user} alone; remove it")]
    RunsFolder {
        /// The folder.
        path: String,
        /// What is wrong with it.
        found: String,
        /// Whose runs they are.
        user: u32,
    },
    /// Too little shared memory.
    #[error(
        "shared memory: {needed} bytes are needed for the frames of {rows} grains, {free} are free in {path}; \
         free some, enlarge it (containers: --shm-size) or run `coupler clean`"
    )]
    NoSpace {
        /// Bytes needed.
        needed: u64,
        /// Bytes free.
        free: u64,
        /// Rows asked for.
        rows: u64,
        /// The file system.
        path: String,
    },
    /// A frame that does not belong here.
    #[error("frame {frame}: {field} is {found}, {expected} was expected; the two programs are out of step")]
    Frame {
        /// Which frame.
        frame: &'static str,
        /// Which field of the header.
        field: &'static str,
        /// Its value.
        found: u64,
        /// The value expected.
        expected: u64,
    },
    /// A frame that never came.
    #[error("frame {frame} of window {window} did not arrive before the message that announces it")]
    FrameMissing {
        /// Which frame.
        frame: &'static str,
        /// Window.
        window: u64,
    },
    /// A message that the state does not allow.
    #[error("{command} is not allowed when the participant is {state}; allowed: {allowed}")]
    IllegalMessage {
        /// State's name.
        state: &'static str,
        /// Command's name.
        command: &'static str,
        /// Commands allowed in that state.
        allowed: &'static str,
    },
    /// A report that does not answer the command.
    #[error("{who} answered {found} to {command}")]
    UnexpectedReport {
        /// The participant.
        who: Who,
        /// The command's name.
        command: &'static str,
        /// The report.
        found: String,
    },
    /// A message that cannot be read.
    #[error(
        "message cannot be encoded or decoded: {detail}; the programs are probably of different versions"
    )]
    Codec {
        /// The decoder's words.
        detail: String,
    },
    /// A peer is gone.
    #[error("{who} died{how}")]
    PeerDied {
        /// The peer.
        who: Who,
        /// How, if known: " (signal 9)".
        how: String,
    },
    /// A peer does not move.
    #[error("{who} is frozen: no heartbeat for {seconds:.1} s")]
    PeerFrozen {
        /// The peer.
        who: Who,
        /// Seconds of silence, counted by the watcher's own ticks.
        seconds: f64,
    },
    /// A peer lives but does not answer.
    #[error(
        "{who} has not answered {command} for {seconds:.0} s; raise coupling.answer-deadline if its work takes that long"
    )]
    AnswerOverdue {
        /// The peer.
        who: Who,
        /// Command's name.
        command: &'static str,
        /// Seconds waited.
        seconds: f64,
    },
    /// A participant refused the greeting.
    #[error(
        "{field} differs: this program has {own}, the coupler {theirs}; use programs and a case of one version"
    )]
    Difference {
        /// What differs.
        field: &'static str,
        /// Own value.
        own: String,
        /// The coupler's.
        theirs: String,
    },
    /// The participant itself failed.
    #[error("{message}")]
    Participant {
        /// Exit code.
        exit_code: i32,
        /// Its message.
        message: String,
    },
}

impl InterfaceError {
    /// The documented exit code of the program that meets this error.
    pub fn exit_code(&self) -> i32 {
        match self {
            InterfaceError::Transport { .. }
            | InterfaceError::RunsFolder { .. }
            | InterfaceError::NoSpace { .. }
            | InterfaceError::Difference { .. } => 5,
            InterfaceError::PeerDied { .. } => 9,
            InterfaceError::PeerFrozen { .. } | InterfaceError::AnswerOverdue { .. } => 10,
            InterfaceError::Participant { exit_code, .. } => *exit_code,
            _ => 1,
        }
    }
}

impl From<InterfaceError> for Failure {
    fn from(error: InterfaceError) -> Failure {
        Failure { exit_code: error.exit_code(), message: error.to_string() }
    }
}
