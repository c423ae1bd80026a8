//! Forces between grains and walls, one by one.

use super::normal::Normal;
use super::rolling::Rolling;
use super::tangential::{Spring, Tangential};
use super::touch::{Response, Touch, touch_force};
use crate::engine::{Candidate, Chunk, WallContact, extras_near, inherited};
use crate::fault::Fault;
use crate::grains::{Grains, Place};
use crate::lanes::Row8;
use crate::scene::Scene;
use crate::vector::{Spin, embed, lane, restrict, spin_velocity, unlane};
use crate::wall::{Nearest, Poses, WallImpulse};
use crate::workspace::ChunkScratch;

/// A surface whose nearest point is this near the tangent plane of a deeper contact, relative to the radius and beyond
/// the deeper overlap, is the same wall going on, not another one.
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

/// Adds up the forces of the chunk's candidates on its grains, and of these grains on the walls.
pub fn wall_forces<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    grains: &Grains,
    walls: &Poses<D>,
    chunk: &mut Chunk,
    (loads, scratch): (&mut [Row8], &mut ChunkScratch<D>),
    step: f64,
) {
    std::mem::swap(&mut chunk.wall_contacts, &mut scratch.old_wall_contacts);
    chunk.wall_contacts.clear();
    let mut old = scratch.old_wall_contacts.as_slice();
    for candidates in chunk.candidates.chunk_by(|a, b| a.grain == b.grain) {
        let row = candidates[0].grain;
        let place = &grains.place[row as usize];
        pressed_surfaces(scene, place, candidates, walls, &mut scratch.pressed);
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
            let arm = normal * N::arm(place.radius, overlap, 0.0);
            let motion = &grains.motion[row as usize];
            let point = place.at::<D>() - scene.shifts[pressed.candidate.image.0 as usize] + arm;
            let mut velocity = motion.velocity + embed(&spin_velocity(&motion.angular_velocity, &arm));
            if let Some(pose) = walls.of(pressed.wall) {
                velocity -= embed(&pose.velocity_at(&point));
            }
            let closing = velocity.dot(&embed(&normal));
            // Past a surface of two sides the centre would see the other side, as if nothing had been.
            if pressed.nearest.distance < closing.max(0.0) * step {
                let (grain, wall, depth) = (grains.id[row as usize], pressed.wall, overlap / place.radius);
                scratch.fault.get_or_insert(Fault::ThroughWall {
                    grain,
                    wall,
                    depth,
                    speed: velocity.norm(),
                });
            }
            let touch = Touch { normal: lane(&embed(&normal)), overlap, velocity: lane(&velocity) };
            let mut spring = if T::REMEMBERS {
                inherited(of_grain, pressed.wall, &embed(&normal))
            } else {
                Spring::relaxed()
            };
            let (coefficients, extras) =
                (&pressed.candidate.coefficients, extras_near(scene, grains, &pressed.candidate));
            let attraction = match (scene.extras.cohesion, &extras) {
                (Some(law), Some(of)) => {
                    of.cohesion * law.area_on_wall(place.radius, pressed.nearest.distance)
                }
                _ => 0.0,
            };
            let Response { force, pressing } =
                touch_force::<D, N, T, f64>(coefficients, &touch, attraction, &mut spring, step);
            let force = unlane(force);
            let mut braking = Spin::zeros();
            if let (Some(law), Some(of), true) = (scene.extras.rolling, &extras, T::REMEMBERS) {
                let growth = N::growth(overlap);
                let rolling = Rolling {
                    normal: touch.normal,
                    spin: lane(&motion.angular_velocity) * N::wall_spin(place.radius, overlap),
                    elastic: coefficients.normal_stiffness * growth.stiffness * overlap,
                    pressing,
                    growth,
                    step,
                };
                braking = unlane(law.torque(&of.rolling, &rolling, &mut spring.torque));
            }
            let torque = embed(&arm).cross(&force) - braking;
            let load = &mut loads[row as usize - chunk.rows.start].0;
            for axis in 0..3 {
                load[axis] += force[axis];
                load[4 + axis] += torque[axis];
            }
            let impulse = -restrict::<D>(&force) * step;
            let mut received = WallImpulse::at(&point, impulse);
            received.angular += braking * step;
            scratch.wall_impulse[pressed.wall as usize] += received;
            if T::REMEMBERS {
                let (wall, normal) = (pressed.wall, embed(&normal));
                chunk.wall_contacts.push(WallContact { grain: row, wall, normal, spring });
            }
        }
    }
}

/// The distinct surfaces that a grain presses into, in their order.
pub fn pressed_surfaces<const D: usize>(
    scene: &Scene<D>,
    place: &Place,
    candidates: &[Candidate],
    walls: &Poses<D>,
    pressed: &mut Vec<Pressed<D>>,
) {
    pressed.clear();
    pressed.extend(candidates.iter().filter_map(|&candidate| {
        let surface = &scene.walls.surfaces[candidate.surface as usize];
        let centre = place.at() - scene.shifts[candidate.image.0 as usize];
        let nearest = scene.walls.nearest(candidate.surface, &centre, walls);
        (nearest.distance < place.radius).then_some(Pressed { nearest, candidate, wall: surface.wall })
    }));
    keep_distinct(pressed, place.radius);
    // Sums in one order, whether a grain is worked on here or in lanes.
    pressed.sort_by_key(|surface| (surface.candidate.image, surface.candidate.surface));
}

/// Keeps, deepest first, the surfaces that stand out of the tangent planes of all deeper ones: a flat wall of
/// many triangles is felt once, an edge or a corner shared by several is felt once, a groove is felt twice.
///
/// A groove of angle θ stands out by rθ²/2 at most. Up to the overlap δ the two contact areas, of radius √(2rδ), are one:
/// so shallow a groove, as single precision makes of a plane, is felt once.
fn keep_distinct<const D: usize>(pressed: &mut Vec<Pressed<D>>, radius: f64) {
    pressed.sort_by(|a, b| a.nearest.distance.total_cmp(&b.nearest.distance));
    let mut kept = 0;
    for k in 0..pressed.len() {
        let candidate = pressed[k];
        let arm = candidate.nearest.normal * candidate.nearest.distance;
        let stands_out = pressed[..kept].iter().all(|deeper| {
            let height = deeper.nearest.distance - arm.dot(&deeper.nearest.normal);
            height > SAME_PLANE * radius + (radius - deeper.nearest.distance)
        });
        if stands_out {
            pressed[kept] = candidate;
            kept += 1;
        }
    }
    pressed.truncate(kept);
}
