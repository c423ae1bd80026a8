//! Memory traffic: what a step reads and writes.

use super::scenes::STEP;
use crate::engine::Chunk;
use crate::error::DemError;
use crate::lanes::Row8;
use crate::setup::Setup;
use crate::window::window;
use crate::workspace::Workspace;

/// Bytes per grain that a step reads and writes if each of its arrays goes through the cache once: places, motions, loads
/// and springs are read and written, pairs and their constants are read.
///
/// # Errors
/// A fault of a step.
pub fn bytes_per_step(setup: &Setup<3>) -> Result<f64, DemError> {
    let mut world = setup.world.clone();
    // The lists are made in the first step.
    window(&setup.scene, &mut world, &mut Workspace::new(), None, 2.0 * STEP, 2)?;
    let grains = &world.grains;
    let moved = size_of_val(&grains.place[..]) + size_of_val(&grains.motion[..]);
    let of_contacts: usize = world.contacts.chunks.iter().map(of_chunk).sum();
    Ok((2 * moved + of_contacts) as f64 / grains.len() as f64)
}

fn of_chunk(chunk: &Chunk) -> usize {
    let Chunk { inner, planes, candidates, wall_contacts, grain_of_slot, .. } = chunk;
    let read = size_of_val(&inner.blocks[..])
        + size_of_val(&inner.constants[..])
        + size_of_val(&inner.extras[..])
        + size_of_val(&planes.blocks[..])
        + size_of_val(&planes.constants[..])
        + size_of_val(&planes.extras[..])
        + size_of_val(&candidates[..]);
    let changed = size_of_val(&inner.springs.forces[..])
        + size_of_val(&inner.springs.torques[..])
        + size_of_val(&planes.springs.forces[..])
        + size_of_val(&planes.springs.torques[..])
        + size_of_val(&wall_contacts[..])
        + grain_of_slot.len() * size_of::<Row8>();
    read + 2 * changed
}
