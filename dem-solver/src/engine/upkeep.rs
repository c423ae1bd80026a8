//! Lists that are made anew when they may miss a contact.

use rayon::prelude::*;

use super::chunk::find_stretches;
use super::constants::Alike;
use super::inner::Refresh;
use super::levels::Levels;
use super::list::{ContactList, Skins};
use super::near_walls::find_near_walls;
use super::outer::find_outer;
use crate::contact::NormalLaw;
use crate::error::DemError;
use crate::scene::Scene;
use crate::workspace::Workspace;
use crate::world::World;

/// Steps that an outer and an inner list should last, so that making them costs little beside the steps.
const OUTER_STEPS: f64 = 300.0;
const INNER_STEPS: f64 = 20.0;
/// Smallest and largest skins, as fractions of the mean diameter.
const OUTER_SKIN: (f64, f64) = (0.1, 1.0);
const INNER_SKIN: (f64, f64) = (0.01, 0.1);

/// Makes the lists anew that may miss a contact in a step of this length \[s\].
///
/// # Errors
/// A periodic axis that is too short for a grain to see each neighbour once.
pub fn bring_up_lists<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) -> Result<(), DemError> {
    if scene.normal_law == NormalLaw::None || world.grains.is_empty() {
        if world.contacts.fit(world.grains.len()) {
            workspace.fit(scene.walls.len(), &world.contacts);
        }
        return Ok(());
    }
    let ContactList { skins, spent, walls_time, .. } = &world.contacts;
    let inner_expired = spent.inner >= skins.inner;
    let refreshed_misses = spent.outer + skins.inner >= skins.outer;
    let outer_expired = spent.outer >= skins.outer || (inner_expired && refreshed_misses);
    let walls_expired = !scene.walls.is_empty() && {
        let listed = scene.walls.listed_poses(*walls_time, &world.slides);
        let moved = scene.walls.largest_approach(&listed, &workspace.walls);
        spent.walls + moved >= skins.walls
    };
    if outer_expired || walls_expired {
        // Walls are looked for around the home image only.
        world.grains.place.iter_mut().for_each(|place| workspace.periods.wrap(&mut place.centre));
    }
    if outer_expired {
        find_pairs(scene, world, workspace, step)?;
    }
    if outer_expired || inner_expired {
        refresh_pairs(scene, world, workspace);
    }
    if !scene.walls.is_empty() && (outer_expired || walls_expired) {
        find_walls(scene, world, workspace, step);
    }
    Ok(())
}

/// The skin that lasts so many steps, within bounds \[m\].
fn skin(approach: f64, step: f64, steps: f64, (least, most): (f64, f64), diameter: f64) -> f64 {
    (approach * step * steps).clamp(least * diameter, most * diameter)
}

fn find_pairs<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) -> Result<(), DemError> {
    let (diameter, approach) = (world.grains.mean_diameter(), world.contacts.approach.between_grains);
    let largest = world.grains.largest_radius();
    let reach = scene.reach(largest);
    let World { grains, contacts, bonds, bodies, .. } = world;
    let periods = &workspace.periods;
    let shortest = (0..3).filter_map(|axis| periods.axis(axis)).map(|(_, period)| period);
    // Each neighbour must be seen once: half a period holds two largest grains, the reach of their laws and the skin.
    let room = 0.5 * shortest.fold(f64::INFINITY, f64::min) - 2.0 * largest - reach;
    let least = OUTER_SKIN.0 * diameter;
    let outer = skin(approach, step, OUTER_STEPS, OUTER_SKIN, diameter).min(0.999 * room).max(least);
    let inner = skin(approach, step, INNER_STEPS, INNER_SKIN, diameter).min(0.1 * outer);
    let seen = 2.0 * largest + reach + outer;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if let Some((_, period)) = periods.axis(axis).filter(|(_, period)| *period <= 2.0 * seen) {
            return Err(DemError::PeriodTooShort { axis: name, period, least: 2.0 * seen });
        }
    }
    contacts.fit(grains.len());
    contacts.skins = Skins { outer, inner, ..contacts.skins };
    contacts.alike = Alike::of(scene, grains);
    let levels = Levels::new(grains, periods, reach + outer);
    let (backend, grains) = (workspace.backend, &*grains);
    let mut apart = workspace.links.without_contact(&scene.bond_laws, bonds);
    apart.extend(workspace.members.pairs(bodies));
    apart.sort_unstable();
    contacts.chunks.par_iter_mut().for_each(|chunk| {
        chunk.stow_pairs();
        find_outer(backend, grains, (&levels, periods), reach + outer, &apart, chunk);
    });
    find_stretches(&mut contacts.chunks);
    contacts.spent.outer = 0.0;
    contacts.built_since_order += 1;
    contacts.counters.outer += 1;
    workspace.fit(scene.walls.len(), contacts);
    Ok(())
}

fn refresh_pairs<const D: usize>(scene: &Scene<D>, world: &mut World<D>, workspace: &mut Workspace<D>) {
    let World { grains, contacts, .. } = world;
    let refresh = Refresh {
        scene,
        grains,
        periods: &workspace.periods,
        gap: contacts.skins.inner + scene.reach(grains.largest_radius()),
        alike: contacts.alike.is_some(),
    };
    // The pairs of grains that all slept since the last list are what they were.
    let stale = &workspace.stale;
    contacts.chunks.par_iter_mut().zip(stale).for_each(|(chunk, &own)| {
        if own || chunk.stretches.iter().any(|stretch| stale[stretch.target]) {
            refresh.run(workspace.backend, chunk);
        }
    });
    if scene.sleep.is_some() {
        workspace.stale.fill(false);
    }
    contacts.spent.inner = 0.0;
    contacts.counters.inner += 1;
}

fn find_walls<const D: usize>(scene: &Scene<D>, world: &mut World<D>, workspace: &Workspace<D>, step: f64) {
    let (diameter, approach) = (world.grains.mean_diameter(), world.contacts.approach.to_walls);
    let World { grains, contacts, slides, .. } = world;
    contacts.skins.walls = skin(approach, step, OUTER_STEPS, OUTER_SKIN, diameter);
    let reach = contacts.skins.walls + scene.reach(grains.largest_radius());
    let (planes, poses) = (&workspace.planes, &workspace.walls);
    contacts.chunks.par_iter_mut().for_each(|chunk| {
        find_near_walls(scene, grains, planes, poses, reach, chunk);
    });
    contacts.walls_time = workspace.time;
    slides.iter_mut().for_each(|slide| slide.listed = slide.displacement);
    contacts.spent.walls = 0.0;
    contacts.counters.walls += 1;
}
