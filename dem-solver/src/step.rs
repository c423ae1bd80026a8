//! The step.

use interface::HydroRow;

use crate::bonded::pull_bonds;
use crate::engine::{bring_up_lists, forces};
use crate::error::DemError;
use crate::integrate::advance;
use crate::scene::Scene;
use crate::sleep::assign_work;
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
    bring_up_lists(scene, world, workspace, step)?;
    assign_work(scene, world, workspace);
    forces(scene, world, workspace, step);
    let faulty = |fault, time| DemError::Fault { fault, time };
    pull_bonds(scene, world, workspace).map_err(|fault| faulty(fault, workspace.time))?;
    advance(scene, world, workspace, hydro, step, flight);
    workspace.fault().map_or(Ok(()), |fault| Err(faulty(fault, workspace.time)))
}
