//! Forces between grains.

use super::forces::{ChunkForces, Load};
use super::list::CHUNK;
use super::normal::Normal;
use super::tangential::{Spring, Tangential};
use super::touch::{Touch, touch_force};
use crate::fault::Fault;
use crate::grains::Grains;
use crate::vector::{Vector, moment, spin_velocity};

/// Centres nearer than this fraction of the sum of radii have no direction that a force could take.
pub const COINCIDENT: f64 = 1e-9;

/// Adds up the forces of the chunk's pairs.
pub fn pair_forces<const D: usize, N: Normal<D>, T: Tangential<D>>(
    grains: &Grains<D>,
    shifts: &[Vector<D>],
    task: &mut ChunkForces<D>,
    step: f64,
) {
    let first = task.index * CHUNK;
    let chunk = &mut *task.chunk;
    for (k, pair) in chunk.pairs.iter().enumerate() {
        let (i, j) = (pair.i as usize, pair.j as usize);
        let (a, b) = (&grains.place[i], &grains.place[j]);
        let separation = b.centre + shifts[pair.image.0 as usize] - a.centre;
        let reach = a.radius + b.radius;
        let squared = separation.norm_squared();
        if squared >= reach * reach {
            if T::REMEMBERS {
                chunk.springs[k] = Spring::relaxed();
            }
            continue;
        }
        let distance = squared.sqrt();
        if distance <= COINCIDENT * reach {
            task.scratch.fault.get_or_insert(Fault::Coincident { one: grains.id[i], other: grains.id[j] });
            continue;
        }
        let normal = separation / distance;
        let overlap = reach - distance;
        let [arm_i, arm_j] = [a, b].map(|grain| normal * N::arm(grain.radius, overlap, reach));
        let (m, n) = (&grains.motion[i], &grains.motion[j]);
        let velocity = m.velocity - n.velocity
            + spin_velocity(&m.angular_velocity, &arm_i)
            + spin_velocity(&n.angular_velocity, &arm_j);
        let touch = Touch { normal, overlap, velocity };
        let mut none = Spring::relaxed();
        let spring = if T::REMEMBERS { &mut chunk.springs[k] } else { &mut none };
        let force = touch_force::<D, N, T>(&chunk.coefficients[k], &touch, spring, step);
        task.loads[i - first] += Load { force, torque: moment(&arm_i, &force) };
        task.loads[pair.slot as usize] += Load { force: -force, torque: moment(&arm_j, &force) };
    }
}
