//! The fluid as a participant: what it does on each command of the coupler.

use crate::backend::{Attempt, FluidBackend, Step};
use crate::error::FluidError;
use crate::record::Record;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::message::{Books, Commit, Committed, Failure, Opened, Ready, Solved, TooLarge, Usage, Window};
use interface::participant::{Advance, Opening, Participant};
use interface::transport::{FrameReader, FrameWriter, Stamp};
use interface::usage::{Stopwatch, own_usage};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The name of the fluid's part of a restart point.
pub const PART: &str = "fluid-solver";

/// When a checkpoint was taken.
#[derive(Serialize, Deserialize)]
struct Moment {
    time: f64,
    window: u64,
}

/// A backend and its wires.
pub struct FluidParticipant {
    backend: Box<dyn FluidBackend>,
    grains: FrameReader<GrainRow>,
    samples: FrameWriter<SampleRow>,
    reaction: FrameReader<ReactionRow>,
    record: Record,
    identity: (String, String),
    /// The scene has grains to exchange with.
    coupled: bool,
    window: Window,
    time: f64,
    seconds: [f64; PARTS.len()],
}

const PARTS: [&str; 4] = ["project", "solve", "sample", "commit"];

impl FluidParticipant {
    /// A fluid at time 0; `coupled` if there are grains on the other side.
    pub fn new(
        backend: Box<dyn FluidBackend>,
        (grains, samples, reaction): (
            FrameReader<GrainRow>,
            FrameWriter<SampleRow>,
            FrameReader<ReactionRow>,
        ),
        record: Record,
        identity: (String, String),
        coupled: bool,
    ) -> FluidParticipant {
        let window = Window { number: 0, time: 0.0, step: 0.0, grains_changed: false };
        let seconds = [0.0; PARTS.len()];
        FluidParticipant {
            backend,
            grains,
            samples,
            reaction,
            record,
            identity,
            coupled,
            window,
            time: 0.0,
            seconds,
        }
    }

    /// Goes on from a restart point.
    ///
    /// # Errors
    /// A damaged or foreign checkpoint.
    pub fn resume(&mut self, folder: &Path) -> Result<(), FluidError> {
        let checkpoint = Checkpoint::read(&folder.join(PART), PART)?;
        let moment: Moment = checkpoint.metadata()?;
        self.backend.load_checkpoint(&checkpoint)?;
        self.time = moment.time;
        self.record.resume(moment.time)?;
        Ok(())
    }

    fn step(&self) -> Step {
        Step { time: self.window.time, length: self.window.step }
    }

    /// Publishes the fluid at the grains placed last.
    fn publish_samples(&mut self, iteration: u32, time: f64, rows: usize) -> Result<(), FluidError> {
        self.backend.prepare_samples();
        let stamp = Stamp {
            window: self.window.number,
            iteration,
            time,
            step: self.window.step,
            order_changed: false,
        };
        let backend = &self.backend;
        self.samples.write(stamp, rows, |row| backend.sample(row))?;
        Ok(())
    }

    fn open_window(&mut self, window: Window) -> Result<Opening, FluidError> {
        let bound = self.backend.largest_step();
        // A relative margin: the coupler divides the time that is left into equal windows.
        if window.step > bound * (1.0 + 1e-9) {
            return Ok(Opening::TooLarge(TooLarge { bound, reason: String::new() }));
        }
        self.window = window;
        if window.grains_changed {
            let grains = self.grains.of(window.number, 0)?;
            let rows = grains.len();
            self.backend.populate(window.time, &grains)?;
            self.publish_samples(0, window.time, rows)?;
        }
        self.backend.save();
        Ok(Opening::Opened(Opened { rows: 0, grains_changed: false }))
    }

    fn advance_iteration(&mut self, iteration: u32) -> Result<Advance, FluidError> {
        let step = self.step();
        let mut clock = Stopwatch::start();
        let mut rows = 0;
        if self.coupled {
            let grains = self.grains.of(self.window.number, iteration)?;
            rows = grains.len();
            self.backend.project(step, &grains)?;
        }
        self.seconds[0] += clock.lap();
        let attempt = if self.coupled {
            let reactions = self.reaction.of(self.window.number, iteration)?;
            self.backend.solve(step, &reactions)?
        } else {
            self.backend.solve(step, &[])?
        };
        self.seconds[1] += clock.lap();
        let solution = match attempt {
            Attempt::Solved(solution) => solution,
            Attempt::TooLarge(refusal) => return Ok(Advance::TooLarge(refusal)),
        };
        if self.coupled {
            self.publish_samples(iteration, step.end(), rows)?;
        }
        self.seconds[2] += clock.lap();
        Ok(Advance::Solved(Box::new(Solved {
            books: Books::Fluid { ledger: solution.ledger, norms: solution.norms },
            largest_step: self.backend.largest_step(),
            work: solution.iterations,
        })))
    }

    fn commit_window(&mut self, commit: &Commit) -> Result<Committed, FluidError> {
        let step = self.step();
        let mut clock = Stopwatch::start();
        self.backend.commit(step)?;
        self.seconds[3] += clock.lap();
        self.time = step.end();
        if commit.series {
            self.record.series(self.time, &*self.backend)?;
        }
        if let Some(number) = commit.frame {
            self.record.frame(self.time, number, &*self.backend)?;
        }
        if let Some(folder) = &commit.restart {
            let moment = Moment { time: self.time, window: self.window.number };
            let writer = CheckpointWriter::new(PART, &moment);
            self.backend.save_checkpoint(writer).write(&folder.join(PART))?;
        }
        Ok(Committed { largest_step: self.backend.largest_step(), size: self.backend.nodes() })
    }
}

impl Participant for FluidParticipant {
    fn identity(&self) -> (String, String) {
        self.identity.clone()
    }

    fn ready(&mut self) -> Result<Ready, Failure> {
        if self.time == 0.0 {
            self.record.start(&*self.backend).map_err(Failure::from)?;
        }
        let (size, largest_step) = (self.backend.nodes(), self.backend.largest_step());
        Ok(Ready {
            size,
            largest_step,
            time: self.time,
            notes: self.backend.notes(),
            surface: self.backend.surface(),
        })
    }

    fn open(&mut self, window: Window) -> Result<Opening, Failure> {
        Ok(self.open_window(window)?)
    }

    fn advance(&mut self, iteration: u32) -> Result<Advance, Failure> {
        Ok(self.advance_iteration(iteration)?)
    }

    fn restore(&mut self) -> Result<(), Failure> {
        self.backend.restore();
        Ok(())
    }

    fn commit(&mut self, commit: &Commit) -> Result<Committed, Failure> {
        Ok(self.commit_window(commit)?)
    }

    fn stop(&mut self, _reason: &str) -> Usage {
        let parts = PARTS.iter().zip(self.seconds).map(|(name, seconds)| (name.to_string(), seconds));
        let audits =
            self.backend.audits().into_iter().map(|(name, value)| (name.to_string(), value)).collect();
        Usage { parts: parts.collect(), counters: self.backend.counters(), audits, ..own_usage() }
    }
}
