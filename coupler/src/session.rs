//! The conversation with the participants: who is there, what each answers.

use crate::error::CouplerError;
use interface::frames::{GrainRow, HydroRow, PROTOCOL, ReactionRow};
use interface::ledger::{FluidLedger, GrainLedger};
use interface::message::{
    Books, Command, Commit, Committed, Hello, Norms, Opened, Ready, Report, Solved, Surface, TooLarge, Usage,
    Window,
};
use interface::run::Who;
use interface::transport::{CommandSender, CouplerEnds, FrameView, Stamp};
use interface::usage::Stopwatch;
use std::time::Duration;

/// The participants of a run.
pub struct Session {
    /// The wires.
    pub ends: CouplerEnds,
    /// Grains take part.
    pub dem: bool,
    /// A fluid takes part.
    pub fluid: bool,
    /// Seconds spent waiting for answers so far.
    pub waited: f64,
}

/// What came of asking for a part of a window.
pub enum Answer<T> {
    /// It is done.
    Done(T),
    /// A participant wants a shorter window.
    TooLarge(Refusal),
}

/// Who wants a shorter window, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Which program.
    pub who: Who,
    /// What it wants.
    pub wanted: TooLarge,
}

impl Session {
    /// Both sides take part: there is something to exchange.
    pub fn is_coupled(&self) -> bool {
        self.dem && self.fluid
    }

    /// The participants of this run.
    pub fn members(&self) -> Vec<Who> {
        let all = [(Who::Dem, self.dem), (Who::Fluid, self.fluid)];
        all.into_iter().filter(|(_, takes_part)| *takes_part).map(|(who, _)| who).collect()
    }

    /// Greets all participants: the fluid first, whose surface the grains may have for walls.
    ///
    /// # Errors
    /// As [`Session::hello`].
    pub fn greet(&mut self, case_hash: &str, plan_hash: &str) -> Result<Vec<(Who, Ready)>, CouplerError> {
        let mut surface = None;
        let mut answers = Vec::new();
        for who in self.members().into_iter().rev() {
            let mut ready = self.hello(who, (case_hash, plan_hash), surface.take())?;
            surface = ready.surface.take();
            answers.push((who, ready));
        }
        Ok(answers)
    }

    fn wire(&mut self, who: Who) -> &mut CommandSender {
        match who {
            Who::Dem => &mut self.ends.dem,
            _ => &mut self.ends.fluid,
        }
    }

    fn ask(&mut self, who: Who, command: &Command) -> Result<Report, CouplerError> {
        use interface::InterfaceError::Participant;
        let mut clock = Stopwatch::start();
        let report = self.wire(who).ask(command);
        self.waited += clock.lap();
        report.map_err(|error| match error {
            Participant { exit_code, message } => {
                CouplerError::Participant { who: who.name(), exit_code, message }
            }
            other => other.into(),
        })
    }

    /// Greets a participant.
    ///
    /// # Errors
    /// A difference of versions, cases or plans; the participant's own trouble with the case.
    fn hello(
        &mut self,
        who: Who,
        (case_hash, plan_hash): (&str, &str),
        surface: Option<Surface>,
    ) -> Result<Ready, CouplerError> {
        let version = env!("CARGO_PKG_VERSION").to_string();
        let command = Command::Hello(Hello {
            protocol: PROTOCOL,
            version,
            case_hash: case_hash.into(),
            plan_hash: plan_hash.into(),
            surface,
        });
        match self.ask(who, &command)? {
            Report::Ready(ready) => Ok(ready),
            other => Err(self.wire(who).unexpected("hello", &other).into()),
        }
    }

    /// Opens a window on all sides, the grains first: the fluid needs to know whether they changed. The rows of the grains
    /// frame, and whether it is new.
    ///
    /// # Errors
    /// A participant's failure or silence.
    pub fn open(&mut self, window: Window) -> Result<Answer<Opened>, CouplerError> {
        let mut opened = Opened { rows: 0, grains_changed: false };
        for who in self.members() {
            let grains_changed = who == Who::Fluid && self.dem && opened.grains_changed;
            match self.ask(who, &Command::Open(Window { grains_changed, ..window }))? {
                Report::Opened(answer) if who == Who::Dem => opened = answer,
                Report::Opened(_) => {}
                Report::TooLarge(wanted) => return Ok(Answer::TooLarge(Refusal { who, wanted })),
                other => return Err(self.wire(who).unexpected("open", &other).into()),
            }
        }
        Ok(Answer::Done(opened))
    }

