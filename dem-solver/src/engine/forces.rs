//! All contact forces of a step, chunk by chunk.

use rayon::prelude::*;

use super::chunk::Chunk;
use super::kernels::Kernels;
use super::near_planes::{NearPlanes, Planes};
use super::periods::Periods;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal};
use crate::contact::tangential::{Coulomb, Frictionless, LiggghtsHistory, PartialSlip, Tangential};
use crate::contact::{COINCIDENT, NormalLaw, wall_forces};
use crate::fault::Fault;
use crate::grains::{AsRows, Grains};
use crate::lanes::Row8;
use crate::scene::Scene;
use crate::vector::{Spin, restrict};
use crate::wall::{Poses, WallImpulse};
use crate::workspace::{ChunkScratch, Workspace};
use crate::world::World;

/// Contact forces at the present places into the chunks' loads; springs move by `step` \[s\].
///
/// Each chunk adds up its own rows and, behind them, those of later chunks that its pairs load; the
/// integration joins the parts in the order of chunks.
pub fn forces<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    step: f64,
) {
    let World { grains, contacts, .. } = world;
    let Workspace { backend, planes, periods, walls, chunks: scratches, loads, work, .. } = workspace;
    let asleep = scene.sleep.is_some();
    let Some(law) = scene.normal_law.in_lanes::<D>() else { return };
    let kernels = Kernels {
        law,
        rubs: scene.materials.rub(),
        extras: scene.extras,
        backend: *backend,
        places: grains.place.as_rows(),
        motions: grains.motion.as_rows(),
        planes: &planes.rows,
        periods,
        alike: contacts.alike,
        step,
    };
    let parts = contacts.chunks.par_iter_mut().zip(loads).zip(scratches).zip(work);
    parts.for_each(|(((chunk, loads), scratch), work)| {
        if !work.finds_forces() {
            scratch.repeat_wall_impulse();
            return;
        }
        if asleep {
            scratch.last_wall_impulse.clone_from(&scratch.wall_impulse);
        }
        let slots = &mut loads.slots;
        on_walls_one_by_one(scene, grains, walls, chunk, (slots, scratch), step);
        if kernels.on_planes(chunk, loads)
            && let Some(fault) = behind_plane(grains, planes, &chunk.planes)
        {
            scratch.fault.get_or_insert(fault);
        }
        book(&mut loads.planes, planes, step, scratch);
        if let Some((i, j)) = kernels.between_grains(chunk, &mut loads.slots) {
            scratch.fault.get_or_insert(too_deep(grains, periods, i as usize, j as usize));
        }
        if asleep {
            scratch.keep_wall_impulse();
        }
    });
}

/// The first grain whose centre is behind a plane.
#[cold]
fn behind_plane(grains: &Grains, planes: &Planes, near: &NearPlanes) -> Option<Fault> {
    near.contacts().find_map(|(row, plane, _)| {
        let (place, motion) = (&grains.place[row], &grains.motion[row]);
        let depth = planes.overlap(plane, place) / place.radius;
        let speed = motion.velocity.norm();
        let grain = grains.id[row];
        (depth > 1.0).then_some(Fault::ThroughWall { grain, wall: planes.wall[plane], depth, speed })
    })
}

/// What is wrong with two grains of which one holds the centre of the other.
#[cold]
fn too_deep(grains: &Grains, periods: &Periods, i: usize, j: usize) -> Fault {
    let (one, other) = (&grains.place[i], &grains.place[j]);
    let overlap = periods.overlap(one, other);
    if one.radius + other.radius - overlap <= COINCIDENT * (one.radius + other.radius) {
        return Fault::Coincident { one: grains.id[i], other: grains.id[j] };
    }
    let (inner, outer) = if one.radius < other.radius { (i, j) } else { (j, i) };
    Fault::TooDeep {
        grain: grains.id[inner],
        other: grains.id[outer],
        depth: overlap / grains.place[inner].radius,
        speed: (grains.motion[i].velocity - grains.motion[j].velocity).norm(),
    }
}

/// Books what planes received in a step \[s\], and leaves it empty for the next.
fn book<const D: usize>(received: &mut [Row8], planes: &Planes, step: f64, scratch: &mut ChunkScratch<D>) {
    for (row, &wall) in received.iter_mut().zip(&planes.wall) {
        let [fx, fy, fz, _, tx, ty, tz, _] = std::mem::take(row).0;
        let linear = restrict(&Spin::new(fx, fy, fz)) * step;
        let angular = Spin::new(tx, ty, tz) * step;
        scratch.wall_impulse[wall as usize] += WallImpulse { linear, angular };
    }
}

fn on_walls_one_by_one<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    walls: &Poses<D>,
    chunk: &mut Chunk,
    (loads, scratch): (&mut [Row8], &mut ChunkScratch<D>),
    step: f64,
) {
    let out = (loads, scratch);
    match scene.normal_law {
        NormalLaw::None => {}
        NormalLaw::Hooke(_) | NormalLaw::Onate(_) => {
            by_law::<D, Hooke, Coulomb>(scene, grains, walls, chunk, out, step);
        }
        NormalLaw::Hertz(_) => by_law::<D, Hertz, Coulomb>(scene, grains, walls, chunk, out, step),
        NormalLaw::HertzPartialSlip(_) => {
            by_law::<D, Hertz, PartialSlip>(scene, grains, walls, chunk, out, step);
        }
        NormalLaw::LiggghtsHooke(_) => {
            by_law::<D, LiggghtsHooke, LiggghtsHistory>(scene, grains, walls, chunk, out, step);
        }
        NormalLaw::LiggghtsHertz(_) => {
            by_law::<D, LiggghtsHertz, LiggghtsHistory>(scene, grains, walls, chunk, out, step);
        }
    }
}

fn by_law<const D: usize, N: Normal<D>, T: Tangential>(
    scene: &Scene<D>,
    grains: &Grains,
    walls: &Poses<D>,
    chunk: &mut Chunk,
    out: (&mut [Row8], &mut ChunkScratch<D>),
    step: f64,
) {
    if scene.materials.rub() {
        wall_forces::<D, N, T>(scene, grains, walls, chunk, out, step);
    } else {
        wall_forces::<D, N, Frictionless>(scene, grains, walls, chunk, out, step);
    }
}
