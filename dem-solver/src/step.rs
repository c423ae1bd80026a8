//! The step.

use interface::HydroRow;

use crate::contact::forces;
use crate::error::DemError;
use crate::integrate::advance;
use crate::scene::Scene;
use crate::search::{build_list, list_expired};
use crate::workspace::Workspace;
use crate::world::World;

/// One substep \[s\]: who is near whom, what forces they exert, how they move.
///
/// Places are those of the middle of the substep, velocities those of its start. Afterwards velocities are those
/// of its end, and places have flown on for `flight` \[s\]: to the middle of the next substep, or to the end of
/// the window.
///
/// # Errors
/// The first fault of the step.
pub fn step<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    hydro: Option<&[HydroRow]>,
    step: f64,
    flight: f64,
) -> Result<(), DemError> {
    if list_expired(scene, world, workspace) {
        build_list(scene, world, workspace.time)?;
    }
    forces(scene, world, workspace, step);
    advance(scene, world, workspace, hydro, step, flight);
    match workspace.fault() {
        Some(fault) => Err(DemError::Fault { fault, time: world.time }),
        None => Ok(()),
    }
}
