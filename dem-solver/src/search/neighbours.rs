//! The neighbour list: built with a skin, used until some grain may have crossed it.

use rayon::prelude::*;

use super::cells::Cells;
use crate::contact::{CHUNK, Candidate, Chunk, Incoming, NormalLaw, Pair, Remembered, Spring, chunk_count};
use crate::domain::Image;
use crate::error::DemError;
use crate::grains::Grains;
use crate::integrate::Displacement;
use crate::scene::Scene;
use crate::wall::Poses;
use crate::workspace::Workspace;
use crate::world::World;

/// Skin as a fraction of the mean diameter.
const SKIN: f64 = 0.1;

/// Whether two grains, or a grain and a wall, that the list does not know may touch.
pub fn list_expired<const D: usize>(scene: &Scene<D>, world: &World<D>, workspace: &Workspace<D>) -> bool {
    if scene.normal_law == NormalLaw::None {
        return false;
    }
    let mut displacement = workspace.displacement();
    let mut of_walls = 0.0;
    if !scene.walls.is_empty() {
        displacement = displacement.joined(&Displacement::of_rest());
        of_walls = scene.walls.largest_approach(&scene.walls.poses(world.list_time), &workspace.walls);
    }
    !world.contacts.valid || displacement.largest_approach() + of_walls >= world.contacts.skin
}

/// Builds the list anew, the walls in their poses at `time` \[s\]; springs of touching pairs go from the old list to the new one.
///
/// # Errors
/// A periodic axis that is too short for a grain to see each neighbour once.
pub fn build_list<const D: usize>(scene: &Scene<D>, world: &mut World<D>, time: f64) -> Result<(), DemError> {
    world.list_time = time;
    let poses = scene.walls.poses(time);
    let World { grains, contacts, .. } = world;
    for place in &mut grains.place {
        place.centre = scene.domain.wrapped(&place.centre);
    }
    let largest = grains.place.iter().map(|place| place.radius).fold(0.0, f64::max);
    let mean = grains.place.iter().map(|place| place.radius).sum::<f64>() / grains.len().max(1) as f64;
    contacts.skin = SKIN * 2.0 * mean;
    let reach = 2.0 * largest + contacts.skin;
    if let Some(axis) =
        (0..D).find(|&axis| scene.domain.periodic[axis] && scene.domain.period(axis) <= 2.0 * reach)
    {
        let axis_name = ["x", "y", "z"][axis];
        return Err(DemError::PeriodTooShort {
            axis: axis_name,
            period: scene.domain.period(axis),
            least: 2.0 * reach,
        });
    }
    let cells = Cells::new(&grains.place, &scene.domain, reach);
    contacts.reference.clear();
    contacts.reference.extend(grains.place.iter().map(|place| place.centre));
    contacts.chunks.resize_with(chunk_count(grains.len()), Chunk::new);
    let (grains, skin) = (&*grains, contacts.skin);
    contacts.chunks.par_iter_mut().enumerate().for_each(|(index, chunk)| {
        chunk.stow();
        find_pairs(scene, grains, &cells, skin, index, chunk);
        find_candidates(scene, grains, &poses, skin, index, chunk);
    });
    contacts.incoming = incoming(&contacts.chunks);
    contacts.valid = true;
    contacts.built_since_order += 1;
    Ok(())
}

fn find_pairs<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains<D>,
    cells: &Cells<D>,
    skin: f64,
    index: usize,
    chunk: &mut Chunk<D>,
) {
    let rows = index * CHUNK..grains.len().min((index + 1) * CHUNK);
    let mut near: Vec<(u32, Image)> = Vec::new();
    for i in rows {
        near.clear();
        let (a, m) = (&grains.place[i], &grains.motion[i]);
        cells.visit_around(&a.centre, |j, image| {
            let (b, n) = (&grains.place[j as usize], &grains.motion[j as usize]);
            let reach = a.radius + b.radius + skin;
            let separation = b.centre + scene.shifts[image.0 as usize] - a.centre;
            let wanted = j as usize > i && !(m.is_frozen() && n.is_frozen());
            if wanted && separation.norm_squared() < reach * reach {
                near.push((j, image));
            }
        });
        near.sort_unstable();
        chunk.pairs.extend(near.iter().map(|&(j, image)| Pair { i: i as u32, j, slot: 0, image }));
    }
    complete(scene, grains, index, chunk);
    if scene.materials.rub() {
        recall(chunk);
    }
    chunk.remembered.clear();
}

