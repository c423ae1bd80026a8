//! A run from its first window to its last: the clock, commits, restart points, the books.

use crate::acceleration::{Acceleration, Aitken, Constant, None as Unrelaxed};
use crate::clock::{Clock, Intervals, Outputs};
use crate::convergence::{ForceResidual, Judge, RelativeNorm};
use crate::error::CouplerError;
use crate::exchange::Exchange;
use crate::interaction::drag::Drag;
use crate::interaction::{Interaction, Laws, Shape};
use crate::ledger::Ledger;
use crate::owed::Owed;
use crate::record::{self, Memory, Record};
use crate::session::{Answer, Refusal, Session};
use crate::window::{Coupling, Outcome, coupled_window, single_window};
use case_io::checkpoint::RestartPoint;
use case_io::document::{self, Backend, Case, Dimension, Scheme};
use case_io::plan::Plan;
use case_io::summary::Counts;
use interface::message::{Commit, Opened, TooLarge, Window};
use interface::run::Who;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// What the simulation tells whoever watches it.
pub trait Watcher {
    /// A window is history.
    fn window(&mut self, clock: &Clock, counts: &Counts);
}

/// A coupled run.
pub struct Simulation {
    session: Session,
    coupling: Option<Coupling>,
    clock: Clock,
    exchange: Exchange,
    owed: Owed,
    /// The books, with the largest residuals so far.
    pub ledger: Ledger,
    /// Open series; none until a resumed run knows its time.
    record: Option<Record>,
    /// How much work it was so far.
    pub counts: Counts,
    largest_step: (f64, f64),
    smallest: f64,
    out: PathBuf,
    case_hash: String,
}

impl Simulation {
    /// Greets the participants and prepares the run.
    ///
    /// # Errors
    /// A participant that refuses; a law that does not fit the scene; the disk's.
    pub fn start(
        case: &Case,
        session: Session,
        out: &Path,
        resume: Option<&Path>,
    ) -> Result<Simulation, CouplerError> {
        let document = &case.document;
        let coupling = match &document.coupling {
            Some(coupling) if session.is_coupled() => Some(coupling_of(document, coupling)?),
            _ => None,
        };
        let end = document.time.end;
        let intervals = Intervals {
            series: document.output.series(end),
            frames: document.output.frames(end),
            restart: document.output.restart(end),
        };
        let clock = Clock::new(end.si(), document.window(), document.smallest_window(), intervals);
        let tolerance =
            document.coupling.as_ref().map_or(LEDGER_TOLERANCE, |coupling| coupling.ledger_tolerance);
        let mut simulation = Simulation {
            session,
            coupling,
            clock,
            exchange: Exchange::default(),
            owed: Owed::default(),
            ledger: Ledger::new(tolerance),
            record: match resume {
                Some(_) => None,
                None => Some(Record::create(out)?),
            },
            counts: Counts::default(),
            largest_step: (f64::INFINITY, f64::INFINITY),
            smallest: document.smallest_window(),
            out: out.to_path_buf(),
            case_hash: case.hash.clone(),
        };
        simulation.greet(&case.hash, &Plan::of(document).hash())?;
        if let Some(folder) = resume {
            simulation.resume(folder)?;
        }
        Ok(simulation)
    }

    fn greet(&mut self, case_hash: &str, plan_hash: &str) -> Result<(), CouplerError> {
        for (who, ready) in self.session.greet(case_hash, plan_hash)? {
            self.note_size(who, ready.size, ready.largest_step);
        }
        Ok(())
    }

    fn note_size(&mut self, who: Who, size: u64, largest_step: f64) {
        match who {
            Who::Dem => (self.counts.grains, self.largest_step.0) = (size, largest_step),
            _ => (self.counts.nodes, self.largest_step.1) = (size, largest_step),
        }
    }

