//! Forces between grains, block by block.

use std::marker::PhantomData;

use super::block::{AnnuliBlock, PairBlock, SpringBlock, WIDTH};
use super::constants::PairConstants;
use super::extras::ExtraForces;
use super::periods::Periods;
use crate::contact::cohesion::{Bodies, Hold, Proximity};
use crate::contact::normal::Normal;
use crate::contact::rolling::Rolling;
use crate::contact::tangential::{Annuli, Spring, Tangential};
use crate::contact::{NEAREST, Response, Touch, touch_force};
use crate::lanes::{Kernel, Row4, Row8, RowLanes, Vec3};

/// Adds the forces of a chunk's pairs to its loads; finds two grains of which one holds the centre of the other, if any do.
pub struct PairForces<'a, N, T, C, X> {
    /// Places of all grains.
    pub places: &'a [Row4],
    /// Motions of all grains.
    pub motions: &'a [Row8],
    /// The chunk's pairs.
    pub blocks: &'a [PairBlock],
    /// Their springs; empty without friction.
    pub springs: &'a mut [SpringBlock],
    /// Their annuli; empty unless they slip in part.
    pub annuli: &'a mut [AnnuliBlock],
    /// Their radii and constants.
    pub constants: C,
    /// Their laws besides normal and tangential force.
    pub extras: X,
    /// Loads by slot.
    pub loads: &'a mut [Row8],
    /// Periodic axes.
    pub periods: &'a Periods,
    /// Time since springs were last moved \[s\].
    pub step: f64,
    /// The laws.
    pub laws: PhantomData<(N, T)>,
}

impl<N, T, C, X> Kernel for PairForces<'_, N, T, C, X>
where
    N: Normal<3>,
    T: Tangential,
    C: PairConstants,
    X: ExtraForces,
{
    type Output = Option<(u32, u32)>;

    #[inline(always)]
    fn run<L: RowLanes>(mut self) -> Option<(u32, u32)> {
        let mut too_deep = None;
        for block in 0..self.blocks.len() {
            for lane in (0..WIDTH).step_by(L::WIDTH) {
                // SAFETY: the rows of a block are rows of the grains, its slots are slots of the chunk's loads:
                // both are made by the refresh of the inner list.
                let found = unsafe { self.lanes::<L>(block, lane) };
                too_deep = too_deep.or(found);
            }
        }
        too_deep
    }
}

impl<N, T, C, X> PairForces<'_, N, T, C, X>
where
    N: Normal<3>,
    T: Tangential,
    C: PairConstants,
    X: ExtraForces,
{
    /// The pairs from one lane of a block on.
    #[inline(always)]
    unsafe fn lanes<L: RowLanes>(&mut self, block: usize, lane: usize) -> Option<(u32, u32)> {
        let PairBlock { i, j, slot_i, slot_j } = &self.blocks[block];
        let (i, j, slot_i, slot_j) = (&i[lane..], &j[lane..], &slot_i[lane..], &slot_j[lane..]);
        let separation = self.periods.nearest(unsafe { L::difference4(self.places, i, j) });
        let (radius_i, radius_j) = self.constants.radii::<L>(block, lane);
        let reach = radius_i + radius_j;
        let squared = separation.norm_squared();
        let nearest = radius_i.max(radius_j) * L::splat(NEAREST);
        let apart = (nearest * nearest).less(squared);
        let touching = L::both(squared.less(reach * reach), apart);
        let too_deep = if L::bits(apart).count_ones() as usize == L::WIDTH {
            None
        } else {
            first_too_deep(L::bits(apart), &i[..L::WIDTH], &j[..L::WIDTH])
        };
        let near = if X::ANY {
            let within = reach + self.extras.reach::<L>((block, lane));
            L::both(squared.less(within * within), apart)
        } else {
            touching
        };
        if !L::any(near) {
            if T::REMEMBERS {
                self.springs[block].relax::<L>(lane);
            }
            if T::SLIPS_IN_PART {
                self.annuli[block].relax::<L>(lane);
            }
            self.extras.relax::<L>((block, lane));
            return too_deep;
        }
        let distance = squared.sqrt();
        let normal = separation * (L::splat(1.0) / distance);
        let bodies = Bodies::Spheres(radius_i, radius_j);
        let [velocity, spin] = unsafe { L::difference_and_sum8(self.motions, i, j) };
        let (closing, step) = (velocity.dot(normal), L::splat(self.step));
        let proximity = Proximity { bodies, distance, overlap: reach - distance, travel: closing * step };
        let at = (block, lane);
        let Hold { contact, indentation, attraction, felt } = self.extras.hold(at, &proximity, touching);
        let overlap = proximity.overlap.only(contact);
        let share = radius_i / reach;
        let arm_i = N::arm(radius_i, overlap, share);
        let arm_j = N::arm(radius_j, overlap, L::splat(1.0) - share);
        // a_i ω_i + a_j ω_j = (a_i + a_j)/2 (ω_i + ω_j) + (a_i - a_j)/2 (ω_i - ω_j)
        let turning = if !T::REMEMBERS {
            Vec3::zero()
        } else if C::ALIKE {
            spin * arm_i
        } else {
            let unequal = unsafe { L::difference_of_second_half(self.motions, i, j) };
            let half = L::splat(0.5);
            spin * ((arm_i + arm_j) * half) + unequal * ((arm_i - arm_j) * half)
        };
        let touch = Touch { normal, overlap: indentation, velocity: velocity + turning.cross(normal) };
        let mut spring = if T::REMEMBERS { self.springs[block].load(lane) } else { Spring::relaxed() };
        let mut annuli = if T::SLIPS_IN_PART { self.annuli[block].load(lane) } else { Annuli::relaxed() };
        let coefficients = self.constants.coefficients::<L>(block, lane);
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
        let moment = if T::REMEMBERS { normal.cross(force).only(contact) } else { Vec3::zero() };
        let (mut torque_i, mut torque_j) = (moment * arm_i, moment * arm_j);
        if X::ANY && T::REMEMBERS {
            let growth = N::growth(indentation);
            let rolling = Rolling {
                normal,
                spin: unsafe { L::difference_of_second_half(self.motions, i, j) },
                elastic: coefficients.normal_stiffness * growth.stiffness * indentation,
                pressing,
                growth,
                step,
            };
            let braking = self.extras.braking(at, &coefficients, &rolling, indentation, contact);
            (torque_i, torque_j) = (torque_i - braking, torque_j + braking);
        }
        if X::ANY {
            let squeezed = self.extras.lubrication(at, &coefficients, proximity.overlap, closing, step);
            force = force + (normal * (attraction - squeezed)).only(near);
        }
        unsafe {
            if C::ALIKE {
                L::add_opposed8(self.loads, slot_i, slot_j, force, torque_i);
            } else {
                L::add_unequal8(self.loads, slot_i, slot_j, force, torque_i, torque_j);
            }
        }
        too_deep
    }
}

/// Two distinct grains among the lanes that are not marked.
#[cold]
fn first_too_deep(apart: u32, i: &[u32], j: &[u32]) -> Option<(u32, u32)> {
    i.iter()
        .zip(j)
        .enumerate()
        .find(|(k, (i, j))| apart & (1 << k) == 0 && i != j)
        .map(|(_, (&i, &j))| (i, j))
}