/// Finds what follows from the chunk's pairs: their constants, and where loads on their second grains go.
pub fn complete<const D: usize>(scene: &Scene<D>, grains: &Grains<D>, index: usize, chunk: &mut Chunk<D>) {
    let first = index * CHUNK;
    let end = grains.len().min(first + CHUNK);
    chunk.coefficients.extend(chunk.pairs.iter().filter_map(|pair| {
        let (i, j) = (pair.i as usize, pair.j as usize);
        let (a, b) = (grains.place[i].radius, grains.place[j].radius);
        let mass = 1.0 / (grains.motion[i].inverse_mass + grains.motion[j].inverse_mass);
        scene.coefficients((grains.material[i], grains.material[j]), a * b / (a + b), mass)
    }));
    chunk.overhang.extend(chunk.pairs.iter().map(|pair| pair.j).filter(|&j| j as usize >= end));
    chunk.overhang.sort_unstable();
    chunk.overhang.dedup();
    for pair in &mut chunk.pairs {
        pair.slot = if (pair.j as usize) < end {
            pair.j - first as u32
        } else {
            (end - first + chunk.overhang.partition_point(|&row| row < pair.j)) as u32
        };
    }
}

/// Gives the springs of the last list to the pairs of this one; both ascend in `(i, j)`.
fn recall<const D: usize>(chunk: &mut Chunk<D>) {
    let mut remembered = chunk.remembered.iter().peekable();
    let springs = chunk.pairs.iter().map(|pair| {
        while remembered.next_if(|entry: &&Remembered<D>| (entry.i, entry.j) < (pair.i, pair.j)).is_some() {}
        remembered
            .next_if(|entry| (entry.i, entry.j) == (pair.i, pair.j))
            .map_or(Spring::relaxed(), |e| e.spring)
    });
    chunk.springs.extend(springs);
}

fn find_candidates<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains<D>,
    poses: &Poses<D>,
    skin: f64,
    index: usize,
    chunk: &mut Chunk<D>,
) {
    let mut found = Vec::new();
    let here = Image::new([0; D]);
    for row in index * CHUNK..grains.len().min((index + 1) * CHUNK) {
        let place = &grains.place[row];
        if grains.motion[row].is_frozen() {
            continue;
        }
        let reach = place.radius + skin;
        for code in 0..scene.shifts.len() as u32 {
            let image = Image(code);
            let centre = place.centre - scene.shifts[code as usize];
            found.clear();
            if image == here {
                scene.walls.planes_near(&centre, reach, poses, &mut found);
            } else if scene.shifts[code as usize].norm_squared() == 0.0 {
                continue;
            }
            scene.walls.facets_near(&centre, reach, poses, &mut found);
            let near =
                found.iter().filter_map(|&surface| candidate(scene, grains, row as u32, surface, image));
            chunk.candidates.extend(near);
        }
    }
}

/// A grain and a surface near it, with the constants of their contact.
pub fn candidate<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains<D>,
    grain: u32,
    surface: u32,
    image: Image,
) -> Option<Candidate> {
    let row = grain as usize;
    let wall = scene.walls.surfaces[surface as usize].wall;
    let materials = (grains.material[row], scene.walls.materials[wall as usize]);
    let coefficients = scene.coefficients(materials, grains.place[row].radius, grains.mass[row])?;
    Some(Candidate { grain, surface, image, coefficients })
}

/// For each chunk, the stretches of earlier chunks' overhangs that lie in it.
pub fn incoming<const D: usize>(chunks: &[Chunk<D>]) -> Vec<Vec<Incoming>> {
    let mut incoming = vec![Vec::new(); chunks.len()];
    for (source, chunk) in chunks.iter().enumerate() {
        let mut begin = 0;
        for stretch in chunk.overhang.chunk_by(|a, b| *a as usize / CHUNK == *b as usize / CHUNK) {
            let end = begin + stretch.len() as u32;
            incoming[stretch[0] as usize / CHUNK].push(Incoming { source: source as u32, begin, end });
            begin = end;
        }
    }
    incoming
}
