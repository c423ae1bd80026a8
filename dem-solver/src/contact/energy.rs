//! Energy stored in contacts.

use super::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal, NormalLaw};
use super::tangential::Spring;
use super::walls::pressed_surfaces;
use crate::scene::Scene;
use crate::world::World;

/// Energy in the normal and tangential springs of all pairs of grains and of grains and walls \[J\].
pub fn stored_energy<const D: usize>(scene: &Scene<D>, world: &World<D>) -> f64 {
    match scene.normal_law {
        NormalLaw::Hooke(_) => by_law::<D, Hooke>(scene, world),
        NormalLaw::Hertz(_) => by_law::<D, Hertz>(scene, world),
        NormalLaw::LiggghtsHooke(_) => by_law::<D, LiggghtsHooke>(scene, world),
        NormalLaw::LiggghtsHertz(_) => by_law::<D, LiggghtsHertz>(scene, world),
        NormalLaw::None => 0.0,
    }
}

fn by_law<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>) -> f64 {
    let place = &world.grains.place;
    let walls = scene.walls.poses(world.time);
    let tangential = |spring: &Spring<D>| 0.5 * spring.stiffness * spring.elongation.norm_squared();
    let (mut energy, mut pressed) = (0.0, Vec::new());
    for chunk in &world.contacts.chunks {
        for (pair, coefficients) in chunk.pairs.iter().zip(&chunk.coefficients) {
            let (a, b) = (&place[pair.i as usize], &place[pair.j as usize]);
            let distance = (b.centre + scene.shifts[pair.image.0 as usize] - a.centre).norm();
            let overlap = a.radius + b.radius - distance;
            if overlap > 0.0 {
                energy += N::stored_energy(coefficients, overlap);
            }
        }
        for candidates in chunk.candidates.chunk_by(|a, b| a.grain == b.grain) {
            let grain = &place[candidates[0].grain as usize];
            pressed_surfaces(scene, grain, candidates, &walls, &mut pressed);
            energy += pressed
                .iter()
                .map(|surface| {
                    N::stored_energy(&surface.candidate.coefficients, grain.radius - surface.nearest.distance)
                })
                .sum::<f64>();
        }
        energy += chunk.springs.iter().map(tangential).sum::<f64>();
        energy += chunk.wall_contacts.iter().map(|contact| tangential(&contact.spring)).sum::<f64>();
    }
    energy
}
