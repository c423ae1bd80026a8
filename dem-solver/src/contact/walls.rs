//! Forces between grains and walls.

use super::forces::{ChunkForces, Load};
use super::list::{CHUNK, Candidate, WallContact};
use super::normal::Normal;
use super::tangential::{Spring, Tangential};
use super::touch::{Touch, touch_force};
use crate::fault::Fault;
use crate::grains::{Grains, Place};
use crate::scene::Scene;
use crate::vector::{Vector, moment, spin_velocity};
use crate::wall::{Nearest, Poses, WallImpulse};

/// A contact inherits the spring of one with the same wall in the last step whose normal is within 30°.
const SAME_CONTACT: f64 = 0.866;

/// A surface whose nearest point is this near the tangent plane of a deeper contact, relative to the radius,
/// is the same wall going on, not another one.
const SAME_PLANE: f64 = 1e-9;

/// A surface that a grain presses into.
#[derive(Clone, Copy, Debug)]
pub struct Pressed<const D: usize> {
    /// Its nearest point.
    pub nearest: Nearest<D>,
    /// The pair of grain and surface.
    pub candidate: Candidate,
    wall: u32,
}

/// Adds up the forces of walls on the chunk's grains and of these grains on the walls.
pub fn wall_forces<const D: usize, N: Normal<D>, T: Tangential<D>>(
    scene: &Scene<D>,
    grains: &Grains<D>,
    task: &mut ChunkForces<D>,
    step: f64,
) {
    let first = task.index * CHUNK;
    let scratch = &mut *task.scratch;
    std::mem::swap(&mut task.chunk.wall_contacts, &mut scratch.old_wall_contacts);
    task.chunk.wall_contacts.clear();
    let mut old = scratch.old_wall_contacts.as_slice();
    for candidates in task.chunk.candidates.chunk_by(|a, b| a.grain == b.grain) {
        let row = candidates[0].grain;
        let place = &grains.place[row as usize];
        pressed_surfaces(scene, place, candidates, task.walls, &mut scratch.pressed);
        old = &old[old.partition_point(|contact| contact.grain < row)..];
        let of_grain = &old[..old.partition_point(|contact| contact.grain == row)];
        for pressed in &scratch.pressed {
            let normal = pressed.nearest.normal;
            if normal.norm_squared() == 0.0 {
                let grain = grains.id[row as usize];
                scratch.fault.get_or_insert(Fault::OnWall { grain, wall: pressed.wall });
                continue;
            }
            let overlap = place.radius - pressed.nearest.distance;
            let arm = normal * N::arm(place.radius, overlap, f64::INFINITY);
            let motion = &grains.motion[row as usize];
            let point = place.centre - scene.shifts[pressed.candidate.image.0 as usize] + arm;
            let mut velocity = motion.velocity + spin_velocity(&motion.angular_velocity, &arm);
            if let Some(pose) = task.walls.of(pressed.wall) {
                velocity -= pose.velocity_at(&point);
            }
            let touch = Touch { normal, overlap, velocity };
            let mut spring =
                if T::REMEMBERS { inherited(of_grain, pressed.wall, &normal) } else { Spring::relaxed() };
            let force = touch_force::<D, N, T>(&pressed.candidate.coefficients, &touch, &mut spring, step);
            task.loads[row as usize - first] += Load { force, torque: moment(&arm, &force) };
            scratch.wall_impulse[pressed.wall as usize] += WallImpulse::at(&point, -force * step);
            if T::REMEMBERS {
                task.chunk.wall_contacts.push(WallContact { grain: row, wall: pressed.wall, normal, spring });
            }
        }
    }
}

/// The distinct surfaces that a grain presses into, deepest first.
pub fn pressed_surfaces<const D: usize>(
    scene: &Scene<D>,
    place: &Place<D>,
    candidates: &[Candidate],
    walls: &Poses<D>,
    pressed: &mut Vec<Pressed<D>>,
) {
    pressed.clear();
    pressed.extend(candidates.iter().filter_map(|&candidate| {
        let surface = &scene.walls.surfaces[candidate.surface as usize];
        let centre = place.centre - scene.shifts[candidate.image.0 as usize];
        let nearest = scene.walls.nearest(candidate.surface, &centre, walls);
        (nearest.distance < place.radius).then_some(Pressed { nearest, candidate, wall: surface.wall })
    }));
    keep_distinct(pressed, place.radius);
}

/// Keeps, deepest first, the surfaces that stand out of the tangent planes of all deeper ones: a flat wall of
/// many triangles is felt once, an edge or a corner shared by several is felt once, a groove is felt twice.
fn keep_distinct<const D: usize>(pressed: &mut Vec<Pressed<D>>, radius: f64) {
    pressed.sort_by(|a, b| a.nearest.distance.total_cmp(&b.nearest.distance));
    let mut kept = 0;
    for k in 0..pressed.len() {
        let candidate = pressed[k];
        let arm = candidate.nearest.normal * candidate.nearest.distance;
        let stands_out = pressed[..kept].iter().all(|deeper| {
            let height = deeper.nearest.distance - arm.dot(&deeper.nearest.normal);
            height > SAME_PLANE * radius
        });
        if stands_out {
            pressed[kept] = candidate;
            kept += 1;
        }
    }
    pressed.truncate(kept);
}

fn inherited<const D: usize>(old: &[WallContact<D>], wall: u32, normal: &Vector<D>) -> Spring<D> {
    old.iter()
        .filter(|contact| contact.wall == wall)
        .map(|contact| (contact.normal.dot(normal), contact.spring))
        .filter(|(alignment, _)| *alignment > SAME_CONTACT)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(Spring::relaxed(), |(_, spring)| spring)
}
