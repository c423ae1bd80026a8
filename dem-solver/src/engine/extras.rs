//! Cohesion and resistance to rolling of the contacts of a list, block by block.

use super::block::{ExtrasBlock, TorqueBlock};
use crate::contact::rolling::Rolling;
use crate::contact::{ExtraConstants, Extras};
use crate::lanes::{Lanes, Vec3};

/// What a kernel asks of the laws besides normal and tangential force, for the contacts from a lane of a block on.
pub trait ExtraForces {
    /// Whether there is any.
    const ANY: bool;

    /// Attraction of spheres at this distance \[N\].
    fn between_spheres<L: Lanes>(&self, at: (usize, usize), radii: (L, L), distance: L) -> L;

    /// Attraction of a sphere at this distance from a wall \[N\].
    fn to_wall<L: Lanes>(&self, at: (usize, usize), radius: L, distance: L) -> L;

    /// Torque that brakes the first bodies \[N m\] where they touch; moves their springs, and relaxes the others.
    fn braking<L: Lanes>(&mut self, at: (usize, usize), rolling: &Rolling<L>, touching: L::Mask) -> Vec3<L>;

    /// Relaxes the springs against rolling.
    fn relax<L: Lanes>(&mut self, at: (usize, usize));
}

/// Nothing but normal and tangential force.
#[derive(Clone, Copy, Debug)]
pub struct NoExtras;

impl ExtraForces for NoExtras {
    const ANY: bool = false;

    #[inline(always)]
    fn between_spheres<L: Lanes>(&self, _: (usize, usize), _: (L, L), _: L) -> L {
        L::splat(0.0)
    }

    #[inline(always)]
    fn to_wall<L: Lanes>(&self, _: (usize, usize), _: L, _: L) -> L {
        L::splat(0.0)
    }

    #[inline(always)]
    fn braking<L: Lanes>(&mut self, _: (usize, usize), _: &Rolling<L>, _: L::Mask) -> Vec3<L> {
        Vec3::zero()
    }

    #[inline(always)]
    fn relax<L: Lanes>(&mut self, _: (usize, usize)) {}
}

/// The laws that a scene chose; the choice is read at run time.
#[derive(Debug)]
pub struct ChosenExtras<'a> {
    /// The laws.
    pub laws: Extras,
    /// Constants of the contacts.
    pub constants: &'a [ExtrasBlock],
    /// What the springs against rolling hold; empty without them.
    pub torques: &'a mut [TorqueBlock],
}

impl ChosenExtras<'_> {
    #[inline(always)]
    fn constants<L: Lanes>(&self, (block, lane): (usize, usize)) -> ExtraConstants<L> {
        self.constants[block].load(lane)
    }
}

impl ExtraForces for ChosenExtras<'_> {
    const ANY: bool = true;

    #[inline(always)]
    fn between_spheres<L: Lanes>(&self, at: (usize, usize), radii: (L, L), distance: L) -> L {
        let Some(law) = self.laws.cohesion else { return L::splat(0.0) };
        self.constants::<L>(at).cohesion * law.area_of_spheres(radii.0, radii.1, distance)
    }

    #[inline(always)]
    fn to_wall<L: Lanes>(&self, at: (usize, usize), radius: L, distance: L) -> L {
        let Some(law) = self.laws.cohesion else { return L::splat(0.0) };
        self.constants::<L>(at).cohesion * law.area_on_wall(radius, distance)
    }

    #[inline(always)]
    fn braking<L: Lanes>(&mut self, at: (usize, usize), rolling: &Rolling<L>, touching: L::Mask) -> Vec3<L> {
        let Some(law) = self.laws.rolling else { return Vec3::zero() };
        let (block, lane) = at;
        let mut held = self.torques.get(block).map_or(Vec3::zero(), |torques| torques.load(lane));
        let torque = law.torque(&self.constants::<L>(at).rolling, rolling, &mut held);
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, held.only(touching));
        }
        torque.only(touching)
    }

    #[inline(always)]
    fn relax<L: Lanes>(&mut self, (block, lane): (usize, usize)) {
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, Vec3::<L>::zero());
        }
    }
}
