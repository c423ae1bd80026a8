//! Who is near which wall.

use super::chunk::Chunk;
use super::constants::extras_on_wall;
use super::near_planes::{NearPlane, NearPlanes, PlaneSpring, Planes};
use super::springs::Memory;
use super::wall_contact::{Candidate, WallContact};
use crate::contact::{ExtraConstants, History};
use crate::domain::Image;
use crate::grains::Grains;
use crate::scene::Scene;
use crate::vector::Spin;
use crate::wall::Poses;

/// A contact inherits the spring of one with the same wall in the last step whose normal is within 30°.
const SAME_CONTACT: f64 = 0.866;

/// The grains of a chunk that are nearer to a wall than `reach` \[m\], the walls in these poses. A grain that only planes at
/// rest are near is worked on in lanes, all others one by one; springs stay with their contacts.
pub fn find_near_walls<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    planes: &Planes,
    poses: &Poses<D>,
    reach: f64,
    chunk: &mut Chunk,
) {
    chunk.stow_planes();
    chunk.candidates.clear();
    let old = remembered(chunk, planes);
    let mut old = old.as_slice();
    let (first, mut near) = (chunk.rows.start as u32, Vec::new());
    for row in chunk.rows.clone().filter(|&row| !grains.motion[row].is_frozen()) {
        near.clear();
        surfaces_near(scene, grains, poses, reach, row, &mut near);
        old = &old[old.partition_point(|contact| (contact.grain as usize) < row)..];
        let of_grain = &old[..old.partition_point(|contact| contact.grain as usize == row)];
        if near.iter().all(|candidate| planes.of_surface(candidate.surface).is_some()) {
            for candidate in &near {
                push_plane(scene, grains, planes, candidate, of_grain, first, &mut chunk.planes);
            }
        } else {
            chunk.candidates.append(&mut near);
            chunk.wall_contacts.extend_from_slice(of_grain);
        }
    }
}

/// What all contacts of a chunk with walls remember, ascending in the grain; the chunk keeps nothing.
fn remembered(chunk: &mut Chunk, planes: &Planes) -> Vec<WallContact> {
    let on_plane = |PlaneSpring { grain, plane, spring }| WallContact {
        grain,
        wall: planes.wall[plane as usize],
        normal: planes.normal(plane),
        spring,
    };
    let mut all = std::mem::take(&mut chunk.wall_contacts);
    all.extend(chunk.plane_springs.drain(..).map(on_plane));
    all.sort_by_key(|contact| contact.grain);
    all
}

fn push_plane<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    planes: &Planes,
    candidate: &Candidate,
    old: &[WallContact],
    first: u32,
    found: &mut NearPlanes,
) {
    let Some(plane) = planes.of_surface(candidate.surface) else { return };
    let Candidate { grain, coefficients, .. } = *candidate;
    let radius = grains.place[grain as usize].radius;
    let (wall, normal) = (planes.wall[plane as usize], planes.normal(plane));
    let spring = inherited(old, wall, &normal);
    let near =
        NearPlane { grain, plane, radius, coefficients, extras: extras_near(scene, grains, candidate) };
    found.push(&near, first, planes.surface.len() as u32, &spring, Memory::of(scene));
}

/// The spring of the contact of a grain with a wall that has nearly this normal, among the grain's contacts.
pub fn inherited(of_grain: &[WallContact], wall: u32, normal: &Spin) -> History {
    of_grain
        .iter()
        .filter(|contact| contact.wall == wall)
        .map(|contact| (contact.normal.dot(normal), &contact.spring))
        .filter(|(alignment, _)| *alignment > SAME_CONTACT)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(History::none(), |(_, spring)| spring.clone())
}

fn surfaces_near<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    poses: &Poses<D>,
    reach: f64,
    row: usize,
    near: &mut Vec<Candidate>,
) {
    let here = Image::new([0; D]);
    let place = &grains.place[row];
    let reach = place.radius + reach;
    let mut found = Vec::new();
    for code in 0..scene.shifts.len() as u32 {
        let image = Image(code);
        let centre = place.at::<D>() - scene.shifts[code as usize];
        found.clear();
        if image == here {
            scene.walls.planes_near(&centre, reach, poses, &mut found);
        } else if scene.shifts[code as usize].norm_squared() == 0.0 {
            continue;
        }
        scene.walls.facets_near(&centre, reach, poses, &mut found);
        near.extend(found.iter().filter_map(|&surface| candidate(scene, grains, row as u32, surface, image)));
    }
}

/// A grain and a surface near it, with the constants of their contact.
pub fn candidate<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
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

/// Constants of its laws besides normal and tangential force, if there are any.
pub fn extras_near<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    candidate: &Candidate,
) -> Option<ExtraConstants> {
    let wall = scene.walls.surfaces[candidate.surface as usize].wall;
    let material = scene.walls.materials[wall as usize];
    let of = || extras_on_wall(scene, grains, candidate.grain as usize, material, &candidate.coefficients);
    scene.extras.any().then(of)
}
