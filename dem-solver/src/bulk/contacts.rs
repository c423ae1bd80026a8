//! All contacts of an instant, with the forces they bear at rest.

use crate::contact::cohesion::{Bodies, Hold, Proximity};
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal, NormalLaw};
use crate::contact::tangential::{Coulomb, LiggghtsHistory, PartialSlip, Tangential};
use crate::contact::{
    COINCIDENT, Coefficients, ExtraConstants, History, Touch, surfaces_within, touch_force,
};
use crate::engine::{Chunk, Periods, Planes, extras_of_pair, extras_on_wall, inherited};
use crate::lanes::Vec3;
use crate::scene::Scene;
use crate::vector::{Spin, embed, lane, unlane};
use crate::wall::Poses;
use crate::world::World;

/// A grain that can move and what it touches or is held by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Row of the grain.
    pub grain: usize,
    /// Row of the other grain, if that can move too; nothing if it is a wall or a frozen grain.
    pub other: Option<usize>,
    /// Unit normal n, from the grain to the other body.
    pub normal: Spin,
    /// Whether they touch; else liquid between them holds them.
    pub touches: bool,
    /// Force F on the grain \[N\].
    pub force: Spin,
    /// b \[m\]: to the centre of the other grain, or to the point where the force of a wall or frozen grain acts.
    pub branch: Spin,
    /// Distances from the two centres at which the force acts \[m\]; the second is that of `other`, 0 if there is none.
    pub arms: [f64; 2],
}

impl Contact {
    /// A contact with a wall or a frozen grain, whose force acts this far from the centre \[m\].
    fn on_support(grain: usize, normal: Spin, (force, touches): (Spin, bool), arm: f64) -> Self {
        Self { grain, other: None, normal, touches, force, branch: normal * arm, arms: [arm, 0.0] }
    }
}

/// The contacts of the world in the order of the lists, with the force that the laws of the scene give them were all
/// grains and walls at rest where they are: that of the normal spring and of attraction, and what the tangential spring
/// holds within Coulomb's limit; no dashpot. Bonds are no contacts.
pub fn contacts_at_rest<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Vec<Contact> {
    match scene.normal_law {
        NormalLaw::Hooke(_) | NormalLaw::Onate(_) => by_law::<D, Hooke, Coulomb>(scene, world),
        NormalLaw::Hertz(_) => by_law::<D, Hertz, Coulomb>(scene, world),
        NormalLaw::HertzPartialSlip(_) => by_law::<D, Hertz, PartialSlip>(scene, world),
        NormalLaw::LiggghtsHooke(_) => by_law::<D, LiggghtsHooke, LiggghtsHistory>(scene, world),
        NormalLaw::LiggghtsHertz(_) => by_law::<D, LiggghtsHertz, LiggghtsHistory>(scene, world),
        NormalLaw::None => vec![],
    }
}

fn by_law<const D: usize, N: Normal<D>, T: Tangential>(scene: &Scene<D>, world: &World<D>) -> Vec<Contact> {
    let (walls, planes) = (world.wall_poses(scene), Planes::of(scene));
    let periods = Periods::new(&scene.domain);
    let mut found = Vec::new();
    for chunk in &world.contacts.chunks {
        between_grains::<D, N, T>(scene, world, &periods, chunk, &mut found);
        on_planes::<D, N, T>(scene, world, &planes, chunk, &mut found);
        on_surfaces::<D, N, T>(scene, world, &walls, chunk, &mut found);
    }
    found
}

fn between_grains<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    world: &World<D>,
    periods: &Periods,
    chunk: &Chunk,
    found: &mut Vec<Contact>,
) {
    let grains = &world.grains;
    for (k, (i, j, coefficients)) in chunk.inner.pairs(world.contacts.alike.as_ref()).enumerate() {
        let (one, other) = (&grains.place[i], &grains.place[j]);
        let separation = unlane(periods.nearest(lane(&(other.centre - one.centre))));
        let (distance, reach) = (separation.norm(), one.radius + other.radius);
        if distance <= COINCIDENT * reach {
            continue;
        }
        let (normal, overlap) = (separation / distance, reach - distance);
        let proximity =
            Proximity { bodies: Bodies::Spheres(one.radius, other.radius), distance, overlap, travel: 0.0 };
        let constants = extras_of_pair(scene, grains, (i, j), &coefficients);
        let spring = chunk.inner.springs.get(k);
        let Some((force, touches)) =
            at_rest::<D, N, T>(scene, &coefficients, &constants, (normal, proximity), spring)
        else {
            continue;
        };
        let share = one.radius / reach;
        let (arm_i, arm_j) = (N::arm(one.radius, overlap, share), N::arm(other.radius, overlap, 1.0 - share));
        found.extend(match (grains.motion[i].is_frozen(), grains.motion[j].is_frozen()) {
            (false, false) => {
                let arms = [arm_i, arm_j];
                Some(Contact { grain: i, other: Some(j), normal, touches, force, branch: separation, arms })
            }
            (false, true) => Some(Contact::on_support(i, normal, (force, touches), arm_i)),
            (true, false) => Some(Contact::on_support(j, -normal, (-force, touches), arm_j)),
            (true, true) => None,
        });
    }
}