    fn resume(&mut self, folder: &Path) -> Result<(), CouplerError> {
        let (memory, owed) = record::load(&folder.join(record::PART))?;
        self.clock.resume(memory.time, memory.window);
        self.owed = owed;
        self.counts = memory.counts;
        self.ledger.resume(memory.maxima);
        self.largest_step = memory.largest_step;
        if let Some(coupling) = &mut self.coupling {
            coupling.relaxation = memory.relaxation;
        }
        self.record = Some(Record::resume(&self.out, memory.time)?);
        Ok(())
    }

    /// Runs to the end, or to the next commit after an interrupt.
    ///
    /// # Errors
    /// Whatever stops the run; all that was committed stays.
    pub fn run(&mut self, interrupted: &AtomicBool, watcher: &mut dyn Watcher) -> Result<(), CouplerError> {
        while !self.clock.is_over() {
            self.window()?;
            watcher.window(&self.clock, &self.counts);
            if interrupted.load(Ordering::Relaxed) {
                return Err(CouplerError::Interrupted { time: self.clock.time });
            }
        }
        Ok(())
    }

    /// One window: open, advance, book, commit.
    fn window(&mut self) -> Result<(), CouplerError> {
        let (window, outcome) = self.advance()?;
        let residuals = self.ledger.book(&outcome, self.owed.sum(), window)?;
        let end = self.clock.after(window.step);
        let outputs = self.clock.due_at(end);
        self.commit(window, end, outputs, &outcome)?;
        match &mut self.record {
            Some(record) => record.row(end, window.step, &outcome, &residuals),
            None => Ok(()),
        }
    }

    /// Offers windows, each at most half of the one before, until all sides have come through one; between offers all go
    /// back to its start.
    fn advance(&mut self) -> Result<(Window, Outcome), CouplerError> {
        let (dem, fluid) = self.largest_step;
        let bound = |who, bound| Refusal { who, wanted: TooLarge { bound, reason: String::new() } };
        let mut limit = if dem <= fluid { bound(Who::Dem, dem) } else { bound(Who::Fluid, fluid) };
        loop {
            let step =
                self.clock.offer(limit.wanted.bound).map_err(|wanted| self.too_small(wanted, &limit))?;
            let window =
                Window { number: self.clock.window, time: self.clock.time, step, grains_changed: false };
            let refusal = match self.session.open(window)? {
                Answer::TooLarge(refusal) => refusal,
                Answer::Done(opened) => match self.pass(window, opened)? {
                    Answer::Done(outcome) => return Ok((window, outcome)),
                    Answer::TooLarge(refusal) => {
                        self.session.restore()?;
                        refusal
                    }
                },
            };
            self.counts.refused += 1;
            let wanted = TooLarge { bound: refusal.wanted.bound.min(0.5 * step), ..refusal.wanted };
            limit = Refusal { wanted, ..refusal };
        }
    }

    /// Takes all sides through an open window.
    fn pass(&mut self, window: Window, opened: Opened) -> Result<Answer<Outcome>, CouplerError> {
        let Some(coupling) = &mut self.coupling else { return single_window(&mut self.session, window) };
        if opened.grains_changed {
            self.owed.follow(&self.session.grains()?);
        }
        coupled_window(&mut self.session, coupling, &mut self.exchange, &mut self.owed, window)
    }

    fn too_small(&self, bound: f64, limit: &Refusal) -> CouplerError {
        CouplerError::StepTooSmall {
            who: limit.who.name(),
            reason: limit.wanted.reason.clone(),
            bound,
            time: self.clock.time,
            smallest: self.smallest,
            advice: match limit.who {
                Who::Dem => "soften the materials or lower time.smallest-window",
                Who::Fluid if self.coupling.is_none() => "coarsen the mesh or lower time.smallest-window",
                _ => {
                    "coarsen the mesh or lower time.smallest-window; if speeds grow without a cause, set \
                     coupling.scheme = \"serial-implicit\""
                }
            },
        }
    }