    /// Lets the grains move through the window; without a fluid nothing acts on them. Their books, and the substeps done.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn advance_dem(
        &mut self,
        window: Window,
        iteration: u32,
        hydro: &[HydroRow],
    ) -> Result<Answer<(GrainLedger, u64)>, CouplerError> {
        if self.fluid {
            self.ends.hydro.write(stamp(window, iteration), hydro.len(), |row| hydro[row])?;
        }
        match self.ask(Who::Dem, &Command::Advance { iteration })? {
            Report::Solved(solved) => match *solved {
                Solved { books: Books::Grains(ledger), work, .. } => Ok(Answer::Done((ledger, work))),
                other => Err(self.ends.dem.unexpected("advance", &Report::Solved(Box::new(other))).into()),
            },
            Report::TooLarge(wanted) => Ok(Answer::TooLarge(Refusal { who: Who::Dem, wanted })),
            other => Err(self.ends.dem.unexpected("advance", &other).into()),
        }
    }

    /// Solves the fluid with the grains' new places. Its books and norms, and the linear iterations done.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn advance_fluid(
        &mut self,
        window: Window,
        iteration: u32,
        reactions: &[ReactionRow],
    ) -> Result<Answer<(FluidLedger, Norms, u64)>, CouplerError> {
        if self.dem {
            self.ends.reaction.write(stamp(window, iteration), reactions.len(), |row| reactions[row])?;
        }
        match self.ask(Who::Fluid, &Command::Advance { iteration })? {
            Report::Solved(solved) => match *solved {
                Solved { books: Books::Fluid { ledger, norms }, work, .. } => {
                    Ok(Answer::Done((ledger, norms, work)))
                }
                other => Err(self.ends.fluid.unexpected("advance", &Report::Solved(Box::new(other))).into()),
            },
            Report::TooLarge(wanted) => Ok(Answer::TooLarge(Refusal { who: Who::Fluid, wanted })),
            other => Err(self.ends.fluid.unexpected("advance", &other).into()),
        }
    }

    /// Brings all sides back to the opening of the window.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn restore(&mut self) -> Result<(), CouplerError> {
        for who in self.members() {
            match self.ask(who, &Command::Restore)? {
                Report::Restored => {}
                other => return Err(self.wire(who).unexpected("restore", &other).into()),
            }
        }
        Ok(())
    }

    /// Makes the window history on all sides.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn commit(&mut self, commit: &Commit) -> Result<Vec<(Who, Committed)>, CouplerError> {
        let mut answers = Vec::new();
        for who in self.members() {
            match self.ask(who, &Command::Commit(commit.clone()))? {
                Report::Committed(committed) => answers.push((who, committed)),
                other => return Err(self.wire(who).unexpected("commit", &other).into()),
            }
        }
        Ok(answers)
    }

    /// Ends a participant, which has little to do for it.
    ///
    /// # Errors
    /// It is gone, or busy with something longer.
    pub fn stop(&mut self, who: Who, reason: &str) -> Result<Usage, CouplerError> {
        const PATIENCE: Duration = Duration::from_secs(2);
        // Only the one that is asked counts: the other may be dead already.
        self.wire(who).watch_peers(&[who]);
        match self.wire(who).ask_within(&Command::Stop { reason: reason.to_string() }, PATIENCE)? {
            Report::Ended(usage) => Ok(usage),
            other => Err(self.wire(who).unexpected("stop", &other).into()),
        }
    }

    /// The newest grains.
    ///
    /// # Errors
    /// None has come.
    pub fn grains(&mut self) -> Result<FrameView<'_, GrainRow>, CouplerError> {
        Ok(self.ends.grains.newest()?)
    }
}

fn stamp(window: Window, iteration: u32) -> Stamp {
    let Window { number, time, step, grains_changed } = window;
    Stamp { window: number, iteration, time, step, order_changed: grains_changed }
}
