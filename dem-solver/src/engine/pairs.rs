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
use crate::lanes::{Kernel, Lanes, Row4, Row8, RowLanes, Vec3, prefetch};

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
        let mut group = [Meeting::default(); GROUP];
        let mut count = 0;
        for block in 0..self.blocks.len() {
            self.prefetch(block + AHEAD);
            for lane in (0..WIDTH).step_by(L::WIDTH) {
                // SAFETY: the rows of a block are rows of the grains, its slots are slots of the chunk's loads:
                // both are made by the refresh of the inner list.
                unsafe {
                    if self.meet::<L>((block, lane), &mut group[count], &mut too_deep) {
                        count += 1;
                    }
                    if count == GROUP {
                        self.work_on::<L>(&mut group);
                        count = 0;
                    }
                }
            }
        }
        // SAFETY: as above.
        unsafe { self.work_on::<L>(&mut group[..count]) };
        too_deep
    }
}

/// Meetings that are worked on together. Short loops keep more of a processor busy than a long one, whose every line
/// waits for a root or a quotient above.
const GROUP: usize = 8;
/// Blocks between asking for rows and their use.
const AHEAD: usize = 16;

/// Pairs side by side of which some are near enough to act on each other.
#[derive(Clone, Copy, Default)]
#[repr(C, align(64))]
struct Meeting {
    /// From the first grain to the second, of length 1.
    normal: Rows3,
    /// Between their centres; of grains that are one and the same, out of reach \[m\].
    distance: Row,
    /// Force on the first grain \[N\].
    force: Rows3,
    /// Torques on both \[N m\]; where all pairs are alike, the first is that on either.
    torque: [Rows3; 2],
    /// Block and lane of the first.
    at: (usize, usize),
}

type Row = [f64; WIDTH];
type Rows3 = [Row; 3];

#[inline(always)]
fn load3<L: Lanes>([x, y, z]: &Rows3) -> Vec3<L> {
    Vec3::load(x, y, z)
}

#[inline(always)]
fn store3<L: Lanes>(vector: Vec3<L>, [x, y, z]: &mut Rows3) {
    vector.x.store(x);
    vector.y.store(y);
    vector.z.store(z);
}

impl<N, T, C, X> PairForces<'_, N, T, C, X>
where
    N: Normal<3>,
    T: Tangential,
    C: PairConstants,
    X: ExtraForces,
{
    /// Asks for the rows of a block's second grains; those of the first are in the order of memory.
    #[inline(always)]
    fn prefetch(&self, block: usize) {
        if let Some(PairBlock { j, slot_j, .. }) = self.blocks.get(block) {
            for lane in 0..WIDTH {
                prefetch(self.places, j[lane]);
                prefetch(self.motions, j[lane]);
                prefetch(self.loads, slot_j[lane]);
            }
        }
    }

    /// Whether any of the pairs from one lane of a block on are near, and how.
    #[inline(always)]
    unsafe fn meet<L: RowLanes>(
        &mut self,
        at: (usize, usize),
        meeting: &mut Meeting,
        too_deep: &mut Option<(u32, u32)>,
    ) -> bool {
        let (block, lane) = at;
        let PairBlock { i, j, .. } = &self.blocks[block];
        let (i, j) = (&i[lane..], &j[lane..]);
        let separation = self.periods.nearest(unsafe { L::difference4(self.places, i, j) });
        let (radius_i, radius_j) = self.constants.radii::<L>(block, lane);
        let reach = radius_i + radius_j;
        let squared = separation.norm_squared();
        let nearest = radius_i.max(radius_j) * L::splat(NEAREST);
        let apart = (nearest * nearest).less(squared);
        if !L::all(apart) {
            *too_deep = too_deep.or(first_too_deep(L::bits(apart), &i[..L::WIDTH], &j[..L::WIDTH]));
        }
        let within = if X::ANY { reach + self.extras.reach::<L>(at) } else { reach };
        if !L::any(L::both(squared.less(within * within), apart)) {
            if T::REMEMBERS {
                self.springs[block].relax::<L>(lane);
            }
            if T::SLIPS_IN_PART {
                self.annuli[block].relax::<L>(lane);
            }
            self.extras.relax::<L>(at);
            return false;
        }
        let distance = squared.sqrt();
        store3(separation * (L::splat(1.0) / distance), &mut meeting.normal);
        L::select(apart, distance, reach + reach).store(&mut meeting.distance);
        meeting.at = at;
        true
    }

    /// What follows for those that are near.
    #[inline(always)]
    unsafe fn work_on<L: RowLanes>(&mut self, group: &mut [Meeting]) {
        for meeting in &mut *group {
            unsafe { self.respond::<L>(meeting) };
        }
        for meeting in group {
            unsafe { self.deliver::<L>(meeting) };
        }
    }

    /// Forces and torques.
    #[inline(always)]
    unsafe fn respond<L: RowLanes>(&mut self, meeting: &mut Meeting) {
        let (at, step) = (meeting.at, L::splat(self.step));
        let (block, lane) = at;
        let PairBlock { i, j, .. } = &self.blocks[block];
        let (i, j) = (&i[lane..], &j[lane..]);
        let normal = load3::<L>(&meeting.normal);
        let distance = L::load(&meeting.distance);
        let (radius_i, radius_j) = self.constants.radii::<L>(block, lane);
        let reach = radius_i + radius_j;
        let touching = distance.less(reach);
        let bodies = Bodies::Spheres(radius_i, radius_j);
        let [velocity, spin] = unsafe { L::difference_and_sum8(self.motions, i, j) };
        let closing = velocity.dot(normal);
        let proximity = Proximity { bodies, distance, overlap: reach - distance, travel: closing * step };
        let Hold { contact, indentation, attraction, felt } = self.extras.hold(at, &proximity, touching);
        let overlap = proximity.overlap.only(contact);
        let share = if C::ALIKE { L::splat(0.5) } else { radius_i / reach };
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
            force = force
                + (normal * (attraction - squeezed)).only(distance.less(reach + self.extras.reach::<L>(at)));
        }
        store3(force, &mut meeting.force);
        store3(torque_i, &mut meeting.torque[0]);
        if !C::ALIKE {
            store3(torque_j, &mut meeting.torque[1]);
        }
    }

    /// Adds them to the loads.
    #[inline(always)]
    unsafe fn deliver<L: RowLanes>(&mut self, meeting: &Meeting) {
        let (block, lane) = meeting.at;
        let PairBlock { slot_i, slot_j, .. } = &self.blocks[block];
        let (slot_i, slot_j) = (&slot_i[lane..], &slot_j[lane..]);
        let (force, torque_i) = (load3::<L>(&meeting.force), load3(&meeting.torque[0]));
        unsafe {
            if C::ALIKE {
                L::add_opposed8(self.loads, slot_i, slot_j, force, torque_i);
            } else {
                let torque_j = load3(&meeting.torque[1]);
                L::add_unequal8(self.loads, slot_i, slot_j, force, torque_i, torque_j);
            }
        }
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
