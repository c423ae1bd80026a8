//! The grains as a participant: what they do on each command of the coupler.

use crate::critical_time_step::{Substep, critical_time_step, substeps};
use crate::error::DemError;
use crate::record::Record;
use crate::scene::Scene;
use crate::setup::Setup;
use crate::thrift::thrift;
use crate::turnover::turn_over;
use crate::vector::embed;
use crate::window::{relist, window as advance_window};
use crate::workspace::Workspace;
use crate::world::{Saved, World};
use interface::frames::{GrainRow, HydroRow, ImpulseRow};
use interface::message::{Books, Commit, Committed, Failure, Opened, Ready, Solved, Usage, Window};
use interface::participant::{Advance, Opening, Participant};
use interface::transport::{FrameReader, FrameWriter, Stamp};
use interface::usage::{Stopwatch, own_usage};
use std::path::Path;

/// The name of the grains' part of a restart point.
pub const PART: &str = "dem-solver";

/// A scene, its state and its wires.
pub struct DemParticipant<const D: usize> {
    scene: Scene<D>,
    world: World<D>,
    saved: Saved<D>,
    workspace: Workspace<D>,
    substep: Substep,
    grains: FrameWriter<GrainRow>,
    impulse: FrameWriter<ImpulseRow>,
    hydro: FrameReader<HydroRow>,
    record: Record,
    identity: (String, String),
    /// There is a fluid on the other side.
    coupled: bool,
    /// The grains frame of this state has been published.
    published: bool,
    window: Window,
    /// The window is not history yet.
    open: bool,
    seconds: f64,
}

/// The wires of the grains.
pub type Frames = (FrameWriter<GrainRow>, FrameWriter<ImpulseRow>, FrameReader<HydroRow>);

impl<const D: usize> DemParticipant<D> {
    /// Grains at time 0; `coupled` if there is a fluid on the other side.
    pub fn new(
        Setup { scene, world, substep }: Setup<D>,
        (grains, impulse, hydro): Frames,
        record: Record,
        identity: (String, String),
        coupled: bool,
    ) -> Self {
        DemParticipant {
            scene,
            world,
            saved: Saved::default(),
            workspace: Workspace::new(),
            substep,
            grains,
            impulse,
            hydro,
            record,
            identity,
            coupled,
            published: false,
            window: Window { number: 0, time: 0.0, step: 0.0, grains_changed: false },
            open: false,
            seconds: 0.0,
        }
    }

    /// Goes on from a restart point.
    ///
    /// # Errors
    /// A damaged or foreign checkpoint.
    pub fn resume(&mut self, folder: &Path) -> Result<(), DemError> {
        let feeds = std::mem::take(&mut self.world.feeds);
        self.world = World::read_checkpoint(&folder.join(PART), &self.scene, feeds)?;
        self.record.resume(&self.scene, &self.world)
    }

    fn publish_grains(&mut self, iteration: u32, time: f64, order_changed: bool) -> Result<(), DemError> {
        let stamp =
            Stamp { window: self.window.number, iteration, time, step: self.window.step, order_changed };
        let world = &self.world;
        Ok(self.grains.write(stamp, world.grains.len(), |row| grain_row(world, row))?)
    }

    /// Grains are born and removed, a window is opened, its first state is saved. A window offered anew has had its births;
    /// its grains are published again.
    fn open_window(&mut self, window: Window) -> Result<Opening, DemError> {
        let offered_anew = std::mem::replace(&mut self.open, true);
        let order_changed = !offered_anew && turn_over(&self.scene, &mut self.world)?.order_changed;
        self.window = window;
        if self.world.contacts.has_expired() {
            let step = window.step / f64::from(self.substeps()?);
            relist(&self.scene, &mut self.world, &mut self.workspace, step)?;
        }
        let grains_changed = self.coupled && (order_changed || offered_anew || !self.published);
        if grains_changed {
            self.publish_grains(0, window.time, order_changed)?;
            self.published = true;
        }
        self.world.save(&mut self.saved);
        Ok(Opening::Opened(Opened { rows: self.world.grains.len() as u64, grains_changed }))
    }

    fn substeps(&self) -> Result<u32, DemError> {
        substeps(self.window.step, self.substep, &critical_time_step(&self.scene, &self.world))
    }

