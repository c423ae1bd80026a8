//! The bonds of a world at work.

use rayon::prelude::*;

use crate::bond::{BondError, End, Links, Positions, Profile};
use crate::engine::Periods;
use crate::fault::Fault;
use crate::grains::{Grains, Motion, Place};
use crate::lanes::Row8;
use crate::scene::Scene;
use crate::sleep::Work;
use crate::vector::{Spin, lane, unlane};
use crate::workspace::Workspace;
use crate::world::World;

/// Grains as bonds see them.
struct Rows<'a> {
    place: &'a [Place],
    motion: &'a [Motion],
    periods: &'a Periods,
}

impl Positions for Rows<'_> {
    fn separation(&self, i: usize, j: usize) -> Spin {
        unlane(self.periods.nearest(lane(&(self.place[j].centre - self.place[i].centre))))
    }

    fn angular_velocity(&self, row: usize) -> Spin {
        self.motion[row].angular_velocity
    }
}

/// The bonds of the world tied to its rows.
///
/// # Errors
/// A bond of a grain, or of a law, that is not there.
pub fn links<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Result<Links, BondError> {
    let World { grains, bonds, .. } = world;
    if bonds.is_empty() {
        return Ok(Links::default());
    }
    let profile = if D == 2 { Profile::Strip { depth: scene.depth } } else { Profile::Round };
    Links::new(&scene.bond_laws, profile, bonds, &grains.id, |row| end(grains, row))
}

fn end(grains: &Grains, row: usize) -> End {
    let Motion { inverse_mass, inverse_inertia, .. } = grains.motion[row];
    End { radius: grains.place[row].radius, inverse_mass, inverse_inertia }
}

/// Adds what the bonds exert at the present places to the loads; where a contact takes the place of one that broke, the
/// lists expire.
///
/// # Errors
/// Two bonded grains whose centres coincide.
pub fn pull_bonds<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
) -> Result<(), Fault> {
    let World { grains, bonds, contacts, .. } = world;
    if bonds.is_empty() {
        return Ok(());
    }
    let Workspace { links, loads, work, periods, .. } = workspace;
    let rows = Rows { place: &grains.place, motion: &grains.motion, periods };
    let broke = links.pull(&scene.bond_laws, bonds, &rows)?;
    let links = &*links;
    let asked = contacts.chunks.par_iter().zip(loads).zip(work).filter(|(_, work)| **work == Work::All);
    asked.for_each(|((chunk, loads), _)| {
        for (row, Row8(load)) in chunk.rows.clone().zip(&mut loads.slots) {
            let (force, torque) = links.load(row);
            for axis in 0..3 {
                load[axis] += force[axis];
                load[4 + axis] += torque[axis];
            }
        }
    });
    if broke > 0 && scene.bond_laws.iter().any(|law| law.law().replaces_contact()) {
        contacts.expire();
    }
    Ok(())
}

/// Energy in the springs of the bonds that hold, where they were last pulled \[J\].
///
/// # Errors
/// A bond of a grain, or of a law, that is not there.
pub fn bond_energy<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Result<f64, BondError> {
    let links = links(scene, world)?;
    let holding = world.bonds.iter().zip(links.beams()).filter(|(bond, _)| bond.failure.is_none());
    Ok(holding.map(|(bond, beam)| bond.stored_energy(beam)).sum())
}