fn on_planes<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    world: &World<D>,
    planes: &Planes,
    chunk: &Chunk,
    found: &mut Vec<Contact>,
) {
    for (k, (grain, plane, coefficients)) in chunk.planes.contacts().enumerate() {
        let overlap = planes.overlap(plane, &world.grains.place[grain]);
        let normal = planes.normal(plane as u32);
        let (pair, spring) = ((grain, planes.wall[plane]), chunk.planes.springs.get(k));
        found.extend(on_wall::<D, N, T>(scene, world, pair, &coefficients, (normal, overlap), spring));
    }
}

fn on_surfaces<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    world: &World<D>,
    walls: &Poses<D>,
    chunk: &Chunk,
    found: &mut Vec<Contact>,
) {
    let mut pressed = Vec::new();
    for candidates in chunk.candidates.chunk_by(|a, b| a.grain == b.grain) {
        let row = candidates[0].grain;
        let place = &world.grains.place[row as usize];
        surfaces_within(scene.reach(place.radius), scene, place, candidates, walls, &mut pressed);
        let begin = chunk.wall_contacts.partition_point(|contact| contact.grain < row);
        let end = chunk.wall_contacts.partition_point(|contact| contact.grain <= row);
        let of_grain = &chunk.wall_contacts[begin..end];
        for surface in pressed.iter().filter(|surface| surface.nearest.normal.norm_squared() > 0.0) {
            let normal = embed(&surface.nearest.normal);
            let overlap = place.radius - surface.nearest.distance;
            let wall = scene.walls.surfaces[surface.candidate.surface as usize].wall;
            let spring = inherited(of_grain, wall, &normal);
            let (pair, coefficients) = ((row as usize, wall), &surface.candidate.coefficients);
            found.extend(on_wall::<D, N, T>(scene, world, pair, coefficients, (normal, overlap), spring));
        }
    }
}

fn on_wall<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    world: &World<D>,
    (grain, wall): (usize, u32),
    coefficients: &Coefficients,
    (normal, overlap): (Spin, f64),
    spring: History,
) -> Option<Contact> {
    let radius = world.grains.place[grain].radius;
    let material = scene.walls.materials[wall as usize];
    let constants = extras_on_wall(scene, &world.grains, grain, material, coefficients);
    let bodies = Bodies::SphereAndWall(radius);
    let proximity = Proximity { bodies, distance: radius - overlap, overlap, travel: 0.0 };
    let hold = at_rest::<D, N, T>(scene, coefficients, &constants, (normal, proximity), spring)?;
    Some(Contact::on_support(grain, normal, hold, N::arm(radius, overlap, 0.0)))
}

/// The force of the laws at no velocity, after no time, and whether the bodies touch; nothing where nothing holds them.
fn at_rest<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    coefficients: &Coefficients,
    constants: &ExtraConstants,
    (normal, proximity): (Spin, Proximity<f64>),
    history: History,
) -> Option<(Spin, bool)> {
    if proximity.overlap <= -scene.extras.reach(constants) {
        return None;
    }
    let touching = proximity.overlap > 0.0;
    let (mut spring, mut annuli) = history.parts();
    let Hold { contact, indentation, attraction, felt } =
        scene.extras.hold(constants, &proximity, touching, &mut spring.bridge);
    let touch = Touch { normal: lane(&normal), overlap: indentation, velocity: Vec3::zero() };
    let memory = (&mut spring, &mut annuli);
    let force = touch_force::<D, N, T, f64>(coefficients, &touch, felt, memory, 0.0).force;
    let force = unlane(force.only(contact)) + normal * attraction;
    (contact || attraction != 0.0).then_some((force, contact))
}
