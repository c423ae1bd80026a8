//! Forces between grains and planes, block by block.

use std::marker::PhantomData;

use super::block::{AnnuliBlock, ConstantsBlock, PlaneBlock, SpringBlock, WIDTH};
use super::extras::ExtraForces;
use crate::contact::cohesion::{Bodies, Hold, Proximity};
use crate::contact::normal::Normal;
use crate::contact::rolling::Rolling;
use crate::contact::tangential::{Annuli, Spring, Tangential};
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
    /// Their annuli; empty unless they slip in part.
    pub annuli: &'a mut [AnnuliBlock],
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
        let near =
            if X::ANY { distance.less(radius + self.extras.reach::<L>((block, lane))) } else { touching };
        if !L::any(near) {
            if T::REMEMBERS {
                self.springs[block].relax::<L>(lane);
            }
            if T::SLIPS_IN_PART {
                self.annuli[block].relax::<L>(lane);
            }
            self.extras.relax::<L>((block, lane));
            return false;
        }
        let bodies = Bodies::SphereAndWall(radius);
        let [velocity, spin] = unsafe { L::columns8(self.motions, grain) };
        let normal = -outward;
        let (closing, step) = (velocity.dot(normal), L::splat(self.step));
        let proximity = Proximity { bodies, distance, overlap: radius - distance, travel: closing * step };
        let at = (block, lane);
        let Hold { contact, indentation, attraction, felt } = self.extras.hold(at, &proximity, touching);
        let overlap = proximity.overlap.only(contact);
        let arm = N::arm(radius, overlap, L::splat(0.0));
        let turning = if T::REMEMBERS { spin * arm } else { Vec3::zero() };
        let touch = Touch { normal, overlap: indentation, velocity: velocity + turning.cross(normal) };
        let mut spring = if T::REMEMBERS { self.springs[block].load(lane) } else { Spring::relaxed() };
        let mut annuli = if T::SLIPS_IN_PART { self.annuli[block].load(lane) } else { Annuli::relaxed() };
        let coefficients = self.constants[block].coefficients::<L>(lane);
        let memory = (&mut spring, &mut annuli);
        let Response { force, pressing } =
            touch_force::<3, N, T, L>(&coefficients, &touch, felt, memory, step);
        let mut force = force.only(contact);
        if T::REMEMBERS {
            self.springs[block].store(lane, &spring.only(contact));
        }
        if T::SLIPS_IN_PART {
            self.annuli[block].store(lane, &annuli.only(contact));
        }
        let mut torque = if T::REMEMBERS { normal.cross(force) * arm } else { Vec3::zero() };
        if X::ANY {
            let squeezed = self.extras.lubrication(at, &coefficients, proximity.overlap, closing, step);
            force = force + (normal * (attraction - squeezed)).only(near);
        }
        let point = centre + normal * arm;
        let mut reaction = force.cross(point);
        if X::ANY && T::REMEMBERS {
            let growth = N::growth(indentation);
            let rolling = Rolling {
                normal,
                spin: spin * N::wall_spin(radius, overlap),
                elastic: coefficients.normal_stiffness * growth.stiffness * indentation,
                pressing,
                growth,
                step,
            };
            let braking = self.extras.braking(at, &coefficients, &rolling, indentation, contact);
            (torque, reaction) = (torque - braking, reaction + braking);
        }
        unsafe {
            L::add8(self.loads, slot, force, torque);
            L::add8(self.reactions, plane, -force, reaction);
        }
        L::any(distance.less(L::splat(0.0)))
    }
}
