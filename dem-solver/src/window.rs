//! A window: equal substeps, and what they add up to.

use interface::HydroRow;

use crate::bonded::links;
use crate::engine::bring_up_lists;
use crate::error::DemError;
use crate::integrate::{drift, misplaced};
use crate::ledger::Ledger;
use crate::relaxation::Relaxation;
use crate::scene::Scene;
use crate::sliding::Sliding;
use crate::step::step;
use crate::workspace::{Impulse, Workspace};
use crate::world::World;

/// Moves the world by `duration` \[s\] in so many equal substeps, under the action of the fluid if there is one.
///
/// What each grain received is left in `workspace.impulse` when there is a fluid.
///
/// # Errors
/// The first fault of a step; a window that is no time; a bond without its grains; rows of the fluid that do not fit the
/// grains, or clumps in a fluid.
pub fn window<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    hydro: Option<&[HydroRow]>,
    duration: f64,
    substeps: u32,
) -> Result<Ledger<D>, DemError> {
    let dt = duration / f64::from(substeps);
    if !(dt > 0.0 && dt.is_finite()) {
        return Err(DemError::BadWindow { window: duration, substeps });
    }
    workspace.open(scene, world);
    workspace.links = links(scene, world)?;
    if hydro.is_some() && !world.bodies.is_empty() {
        return Err(DemError::ClumpsInFluid { clumps: world.bodies.as_slice().len() });
    }
    if let Some(rows) = hydro {
        relax(world, workspace, rows, dt)?;
    }
    let mut ledger = Ledger::open(world, workspace);
    // Inside the pool, parallel loops of a step start without a call across threads.
    rayon::scope(|_| {
        drift(world, workspace, 0.5 * dt);
        let mut slide = Sliding::open(scene, world, 0.5 * dt);
        (1..=substeps).try_for_each(|k| {
            let flight = if k < substeps { dt } else { 0.5 * dt };
            workspace.enter(scene, world, world.time + (f64::from(k) - 0.5) * dt);
            step(scene, world, workspace, hydro, dt, flight)?;
            slide.on(scene, world, workspace, dt, flight);
            Ok::<(), DemError>(())
        })
    })?;
    world.time += duration;
    if let Some(fault) = misplaced(scene, world) {
        return Err(DemError::Fault { fault, time: world.time });
    }
    ledger.close(scene, world, workspace, hydro, duration);
    world.received.add(&ledger.wall_impulse);
    Ok(ledger)
}

/// Makes the lists anew that expired between two windows, so that all who read them know the present contacts;
/// `step` \[s\] sizes their skins.
///
/// # Errors
/// A periodic axis that is too short; a bond without its grains.
pub fn relist<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) -> Result<(), DemError> {
    workspace.open(scene, world);
    workspace.links = links(scene, world)?;
    workspace.enter(scene, world, world.time);
    bring_up_lists(scene, world, workspace, step)
}

fn relax<const D: usize>(
    world: &World<D>,
    workspace: &mut Workspace<D>,
    hydro: &[HydroRow],
    dt: f64,
) -> Result<(), DemError> {
    let grains = &world.grains;
    if hydro.len() != grains.len() {
        return Err(DemError::WrongRows { rows: hydro.len(), grains: grains.len() });
    }
    if let Some(row) =
        hydro.iter().position(|row| !(row.exchange_coefficient >= 0.0 && row.added_mass >= 0.0))
    {
        let (exchange_coefficient, added_mass) = (hydro[row].exchange_coefficient, hydro[row].added_mass);
        return Err(DemError::BadHydro { grain: grains.id[row], exchange_coefficient, added_mass });
    }
    let relaxation =
        |(row, mass): (&HydroRow, &f64)| Relaxation::new(mass + row.added_mass, row.exchange_coefficient, dt);
    workspace.relaxation.extend(hydro.iter().zip(&grains.mass).map(relaxation));
    // The mean velocity is before + lead/gain (after - before): 1/2 where nothing relaxes.
    let late = workspace.relaxation.iter().map(|relaxation| relaxation.lead / relaxation.gain - 0.5);
    workspace.late = late.fold(0.0, f64::max);
    workspace.impulse.resize(grains.len(), Impulse::zero());
    Ok(())
}
