//! All contact forces of a step, chunk by chunk.

use std::ops::AddAssign;

use rayon::prelude::*;

use super::list::{CHUNK, Chunk};
use super::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal, NormalLaw};
use super::pairs::pair_forces;
use super::tangential::{Coulomb, Frictionless, LiggghtsHistory, Tangential};
use super::walls::wall_forces;
use crate::scene::Scene;
use crate::vector::{Spin, Vector};
use crate::wall::Poses;
use crate::workspace::{ChunkScratch, Workspace};
use crate::world::World;

/// Force and torque on a grain.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Load<const D: usize> {
    /// Force \[N\].
    pub force: Vector<D>,
    /// Torque about the centre \[N m\].
    pub torque: Spin,
}

impl<const D: usize> Load<D> {
    /// No load.
    pub fn zero() -> Self {
        Self { force: Vector::zeros(), torque: Spin::zeros() }
    }
}

impl<const D: usize> AddAssign for Load<D> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.force += other.force;
        self.torque += other.torque;
    }
}

/// One chunk at work: it alone writes its contacts and its scratch.
pub struct ChunkForces<'a, const D: usize> {
    /// Which chunk.
    pub index: usize,
    /// Its contacts.
    pub chunk: &'a mut Chunk<D>,
    /// Loads on its rows and its overhang.
    pub loads: &'a mut Vec<Load<D>>,
    /// Where the walls are.
    pub walls: &'a Poses<D>,
    /// Its scratch.
    pub scratch: &'a mut ChunkScratch<D>,
}

/// Contact forces at the present places into the chunks' scratch; springs move by `step` \[s\].
///
/// Each chunk adds up its own rows and, behind them, those of later chunks that its pairs load; the
/// integration joins the parts in the order of chunks.
pub fn forces<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) {
    match scene.normal_law {
        NormalLaw::None => workspace.clear_loads(world.grains.len()),
        NormalLaw::Hooke(_) => rubbing_or_not::<D, Hooke, Coulomb>(scene, world, workspace, step),
        NormalLaw::Hertz(_) => rubbing_or_not::<D, Hertz, Coulomb>(scene, world, workspace, step),
        NormalLaw::LiggghtsHooke(_) => {
            rubbing_or_not::<D, LiggghtsHooke, LiggghtsHistory>(scene, world, workspace, step);
        }
        NormalLaw::LiggghtsHertz(_) => {
            rubbing_or_not::<D, LiggghtsHertz, LiggghtsHistory>(scene, world, workspace, step);
        }
    }
}

fn rubbing_or_not<const D: usize, N: Normal<D>, T: Tangential<D>>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) {
    if scene.materials.rub() {
        by_law::<D, N, T>(scene, world, workspace, step);
    } else {
        by_law::<D, N, Frictionless>(scene, world, workspace, step);
    }
}

fn by_law<const D: usize, N: Normal<D>, T: Tangential<D>>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) {
    let World { grains, contacts, .. } = world;
    let (grains, shifts) = (&*grains, &scene.shifts);
    let Workspace { walls, chunks: scratches, loads, .. } = workspace;
    let walls = &*walls;
    let chunks = contacts.chunks.par_iter_mut().zip(loads).zip(scratches).enumerate();
    chunks.for_each(|(index, ((chunk, loads), scratch))| {
        let rows = CHUNK.min(grains.len() - index * CHUNK);
        loads.clear();
        loads.resize(rows + chunk.overhang.len(), Load::zero());
        let mut task = ChunkForces { index, chunk, loads, walls, scratch };
        pair_forces::<D, N, T>(grains, shifts, &mut task, step);
        wall_forces::<D, N, T>(scene, grains, &mut task, step);
    });
}
