//! Attraction, lubrication and resistance to rolling and twisting of the contacts of a list, block by block.

use super::block::{BridgeBlock, ExtrasBlock, TorqueBlock, TwistBlock};
use crate::contact::cohesion::{Hold, Proximity};
use crate::contact::rolling::Rolling;
use crate::contact::twisting::{Twist, Twisting};
use crate::contact::{Coefficients, ExtraConstants, Extras};
use crate::lanes::{Lanes, Vec3};

/// What a kernel asks of the laws besides normal and tangential force, for the contacts from a lane of a block on.
pub trait ExtraForces {
    /// Whether there is any.
    const ANY: bool;

    /// Largest gap over which the bodies may act on each other \[m\].
    fn reach<L: Lanes>(&self, at: (usize, usize)) -> L;

    /// How bodies hold together that touch or not; makes and tears what holds them.
    fn hold<L: Lanes>(&mut self, at: (usize, usize), proximity: &Proximity<L>, touching: L::Mask) -> Hold<L>;

    /// Mean force of a step \[s\] by which liquid pushes bodies apart that come nearer at this speed \[m/s\] \[N\].
    fn lubrication<L: Lanes>(
        &self,
        at: (usize, usize),
        coefficients: &Coefficients<L>,
        overlap: L,
        closing: L,
        step: L,
    ) -> L;

    /// Torque that brakes the first bodies \[N m\] where there is contact; moves their springs, and relaxes the others.
    fn braking<L: Lanes>(
        &mut self,
        at: (usize, usize),
        coefficients: &Coefficients<L>,
        rolling: &Rolling<L>,
        indentation: L,
        contact: L::Mask,
    ) -> Vec3<L>;

    /// Relaxes the springs against rolling and twisting, and tears what holds bodies together.
    fn relax<L: Lanes>(&mut self, at: (usize, usize));
}

/// Nothing but normal and tangential force.
#[derive(Clone, Copy, Debug)]
pub struct NoExtras;

impl ExtraForces for NoExtras {
    const ANY: bool = false;

    #[inline(always)]
    fn reach<L: Lanes>(&self, _: (usize, usize)) -> L {
        L::splat(0.0)
    }

    #[inline(always)]
    fn hold<L: Lanes>(&mut self, _: (usize, usize), proximity: &Proximity<L>, touching: L::Mask) -> Hold<L> {
        Hold::none(proximity.overlap, touching)
    }

    #[inline(always)]
    fn lubrication<L: Lanes>(&self, _: (usize, usize), _: &Coefficients<L>, _: L, _: L, _: L) -> L {
        L::splat(0.0)
    }

    #[inline(always)]
    fn braking<L: Lanes>(
        &mut self,
        _: (usize, usize),
        _: &Coefficients<L>,
        _: &Rolling<L>,
        _: L,
        _: L::Mask,
    ) -> Vec3<L> {
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
    /// What holds bodies together; empty where nothing outlasts touch.
    pub bridges: &'a mut [BridgeBlock],
    /// What the springs against twisting hold; empty without them.
    pub twists: &'a mut [TwistBlock],
}

impl ChosenExtras<'_> {
    #[inline(always)]
    fn constants<L: Lanes>(&self, (block, lane): (usize, usize)) -> ExtraConstants<L> {
        self.constants[block].load(lane)
    }

    #[inline(always)]
    fn against_rolling<L: Lanes>(
        &mut self,
        at: (usize, usize),
        rolling: &Rolling<L>,
        contact: L::Mask,
    ) -> Vec3<L> {
        let Some(law) = self.laws.rolling else { return Vec3::zero() };
        let (block, lane) = at;
        let mut held = self.torques.get(block).map_or(Vec3::zero(), |torques| torques.load(lane));
        let torque = law.torque(&self.constants::<L>(at).rolling, rolling, &mut held);
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, held.only(contact));
        }
        torque.only(contact)
    }

    #[inline(always)]
    fn against_twisting<L: Lanes>(
        &mut self,
        (block, lane): (usize, usize),
        normal: Vec3<L>,
        twisting: &Twisting<L>,
        contact: L::Mask,
    ) -> Vec3<L> {
        let Some(law) = self.laws.twisting else { return Vec3::zero() };
        let mut twist = self.twists.get(block).map_or(Twist::relaxed(), |twists| twists.load(lane));
        let torque = law.torque(twisting, &mut twist);
        if let Some(twists) = self.twists.get_mut(block) {
            twists.store(lane, twist.only(contact));
        }
        (normal * torque).only(contact)
    }
}

impl ExtraForces for ChosenExtras<'_> {
    const ANY: bool = true;

    #[inline(always)]
    fn reach<L: Lanes>(&self, at: (usize, usize)) -> L {
        self.laws.reach(&self.constants::<L>(at))
    }

    #[inline(always)]
    fn hold<L: Lanes>(&mut self, at: (usize, usize), proximity: &Proximity<L>, touching: L::Mask) -> Hold<L> {
        let (block, lane) = at;
        let mut bridge = self.bridges.get(block).map_or(L::splat(0.0), |bridges| bridges.load(lane));
        let hold = self.laws.hold(&self.constants(at), proximity, touching, &mut bridge);
        if let Some(bridges) = self.bridges.get_mut(block) {
            bridges.store(lane, bridge);
        }
        hold
    }

    #[inline(always)]
    fn lubrication<L: Lanes>(
        &self,
        at: (usize, usize),
        coefficients: &Coefficients<L>,
        overlap: L,
        closing: L,
        step: L,
    ) -> L {
        let Some(law) = self.laws.lubrication else { return L::splat(0.0) };
        law.push(self.constants::<L>(at).lubrication, coefficients.inverse_mass, -overlap, closing, step)
    }

    #[inline(always)]
    fn braking<L: Lanes>(
        &mut self,
        at: (usize, usize),
        coefficients: &Coefficients<L>,
        rolling: &Rolling<L>,
        indentation: L,
        contact: L::Mask,
    ) -> Vec3<L> {
        let twisting =
            Twisting::new(coefficients, rolling, indentation, self.constants::<L>(at).effective_radius);
        self.against_rolling(at, rolling, contact)
            + self.against_twisting(at, rolling.normal, &twisting, contact)
    }

    #[inline(always)]
    fn relax<L: Lanes>(&mut self, (block, lane): (usize, usize)) {
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, Vec3::<L>::zero());
        }
        if let Some(bridges) = self.bridges.get_mut(block) {
            bridges.store(lane, L::splat(0.0));
        }
        if let Some(twists) = self.twists.get_mut(block) {
            twists.store(lane, Twist::<L>::relaxed());
        }
    }
}
