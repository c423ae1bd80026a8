//! `series/bulk.csv`: what the contacts are together.

use super::clumps::contacts_of_bodies;
use super::contacts::contacts_at_rest;
use super::coordination::coordination;
use super::fabric::fabric;
use super::stress::contact_stress;
use super::tensor::{NAMES, Tensor, components};
use super::volume::bulk_volume;
use crate::contact::NormalLaw;
use crate::kinetic_energy::kinetic_energies;
use crate::scene::Scene;
use crate::world::World;

/// Grains that touch, contacts between grains and on walls, coordination number, fabric, stress and its volume, kinetic
/// energy of translation and of rotation. Nothing where nothing can touch.
pub fn bulk_titles<const D: usize>(scene: &Scene<D>) -> Vec<String> {
    if scene.normal_law == NormalLaw::None {
        return vec![];
    }
    let counts = ["touching[-]", "contacts[-]", "wall-contacts[-]", "coordination[-]"].map(String::from);
    let tensor = |name: &str, unit: &str| NAMES.map(|component| format!("{name}-{component}[{unit}]"));
    let rest = ["volume[m^3]", "translation-energy[J]", "rotation-energy[J]"].map(String::from);
    [&counts[..], &tensor("fabric", "-"), &tensor("stress", "Pa"), &rest].concat()
}

/// The time and the values under these titles.
pub fn bulk_row<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Vec<f64> {
    let held = contacts_of_bodies(world, contacts_at_rest(scene, world));
    let touching: Vec<_> = held.iter().filter(|contact| contact.touches).copied().collect();
    let count = coordination(&touching, world.grains.len());
    let volume = bulk_volume(scene, world);
    let stress = if volume > 0.0 { contact_stress(&held, volume) } else { Tensor::zeros() };
    let counts = [count.touching, count.between_grains, count.on_walls].map(|count| count as f64);
    let mut row = vec![world.time];
    row.extend(counts);
    row.push(count.mean());
    row.extend(components(&fabric(&touching)));
    row.extend(components(&stress));
    row.push(volume);
    row.extend(kinetic_energies(world));
    row
}
