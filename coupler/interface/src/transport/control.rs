//! Commands one way, reports the other, with deadlines on every wait.

use super::{in_process, shared_memory};
use crate::error::InterfaceError;
use crate::message::{Command, Report};
use crate::participant::Hold;
use crate::pulse::Pulse;
use crate::run::Who;
use std::sync::Arc;
use std::time::Duration;

/// How long a wait sleeps before it looks at the peers again.
const SLICE: Duration = Duration::from_millis(20);

/// How long the coupler may take to read a last answer.
const GRACE: Duration = Duration::from_secs(2);

/// How long peers may be silent.
#[derive(Clone, Copy, Debug)]
pub struct Deadlines {
    /// Without a heartbeat.
    pub peer: Duration,
    /// Without an answer, the heart beating.
    pub answer: Duration,
}

impl Default for Deadlines {
    fn default() -> Self {
        Deadlines { peer: Duration::from_secs(10), answer: Duration::from_secs(600) }
    }
}

/// The ear for the peers' hearts; threads of one process have none: a closed channel tells as much.
#[derive(Clone)]
pub(super) struct Watch {
    pub pulse: Option<Arc<Pulse>>,
    pub peers: Vec<Who>,
    pub deadlines: Deadlines,
}

impl Watch {
    fn check(&self) -> Result<(), InterfaceError> {
        let Some(pulse) = &self.pulse else { return Ok(()) };
        self.peers.iter().try_for_each(|peer| pulse.check(*peer, self.deadlines.peer))
    }

    fn now(&self) -> Duration {
        self.pulse.as_ref().map_or(Duration::ZERO, |pulse| pulse.now())
    }
}

pub(super) enum Sender {
    SharedMemory(Box<shared_memory::Client>),
    InProcess(in_process::Client),
}

/// The coupler's end of the control wire to one participant.
pub struct CommandSender {
    pub(super) who: Who,
    pub(super) sender: Sender,
    pub(super) watch: Watch,
}

impl CommandSender {
    /// Watches these peers' hearts during every wait.
    pub fn watch_peers(&mut self, peers: &[Who]) {
        self.watch.peers = peers.to_vec();
    }

    /// Whether the participant has come.
    pub fn has_joined(&self) -> bool {
        self.watch.pulse.as_ref().is_none_or(|pulse| pulse.has_joined(self.who))
    }

    /// Sends a command and waits for the report.
    ///
    /// # Errors
    /// A dead or frozen peer, an overdue answer; a participant's failure as [`InterfaceError::Participant`].
    pub fn ask(&mut self, command: &Command) -> Result<Report, InterfaceError> {
        self.ask_within(command, self.watch.deadlines.answer)
    }

    /// As [`CommandSender::ask`], with a deadline for the answer of its own.
    ///
    /// # Errors
    /// As [`CommandSender::ask`].
    pub fn ask_within(&mut self, command: &Command, deadline: Duration) -> Result<Report, InterfaceError> {
        match &mut self.sender {
            Sender::SharedMemory(client) => client.send(command)?,
            Sender::InProcess(client) => client.send(command)?,
        }
        let start = self.watch.now();
        loop {
            let report = match &mut self.sender {
                Sender::SharedMemory(client) => client.poll(SLICE)?,
                Sender::InProcess(client) => client.poll(SLICE)?,
            };
            match report {
                Some(Report::Failed(failure)) => {
                    return Err(InterfaceError::Participant {
                        exit_code: failure.exit_code,
                        message: failure.message,
                    });
                }
                Some(report) => return Ok(report),
                None => self.watch.check()?,
            }
            let waited = self.watch.now().saturating_sub(start);
            if waited > deadline {
                let seconds = waited.as_secs_f64();
                return Err(InterfaceError::AnswerOverdue {
                    who: self.who,
                    command: command.name(),
                    seconds,
                });
            }
        }
    }

    /// The error for a report that does not answer the command.
    pub fn unexpected(&self, command: &'static str, report: &Report) -> InterfaceError {
        InterfaceError::UnexpectedReport { who: self.who, command, found: format!("{report:?}") }
    }
}

pub(super) enum Receiver {
    SharedMemory(Box<shared_memory::Server>),
    InProcess(in_process::Server),
}

/// A participant's end of the control wire.
pub struct CommandReceiver {
    pub(super) receiver: Receiver,
    pub(super) watch: Watch,
}

impl CommandReceiver {
    /// Waits for the next command.
    ///
    /// # Errors
    /// A dead or frozen coupler.
    pub fn wait(&mut self) -> Result<Command, InterfaceError> {
        loop {
            let command = match &mut self.receiver {
                Receiver::SharedMemory(server) => server.poll(SLICE)?,
                Receiver::InProcess(server) => server.poll(SLICE)?,
            };
            match command {
                Some(command) => return Ok(command),
                None => self.watch.check()?,
            }
        }
    }

    /// Answers the command received last.
    ///
    /// # Errors
    /// [`InterfaceError::Transport`].
    pub fn answer(&mut self, report: &Report) -> Result<(), InterfaceError> {
        match &mut self.receiver {
            Receiver::SharedMemory(server) => server.answer(report),
            Receiver::InProcess(server) => server.answer(report),
        }
    }

    /// Stays until the coupler has read the last answer, which goes when this program goes.
    pub(crate) fn linger(&self) {
        let start = self.watch.now();
        let is_awaited = || match &self.receiver {
            Receiver::SharedMemory(server) => server.is_awaited(),
            Receiver::InProcess(_) => false,
        };
        while is_awaited() && self.watch.check().is_ok() && self.watch.now().saturating_sub(start) < GRACE {
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Marks the place and stays there for as long as the coupler lives.
    pub(crate) fn hold(&mut self, hold: &Hold) -> Result<(), InterfaceError> {
        // A marker that cannot be written shows in the test that waits for it.
        let _ = std::fs::write(&hold.marker, "held\n");
        loop {
            self.watch.check()?;
            std::thread::sleep(SLICE);
        }
    }
}
