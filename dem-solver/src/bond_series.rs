//! `series/bonds.csv`: the bonds that hold, and those that broke so far.

use crate::bond::{BondError, Broken};
use crate::bonded::bond_energy;
use crate::scene::Scene;
use crate::world::World;

/// Those that hold, torn, sheared and gone with a removed grain, and the energy in their springs; nothing in a scene
/// without bonds.
pub fn bond_titles<const D: usize>(scene: &Scene<D>) -> Vec<String> {
    let titles = ["intact[-]", "torn[-]", "sheared[-]", "orphaned[-]", "energy[J]"];
    let shown = if scene.bond_laws.is_empty() { &[][..] } else { &titles };
    shown.iter().map(ToString::to_string).collect()
}

/// The time and the values under these titles.
///
/// # Errors
/// A bond of a grain, or of a law, that is not there.
pub fn bond_row<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Result<Vec<f64>, BondError> {
    let Broken { tension, shear, orphaned } = world.bonds.broken();
    let counts = [world.bonds.len() as u64, tension, shear, orphaned].map(|count| count as f64);
    let [intact, torn, sheared, orphaned] = counts;
    Ok(vec![world.time, intact, torn, sheared, orphaned, bond_energy(scene, world)?])
}
