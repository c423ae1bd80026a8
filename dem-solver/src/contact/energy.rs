//! Energy stored in contacts.

use super::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal, NormalLaw};
use super::walls::pressed_surfaces;
use crate::engine::{Periods, Planes};
use crate::scene::Scene;
use crate::world::World;

/// Energy in the normal and tangential springs of all pairs of grains and of grains and walls \[J\].
pub fn stored_energy<const D: usize>(scene: &Scene<D>, world: &World<D>) -> f64 {
    match scene.normal_law {
        NormalLaw::Hooke(_) | NormalLaw::Onate(_) => by_law::<D, Hooke>(scene, world),
        NormalLaw::Hertz(_) | NormalLaw::HertzPartialSlip(_) => by_law::<D, Hertz>(scene, world),
        NormalLaw::LiggghtsHooke(_) => by_law::<D, LiggghtsHooke>(scene, world),
        NormalLaw::LiggghtsHertz(_) => by_law::<D, LiggghtsHertz>(scene, world),
        NormalLaw::None => 0.0,
    }
}

fn by_law<const D: usize, N: Normal<D>>(scene: &Scene<D>, world: &World<D>) -> f64 {
    let place = &world.grains.place;
    let (walls, planes) = (world.wall_poses(scene), Planes::of(scene));
    let periods = Periods::new(&scene.domain);
    let (mut energy, mut pressed) = (0.0, Vec::new());
    for chunk in &world.contacts.chunks {
        for (i, j, coefficients) in chunk.inner.pairs(world.contacts.alike.as_ref()) {
            let overlap = periods.overlap(&place[i], &place[j]);
            if overlap > 0.0 {
                energy += N::stored_energy(&coefficients, overlap);
            }
        }
        for (grain, plane, coefficients) in chunk.planes.contacts() {
            let overlap = planes.overlap(plane, &place[grain]);
            if overlap > 0.0 {
                energy += N::stored_energy(&coefficients, overlap);
            }
        }
        for candidates in chunk.candidates.chunk_by(|a, b| a.grain == b.grain) {
            let grain = &place[candidates[0].grain as usize];
            pressed_surfaces(scene, grain, candidates, &walls, &mut pressed);
            let stored = pressed.iter().map(|surface| {
                N::stored_energy(&surface.candidate.coefficients, grain.radius - surface.nearest.distance)
            });
            energy += stored.sum::<f64>();
        }
        energy += chunk.inner.springs.energy() + chunk.planes.springs.energy();
        energy += chunk.wall_contacts.iter().map(|contact| contact.spring.energy()).sum::<f64>();
    }
    energy
}
