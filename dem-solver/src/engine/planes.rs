//! Forces between grains and planes, block by block.

use std::marker::PhantomData;

use super::block::{ConstantsBlock, PlaneBlock, SpringBlock, WIDTH};
use super::extras::ExtraForces;
use crate::contact::normal::Normal;
use crate::contact::rolling::Rolling;
use crate::contact::tangential::{Spring, Tangential};
use crate::contact::{Response, Touch, touch_force};
use crate::lanes::{Kernel, Row4, Row8, RowLanes, Vec3};

/// Adds the forces of planes on a chunk's grains to its loads, and their reactions to the planes'; tells whether a centre is
/// behind a plane.
pub struct PlaneForces<'a, N, T, X> {
    /// Places of all grains.
    pub places: &'a [Row4],
    /// Motions of all grains.
    pub motions: &'a [Row8],
    /// The planes, as [`super::Planes::rows`].
    pub planes: &'a [Row4],
    /// Who is near what.
    pub blocks: &'a [PlaneBlock],
    /// Their springs; empty without friction.
    pub springs: &'a mut [SpringBlock],
    /// Their constants.
    pub constants: &'a [ConstantsBlock],
    /// Their laws besides normal and tangential force.
    pub extras: X,
    /// Loads by slot.
    pub loads: &'a mut [Row8],
    /// Loads on the planes, torques about the origin.
    pub reactions: &'a mut [Row8],
    /// Time since springs were last moved \[s\].
    pub step: f64,
    /// The laws.
    pub laws: PhantomData<(N, T)>,
}

impl<N: Normal<3>, T: Tangential, X: ExtraForces> Kernel for PlaneForces<'_, N, T, X> {
    type Output = bool;

    #[inline(always)]
    fn run<L: RowLanes>(mut self) -> bool {
        let mut behind = false;
        for block in 0..self.blocks.len() {
            for lane in (0..WIDTH).step_by(L::WIDTH) {
                // SAFETY: blocks hold rows of grains, slots of the chunk and rows of the table of planes.
                behind |= unsafe { self.lanes::<L>(block, lane) };
            }
        }
        behind
    }
}

impl<N: Normal<3>, T: Tangential, X: ExtraForces> PlaneForces<'_, N, T, X> {
    #[inline(always)]
    unsafe fn lanes<L: RowLanes>(&mut self, block: usize, lane: usize) -> bool {
        let PlaneBlock { grain, slot, plane } = &self.blocks[block];
        let (grain, slot, plane) = (&grain[lane..], &slot[lane..], &plane[lane..]);
        let [x, y, z, radius] = unsafe { L::columns4(self.places, grain) };
        let [nx, ny, nz, offset] = unsafe { L::columns4(self.planes, plane) };
        let outward = Vec3::new(nx, ny, nz);
        let centre = Vec3::new(x, y, z);
        let distance = centre.dot(outward) - offset;
        let touching = distance.less(radius);
        if !L::any(touching) {
            if T::REMEMBERS {
                self.springs[block].relax::<L>(lane);
            }
            self.extras.relax::<L>((block, lane));
            return false;
        }
        let overlap = (radius - distance).only(touching);
        let arm = N::arm(radius, overlap, L::splat(0.0));
        let [velocity, spin] = unsafe { L::columns8(self.motions, grain) };
        let normal = -outward;
        let turning = if T::REMEMBERS { spin * arm } else { Vec3::zero() };
        let touch = Touch { normal, overlap, velocity: velocity + turning.cross(normal) };
        let mut spring = if T::REMEMBERS { self.springs[block].load(lane) } else { Spring::relaxed() };
        let coefficients = self.constants[block].coefficients::<L>(lane);
        let (at, step) = ((block, lane), L::splat(self.step));
        let attraction = self.extras.to_wall(at, radius, distance);
        let Response { force, pressing } =
            touch_force::<3, N, T, L>(&coefficients, &touch, attraction, &mut spring, step);
        let force = force.only(touching);
        if T::REMEMBERS {
            self.springs[block].store(lane, &spring.only(touching));
        }
        let mut torque = if T::REMEMBERS { normal.cross(force) * arm } else { Vec3::zero() };
        let point = centre + normal * arm;
        let mut reaction = force.cross(point);
        if X::ANY && T::REMEMBERS {
            let growth = N::growth(overlap);
            let rolling = Rolling {
                normal,
                spin: spin * N::wall_spin(radius, overlap),
                elastic: coefficients.normal_stiffness * growth.stiffness * overlap,
                pressing,
                growth,
                step,
            };
            let braking = self.extras.braking(at, &rolling, touching);
            (torque, reaction) = (torque - braking, reaction + braking);
        }
        unsafe {
            L::add8(self.loads, slot, force, torque);
            L::add8(self.reactions, plane, -force, reaction);
        }
        L::any(distance.less(L::splat(0.0)))
    }
}
