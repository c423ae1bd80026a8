//! Scratch: nothing here outlives a window, nothing of it is ever stored.

use crate::bond::Links;
use crate::clumped::Members;
use crate::contact::Pressed;
use crate::engine::{ChunkLoads, ContactList, Periods, Planes, WallContact};
use crate::fault::Fault;
use crate::lanes::Backend;
use crate::relaxation::Relaxation;
use crate::scene::Scene;
use crate::sleep::{Held, Slumber, Work};
use crate::vector::Vector;
use crate::wall::{Poses, WallImpulse};
use crate::world::World;

/// What a grain received so far in the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse<const D: usize> {
    /// Drag impulse J \[N s\].
    pub drag: Vector<D>,
    /// Impulse of all other forces \[N s\].
    pub other: Vector<D>,
}

impl<const D: usize> Impulse<D> {
    /// Nothing yet.
    pub fn zero() -> Self {
        Self { drag: Vector::zeros(), other: Vector::zeros() }
    }
}

/// Scratch of one chunk of grains.
#[derive(Clone, Debug)]
pub struct ChunkScratch<const D: usize> {
    /// What each wall received in this window.
    pub wall_impulse: Vec<WallImpulse<D>>,
    /// Impulse given to frozen grains by contacts in this window \[N s\].
    pub frozen_impulse: Vector<D>,
    /// Impulse that stopped grains and holds them asleep in this window \[N s\].
    pub asleep_impulse: Vector<D>,
    /// What each wall received in the last step that the chunk found its forces in; nothing where no grain may sleep.
    pub last_wall_impulse: Vec<WallImpulse<D>>,
    /// What held the chunk at rest when it was last asked.
    pub held: Held,
    /// What was slept since it was last booked.
    pub slumber: Slumber,
    /// Wall contacts of the last step.
    pub old_wall_contacts: Vec<WallContact>,
    /// Surfaces that one grain presses into.
    pub pressed: Vec<Pressed<D>>,
    /// The first thing that went wrong.
    pub fault: Option<Fault>,
}

impl<const D: usize> ChunkScratch<D> {
    fn new() -> Self {
        Self {
            wall_impulse: vec![],
            frozen_impulse: Vector::zeros(),
            asleep_impulse: Vector::zeros(),
            last_wall_impulse: vec![],
            held: Held::default(),
            slumber: Slumber::default(),
            old_wall_contacts: vec![],
            pressed: vec![],
            fault: None,
        }
    }

    fn open(&mut self, walls: usize) {
        self.wall_impulse.clear();
        self.wall_impulse.resize(walls, WallImpulse::zero());
        self.frozen_impulse = Vector::zeros();
        self.asleep_impulse = Vector::zeros();
        self.fault = None;
    }
}

impl<const D: usize> ChunkScratch<D> {
    /// Keeps what walls received in this step; `last_wall_impulse` is what they had received before.
    pub fn keep_wall_impulse(&mut self) {
        self.last_wall_impulse
            .iter_mut()
            .zip(&self.wall_impulse)
            .for_each(|(last, &now)| *last = now - *last);
    }

    /// Walls receive what they received in the last step.
    pub fn repeat_wall_impulse(&mut self) {
        self.wall_impulse.iter_mut().zip(&self.last_wall_impulse).for_each(|(sum, &last)| *sum += last);
    }
}

/// All scratch.
#[derive(Clone, Debug)]
pub struct Workspace<const D: usize> {
    /// The lanes that kernels run on.
    pub backend: Backend,
    /// Time in the middle of the present substep \[s\].
    pub time: f64,
    /// Where the walls are at that time.
    pub walls: Poses<D>,
    /// The planes at rest.
    pub planes: Planes,
    /// Periodic axes.
    pub periods: Periods,
    /// By chunk of grains.
    pub chunks: Vec<ChunkScratch<D>>,
    /// By chunk: loads on its rows and on those of later chunks that its pairs reach.
    pub loads: Vec<ChunkLoads>,
    /// By chunk: what the step does with its forces.
    pub work: Vec<Work>,
    /// In the coming step the forces of all chunks are found, of sleeping ones too.
    pub survey: bool,
    /// By chunk: whether its grains may have moved since the last inner list.
    pub stale: Vec<bool>,
    /// The bonds tied to the rows of this window.
    pub links: Links,
    /// The members of clumps tied to the rows of this window.
    pub members: Members,
    /// How each grain relaxes to the fluid in a substep of this window; empty without fluid.
    pub relaxation: Vec<Relaxation>,
    /// How much of a substep the grain that relaxes fastest flies on with its old velocity.
    pub late: f64,
    /// What each grain received in this window; empty without fluid.
    pub impulse: Vec<Impulse<D>>,
}

impl<const D: usize> Workspace<D> {
    /// Empty scratch for the widest lanes of this CPU; it grows to what the scene needs.
    pub fn new() -> Self {
        Self::on(Backend::best())
    }

    /// Empty scratch for these lanes.
    pub fn on(backend: Backend) -> Self {
        Self {
            backend,
            time: 0.0,
            walls: Poses::default(),
            planes: Planes::default(),
            periods: Periods::default(),
            chunks: vec![],
            loads: vec![],
            work: vec![],
            survey: true,
            stale: vec![],
            links: Links::default(),
            members: Members::default(),
            relaxation: vec![],
            late: 0.0,
            impulse: vec![],
        }
    }

    /// Clean scratch for a window of this world.
    pub fn open(&mut self, scene: &Scene<D>, world: &World<D>) {
        self.planes = Planes::of(scene);
        self.periods = Periods::new(&scene.domain);
        self.chunks.iter_mut().for_each(|chunk| chunk.open(scene.walls.len()));
        self.members = Members::tie(&world.bodies, &world.grains);
        self.fit(scene.walls.len(), &world.contacts);
        self.relaxation.clear();
        self.late = 0.0;
        self.impulse.clear();
    }

    /// Room for these lists; no load on any grain.
    pub fn fit(&mut self, walls: usize, contacts: &ContactList) {
        let opened = || {
            let mut chunk = ChunkScratch::new();
            chunk.open(walls);
            chunk
        };
        self.chunks.resize_with(contacts.chunks.len(), opened);
        self.loads.resize_with(contacts.chunks.len(), ChunkLoads::default);
        self.work.resize(contacts.chunks.len(), Work::All);
        self.survey = true;
        self.stale.clear();
        self.stale.resize(contacts.chunks.len(), true);
        for (loads, chunk) in self.loads.iter_mut().zip(&contacts.chunks) {
            loads.clear(chunk.grain_of_slot.len(), self.planes.rows.len());
        }
    }

    /// Goes to the middle of a substep, at `time` \[s\].
    pub fn enter(&mut self, scene: &Scene<D>, world: &World<D>, time: f64) {
        self.time = time;
        self.walls = scene.walls.poses(time, &world.slides);
    }

    /// What each wall received so far in this window, chunk by chunk.
    pub fn wall_impulse(&self, walls: usize) -> Vec<WallImpulse<D>> {
        let mut received = vec![WallImpulse::zero(); walls];
        for chunk in &self.chunks {
            received.iter_mut().zip(&chunk.wall_impulse).for_each(|(sum, &impulse)| *sum += impulse);
        }
        received
    }

    /// The first fault, in the order of chunks.
    pub fn fault(&self) -> Option<Fault> {
        self.chunks.iter().find_map(|chunk| chunk.fault)
    }
}

impl<const D: usize> Default for Workspace<D> {
    fn default() -> Self {
        Self::new()
    }
}
