//! Kinetic energy.

use crate::world::World;

/// Kinetic energy of all that can move: of translation, Σ m v²/2, and of rotation, Σ I ω²/2 and Σ ω·L/2 of clumps \[J\].
pub fn kinetic_energies<const D: usize>(world: &World<D>) -> [f64; 2] {
    let of_grains = world.grains.motion.iter().filter(|motion| motion.is_loose()).map(|motion| {
        [0.5 * motion.velocity.norm_squared() / motion.inverse_mass, motion.rotational_energy()]
    });
    let of_clumps = world.bodies.as_slice().iter().map(|clump| clump.kinetic_energies());
    of_grains.chain(of_clumps).fold([0.0; 2], |[translation, rotation], [moving, turning]| {
        [translation + moving, rotation + turning]
    })
}
