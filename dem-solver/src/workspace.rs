//! Scratch: nothing here outlives a window, nothing of it is ever stored.

use crate::contact::{CHUNK, Load, Pressed, WallContact, chunk_count};
use crate::fault::Fault;
use crate::integrate::Displacement;
use crate::relaxation::Relaxation;
use crate::scene::Scene;
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
    /// Loads on the chunk's rows, joined.
    pub total: Vec<Load<D>>,
    /// What each wall received in this window.
    pub wall_impulse: Vec<WallImpulse<D>>,
    /// Impulse given to frozen grains by contacts in this window \[N s\].
    pub frozen_impulse: Vector<D>,
    /// How far the chunk's grains are from where the neighbour list saw them.
    pub displacement: Displacement<D>,
    /// Wall contacts of the last step.
    pub old_wall_contacts: Vec<WallContact<D>>,
    /// Surfaces that one grain presses into.
    pub pressed: Vec<Pressed<D>>,
    /// The first thing that went wrong.
    pub fault: Option<Fault>,
}

impl<const D: usize> ChunkScratch<D> {
    fn new() -> Self {
        Self {
            total: vec![],
            wall_impulse: vec![],
            frozen_impulse: Vector::zeros(),
            displacement: Displacement::none(),
            old_wall_contacts: vec![],
            pressed: vec![],
            fault: None,
        }
    }
}

/// All scratch.
#[derive(Clone, Debug)]
pub struct Workspace<const D: usize> {
    /// Time in the middle of the present substep \[s\].
    pub time: f64,
    /// Where the walls are at that time.
    pub walls: Poses<D>,
    /// By chunk of grains.
    pub chunks: Vec<ChunkScratch<D>>,
    /// By chunk: loads on its rows and, behind them, on its overhang.
    pub loads: Vec<Vec<Load<D>>>,
    /// How each grain relaxes to the fluid in a substep of this window; empty without fluid.
    pub relaxation: Vec<Relaxation>,
    /// What each grain received in this window; empty without fluid.
    pub impulse: Vec<Impulse<D>>,
}

impl<const D: usize> Workspace<D> {
    /// Empty scratch; it grows to what the scene needs.
    pub fn new() -> Self {
        Self {
            time: 0.0,
            walls: Poses::default(),
            chunks: vec![],
            loads: vec![],
            relaxation: vec![],
            impulse: vec![],
        }
    }

    /// Clean scratch for a window of this world.
    pub fn open(&mut self, world: &World<D>, walls: usize) {
        self.chunks.resize_with(chunk_count(world.grains.len()), ChunkScratch::new);
        self.loads.resize_with(self.chunks.len(), Vec::new);
        for chunk in &mut self.chunks {
            chunk.wall_impulse.clear();
            chunk.wall_impulse.resize(walls, WallImpulse::zero());
            chunk.frozen_impulse = Vector::zeros();
            chunk.fault = None;
        }
        self.relaxation.clear();
        self.impulse.clear();
    }

    /// Goes to the middle of a substep, at `time` \[s\].
    pub fn enter(&mut self, scene: &Scene<D>, time: f64) {
        self.time = time;
        self.walls = scene.walls.poses(time);
    }

    /// No load on any of so many grains.
    pub fn clear_loads(&mut self, grains: usize) {
        for (index, loads) in self.loads.iter_mut().enumerate() {
            loads.clear();
            loads.resize(CHUNK.min(grains - index * CHUNK), Load::zero());
        }
    }

    /// The first fault, in the order of chunks.
    pub fn fault(&self) -> Option<Fault> {
        self.chunks.iter().find_map(|chunk| chunk.fault)
    }

    /// How far grains are from where the neighbour list saw them.
    pub fn displacement(&self) -> Displacement<D> {
        self.chunks.iter().fold(Displacement::none(), |all, chunk| all.joined(&chunk.displacement))
    }
}

impl<const D: usize> Default for Workspace<D> {
    fn default() -> Self {
        Self::new()
    }
}
