//! Forces between grains and walls, one by one.

use super::cohesion::{Bodies, Hold, Proximity};
use super::history::History;
use super::normal::Normal;
use super::rolling::Rolling;
use super::tangential::{Spring, Tangential};
use super::touch::{Response, Touch, touch_force};
use super::twisting::Twisting;
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

/// A surface that a grain presses into, or is near.
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
        let reach = scene.reach(place.radius);
        surfaces_within(reach, scene, place, candidates, walls, &mut scratch.pressed);
        old = &old[old.partition_point(|contact| contact.grain < row)..];
        let of_grain = &old[..old.partition_point(|contact| contact.grain == row)];
        for pressed in &scratch.pressed {
            let normal = pressed.nearest.normal;
            if normal.norm_squared() == 0.0 {
                let grain = grains.id[row as usize];
                scratch.fault.get_or_insert(Fault::OnWall { grain, wall: pressed.wall });
                continue;
            }
            let (mut spring, mut annuli) = inherited(of_grain, pressed.wall, &embed(&normal)).parts();
            let (coefficients, constants) = (
                &pressed.candidate.coefficients,
                extras_near(scene, grains, &pressed.candidate).unwrap_or_default(),
            );
            let (bodies, distance) = (Bodies::SphereAndWall(place.radius), pressed.nearest.distance);
            let overlap = place.radius - distance;
            let arm = normal * N::arm(place.radius, overlap, 0.0);
            let motion = &grains.motion[row as usize];
            let point = place.at::<D>() - scene.shifts[pressed.candidate.image.0 as usize] + arm;
            let mut velocity = motion.velocity + embed(&spin_velocity(&motion.angular_velocity, &arm));
            if let Some(pose) = walls.of(pressed.wall) {
                velocity -= embed(&pose.velocity_at(&point));
            }
            let closing = velocity.dot(&embed(&normal));
            // Past a surface of two sides the centre would see the other side, as if nothing had been.
            if distance < closing.max(0.0) * step {
                let (grain, wall, depth) = (grains.id[row as usize], pressed.wall, overlap / place.radius);
                let speed = velocity.norm();
                scratch.fault.get_or_insert(Fault::ThroughWall { grain, wall, depth, speed });
            }
            let proximity = Proximity { bodies, distance, overlap, travel: closing * step };
            let Hold { contact, indentation, attraction, felt } =
                scene.extras.hold(&constants, &proximity, overlap > 0.0, &mut spring.bridge);
            let squeezed = scene.extras.lubrication.map_or(0.0, |law| {
                law.push(constants.lubrication, coefficients.inverse_mass, -overlap, closing, step)
            });
            let touch =
                Touch { normal: lane(&embed(&normal)), overlap: indentation, velocity: lane(&velocity) };
            let memory = (&mut spring, &mut annuli);
            let Response { force, pressing } =
                touch_force::<D, N, T, f64>(coefficients, &touch, felt, memory, step);
            let mut braking = Spin::zeros();
            if contact && T::REMEMBERS {
                let growth = N::growth(indentation);
                let rolling = Rolling {
                    normal: touch.normal,
                    spin: lane(&motion.angular_velocity) * N::wall_spin(place.radius, overlap),
                    elastic: coefficients.normal_stiffness * growth.stiffness * indentation,
                    pressing,
                    growth,
                    step,
                };
                if let Some(law) = scene.extras.rolling {
                    braking += unlane(law.torque(&constants.rolling, &rolling, &mut spring.torque));
                }
                if let Some(law) = scene.extras.twisting {
                    let radius = constants.effective_radius;
                    let twisting = Twisting::new(coefficients, &rolling, indentation, radius);
                    braking += unlane(touch.normal * law.torque(&twisting, &mut spring.twist));
                }
            }
            let bridge = spring.bridge;
            spring = Spring { bridge, ..spring.only(contact) };
            let force = unlane(force.only(contact) + touch.normal * (attraction - squeezed));
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
            if spring.is_active() {
                let (wall, normal) = (pressed.wall, embed(&normal));
                let spring =
                    History { spring, annuli: T::SLIPS_IN_PART.then(|| Box::new(annuli.only(contact))) };
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
    surfaces_within(0.0, scene, place, candidates, walls, pressed);
}

/// The distinct surfaces within this gap \[m\] of a grain, in their order.
pub fn surfaces_within<const D: usize>(
    reach: f64,
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
        (nearest.distance < place.radius + reach).then_some(Pressed {
            nearest,
            candidate,
            wall: surface.wall,
        })
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
            height > SAME_PLANE * radius + (radius - deeper.nearest.distance).max(0.0)
        });
        if stands_out {
            pressed[kept] = candidate;
            kept += 1;
        }
    }
    pressed.truncate(kept);
}