    /// Makes the window history; a restart point is complete or not there.
    fn commit(
        &mut self,
        window: Window,
        end: f64,
        outputs: Outputs,
        outcome: &Outcome,
    ) -> Result<(), CouplerError> {
        let restart = self.out.join("restart");
        let point = outputs.restart.then(|| RestartPoint::begin(&restart, window.number)).transpose()?;
        let commit = Commit {
            series: outputs.series,
            frame: outputs.frame,
            restart: point.as_ref().map(|point| point.part("")),
        };
        for (who, committed) in self.session.commit(&commit)? {
            self.note_size(who, committed.size, committed.largest_step);
        }
        self.clock.close(end);
        self.counts.windows += 1;
        self.counts.iterations += u64::from(outcome.iterations);
        self.counts.substeps += outcome.substeps;
        if let Some(point) = point {
            let relaxation =
                self.coupling.as_ref().map_or(Acceleration::None(Unrelaxed), |c| c.relaxation.clone());
            let largest_step = self.largest_step;
            let (counts, maxima) = (self.counts, self.ledger.largest());
            let memory =
                Memory { time: end, window: window.number, counts, maxima, largest_step, relaxation };
            record::save(&point.part(record::PART), &memory, &self.owed)?;
            let members = self.session.members();
            let parts: Vec<&str> = members.iter().map(|who| who.name()).chain([record::PART]).collect();
            point.commit(end, window.step, &self.case_hash, env!("CARGO_PKG_VERSION"), &parts)?;
        }
        Ok(())
    }

    /// Time reached \[s\].
    pub fn time(&self) -> f64 {
        self.clock.time
    }

    /// Seconds spent waiting for the participants so far.
    pub fn waited(&self) -> f64 {
        self.session.waited
    }

    /// Back to the conversation, to end it.
    pub fn into_session(self) -> Session {
        self.session
    }
}

/// Where the case has no coupling table.
const LEDGER_TOLERANCE: f64 = 1e-12;

fn coupling_of(
    document: &document::Document,
    coupling: &document::Coupling,
) -> Result<Coupling, CouplerError> {
    let imposed = document.fluid.as_ref().is_some_and(|fluid| fluid.backend == Backend::Imposed);
    let two_way = coupling.scheme != Scheme::OneWay;
    let shape = match document.case.dimension {
        Dimension::Two => Shape::Disc { depth: document.case.depth() },
        Dimension::Three => Shape::Sphere,
    };
    let laws = Laws {
        drag: drag_of(coupling.drag),
        added_mass: coupling.added_mass,
        // A field that does not feel the grains is not disturbed by them.
        self_disturbance: coupling.self_disturbance && two_way && !imposed,
    };
    let tolerance = &coupling.tolerance;
    let judge = Judge::new(
        RelativeNorm { tolerance: tolerance.velocity, floor: tolerance.velocity_floor.si() },
        RelativeNorm { tolerance: tolerance.pressure, floor: tolerance.pressure_floor.si() },
        ForceResidual { tolerance: tolerance.force, floor: tolerance.force_floor.si() },
    );
    let relaxation = match coupling.acceleration {
        document::Acceleration::None => Some(Acceleration::None(Unrelaxed)),
        document::Acceleration::Constant => Constant::new(coupling.relaxation).map(Acceleration::Constant),
        document::Acceleration::Aitken => Aitken::new(coupling.relaxation).map(Acceleration::Aitken),
    };
    Ok(Coupling {
        interaction: Interaction::new(laws, shape)?,
        shape,
        two_way,
        max_iterations: coupling.max_iterations,
        implicit: coupling.scheme == Scheme::SerialImplicit,
        judge,
        relaxation: relaxation.unwrap_or(Acceleration::None(Unrelaxed)),
    })
}

fn drag_of(drag: document::Drag) -> Drag {
    match drag {
        document::Drag::None => Drag::None,
        document::Drag::Stokes => Drag::Stokes,
        document::Drag::SchillerNaumann => Drag::SchillerNaumann,
        document::Drag::HaiderLevenspiel => Drag::HaiderLevenspiel,
        document::Drag::WenYu => Drag::WenYu,
        document::Drag::Ergun => Drag::Ergun,
        document::Drag::Gidaspow => Drag::Gidaspow,
        document::Drag::DiFelice => Drag::DiFelice,
        document::Drag::DiFeliceCylinder => Drag::DiFeliceCylinder,
    }
}