    fn advance_iteration(&mut self, iteration: u32) -> Result<Solved, DemError> {
        let mut clock = Stopwatch::start();
        let count = self.substeps()?;
        let ledger = {
            let hydro = if self.coupled { Some(self.hydro.of(self.window.number, iteration)?) } else { None };
            let (scene, world, workspace) = (&self.scene, &mut self.world, &mut self.workspace);
            advance_window(scene, world, workspace, hydro.as_deref(), self.window.step, count)?
        };
        // Exactly where the coupler's clock will be.
        self.world.time = self.window.time + self.window.step;
        if self.coupled {
            self.publish_grains(iteration, self.world.time, false)?;
            self.publish_impulses(iteration)?;
        }
        self.seconds += clock.lap();
        Ok(Solved { books: Books::Grains(ledger.row()), largest_step: f64::INFINITY, work: u64::from(count) })
    }

    fn publish_impulses(&mut self, iteration: u32) -> Result<(), DemError> {
        let Window { number: window, time, step, .. } = self.window;
        let stamp = Stamp { window, iteration, time, step, order_changed: false };
        let impulses = &self.workspace.impulse;
        Ok(self.impulse.write(stamp, impulses.len(), |row| ImpulseRow {
            drag: embed(&impulses[row].drag).into(),
            other: (embed(&impulses[row].other) / step).into(),
        })?)
    }

    fn commit_window(&mut self, commit: &Commit) -> Result<Committed, DemError> {
        self.open = false;
        self.world.bonds.sweep(|_| true);
        if commit.series {
            self.record.row(&self.scene, &self.world)?;
            self.world.received.restart(self.world.time);
        }
        if let Some(number) = commit.frame {
            self.record.frame(&self.scene, &self.world, number)?;
        }
        if let Some(folder) = &commit.restart {
            self.world.write_checkpoint(&folder.join(PART))?;
        }
        Ok(Committed { largest_step: f64::INFINITY, size: self.world.grains.len() as u64 })
    }
}

fn grain_row<const D: usize>(world: &World<D>, row: usize) -> GrainRow {
    let (place, motion) = (&world.grains.place[row], &world.grains.motion[row]);
    GrainRow {
        id: world.grains.id[row],
        position: place.centre.into(),
        velocity: motion.velocity.into(),
        angular_velocity: motion.angular_velocity.into(),
        radius: place.radius,
        mass: if motion.is_frozen() { f64::INFINITY } else { world.grains.mass[row] },
    }
}

impl<const D: usize> Participant for DemParticipant<D> {
    fn identity(&self) -> (String, String) {
        self.identity.clone()
    }

    fn ready(&mut self) -> Result<Ready, Failure> {
        if self.world.time == 0.0 {
            self.record.start(&self.scene, &self.world).map_err(Failure::from)?;
        }
        let size = self.world.grains.len() as u64;
        let critical = critical_time_step(&self.scene, &self.world);
        let limit = if critical.step.is_finite() {
            format!("critical step {:.3e} s, set by {}", critical.step, critical.binding)
        } else {
            "no critical step at the start: nothing touches".to_string()
        };
        let mut notes = vec![format!("{size} grains at the start"), limit];
        if !self.world.bodies.is_empty() {
            notes.push(format!("{} clumps, whose members are grains", self.world.bodies.as_slice().len()));
        }
        if !self.world.bonds.is_empty() {
            notes.push(format!("{} bonds at the start", self.world.bonds.len()));
        }
        Ok(Ready { size, largest_step: f64::INFINITY, time: self.world.time, notes, surface: None })
    }

    fn open(&mut self, window: Window) -> Result<Opening, Failure> {
        Ok(self.open_window(window)?)
    }

    fn advance(&mut self, iteration: u32) -> Result<Advance, Failure> {
        Ok(Advance::Solved(Box::new(self.advance_iteration(iteration)?)))
    }

    fn restore(&mut self) -> Result<(), Failure> {
        self.world.restore(&self.saved);
        Ok(())
    }

    fn commit(&mut self, commit: &Commit) -> Result<Committed, Failure> {
        Ok(self.commit_window(commit)?)
    }

    fn stop(&mut self, _reason: &str) -> Usage {
        let (counters, taken) = thrift(&self.scene, &self.world.contacts);
        Usage { parts: vec![("substeps".to_string(), self.seconds)], counters, taken, ..own_usage() }
    }
}
