//! The laws in lanes: which kernel a scene runs.
//!
//! Nothing here depends on the dimension, so that kernels are compiled once, in this crate: in 2D the loads of
//! contacts grow linearly, whatever their constants.

use std::marker::PhantomData;

use super::block::{AnnuliBlock, ConstantsBlock, PairBlock, PlaneBlock, SpringBlock};
use super::chunk::{Chunk, InnerPairs};
use super::constants::{Alike, PairConstants};
use super::extras::{ChosenExtras, ExtraForces, NoExtras};
use super::loads::ChunkLoads;
use super::near_planes::NearPlanes;
use super::pairs::PairForces;
use super::periods::Periods;
use super::planes::PlaneForces;
use super::springs::Springs;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Normal};
use crate::contact::tangential::{Coulomb, Frictionless, LiggghtsHistory, PartialSlip, Tangential};
use crate::contact::{Extras, NormalLaw};
use crate::lanes::{Backend, Row4, Row8};

/// Normal laws that are kernels of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawInLanes {
    /// [`Hooke`], and what grows like it: [`Hertz`] in 2D and [`crate::contact::normal::Onate`].
    Hooke,
    /// [`Hertz`] of spheres.
    Hertz,
    /// The same with [`PartialSlip`].
    HertzPartialSlip,
    /// [`LiggghtsHooke`].
    LiggghtsHooke,
    /// [`LiggghtsHertz`].
    LiggghtsHertz,
}

impl NormalLaw {
    /// The kernel of this law; nothing where nothing touches.
    pub fn in_lanes<const D: usize>(&self) -> Option<LawInLanes> {
        match self {
            Self::Hertz(_) if D == 3 => Some(LawInLanes::Hertz),
            Self::HertzPartialSlip(_) => Some(LawInLanes::HertzPartialSlip),
            Self::Hooke(_) | Self::Hertz(_) | Self::Onate(_) => Some(LawInLanes::Hooke),
            Self::LiggghtsHooke(_) => Some(LawInLanes::LiggghtsHooke),
            Self::LiggghtsHertz(_) => Some(LawInLanes::LiggghtsHertz),
            Self::None => None,
        }
    }
}

/// What the kernels of a step read.
pub struct Kernels<'a> {
    /// The normal law.
    pub law: LawInLanes,
    /// Whether any pair has friction.
    pub rubs: bool,
    /// The laws besides normal and tangential force.
    pub extras: Extras,
    /// The lanes.
    pub backend: Backend,
    /// Places of all grains.
    pub places: &'a [Row4],
    /// Motions of all grains.
    pub motions: &'a [Row8],
    /// The planes, as [`super::Planes::rows`].
    pub planes: &'a [Row4],
    /// Periodic axes.
    pub periods: &'a Periods,
    /// What all pairs share, if they do.
    pub alike: Option<Alike>,
    /// Time since springs were last moved \[s\].
    pub step: f64,
}

/// Calls a method with the law's types.
macro_rules! by_law {
    ($self:ident.$method:ident($($argument:expr),*)) => {
        match ($self.law, $self.rubs) {
            (LawInLanes::Hooke, true) => $self.$method::<Hooke, Coulomb>($($argument),*),
            (LawInLanes::Hooke, false) => $self.$method::<Hooke, Frictionless>($($argument),*),
            (LawInLanes::Hertz, true) => $self.$method::<Hertz, Coulomb>($($argument),*),
            (LawInLanes::HertzPartialSlip, true) => $self.$method::<Hertz, PartialSlip>($($argument),*),
            (LawInLanes::Hertz | LawInLanes::HertzPartialSlip, false) => $self.$method::<Hertz, Frictionless>($($argument),*),
            (LawInLanes::LiggghtsHooke, true) => $self.$method::<LiggghtsHooke, LiggghtsHistory>($($argument),*),
            (LawInLanes::LiggghtsHooke, false) => $self.$method::<LiggghtsHooke, Frictionless>($($argument),*),
            (LawInLanes::LiggghtsHertz, true) => $self.$method::<LiggghtsHertz, LiggghtsHistory>($($argument),*),
            (LawInLanes::LiggghtsHertz, false) => $self.$method::<LiggghtsHertz, Frictionless>($($argument),*),
        }
    };
}

impl Kernels<'_> {
    /// Adds the forces of a chunk's pairs to its loads; finds two grains of which one holds the centre of the other, if any
    /// do.
    pub fn between_grains(&self, chunk: &mut Chunk, loads: &mut [Row8]) -> Option<(u32, u32)> {
        by_law!(self.pairs_by_law(chunk, loads))
    }

    /// Adds the forces of planes to a chunk's loads; whether a centre is behind a plane.
    pub fn on_planes(&self, chunk: &mut Chunk, loads: &mut ChunkLoads) -> bool {
        chunk.planes.count > 0 && by_law!(self.planes_by_law(chunk, loads))
    }

    fn pairs_by_law<N: Normal<3>, T: Tangential>(
        &self,
        chunk: &mut Chunk,
        loads: &mut [Row8],
    ) -> Option<(u32, u32)> {
        let InnerPairs { blocks, springs, constants, extras, .. } = &mut chunk.inner;
        let (constants, laws) = (constants.as_slice(), self.extras);
        let Springs { forces, torques, bridges, twists, annuli } = springs;
        let springs = (forces.as_mut_slice(), annuli.as_mut_slice());
        match self.alike {
            Some(alike) => self.pairs::<N, T, _, _>(blocks, springs, alike, NoExtras, loads),
            None if laws.any() => {
                let extras = ChosenExtras { laws, constants: extras, torques, bridges, twists };
                self.pairs::<N, T, _, _>(blocks, springs, constants, extras, loads)
            }
            None => self.pairs::<N, T, _, _>(blocks, springs, constants, NoExtras, loads),
        }
    }

    fn pairs<N: Normal<3>, T: Tangential, C: PairConstants, X: ExtraForces>(
        &self,
        blocks: &[PairBlock],
        (springs, annuli): (&mut [SpringBlock], &mut [AnnuliBlock]),
        constants: C,
        extras: X,
        loads: &mut [Row8],
    ) -> Option<(u32, u32)> {
        self.backend.run(PairForces::<N, T, C, X> {
            places: self.places,
            motions: self.motions,
            blocks,
            springs,
            annuli,
            constants,
            extras,
            loads,
            periods: self.periods,
            step: self.step,
            laws: PhantomData,
        })
    }

    fn planes_by_law<N: Normal<3>, T: Tangential>(&self, chunk: &mut Chunk, loads: &mut ChunkLoads) -> bool {
        let NearPlanes { blocks, springs, constants, extras, .. } = &mut chunk.planes;
        let Springs { forces, torques, bridges, twists, annuli } = springs;
        let springs = (forces.as_mut_slice(), annuli.as_mut_slice());
        let laws = self.extras;
        if laws.any() {
            let extras = ChosenExtras { laws, constants: extras, torques, bridges, twists };
            self.planes::<N, T, _>(blocks, springs, constants, extras, loads)
        } else {
            self.planes::<N, T, _>(blocks, springs, constants, NoExtras, loads)
        }
    }

    fn planes<N: Normal<3>, T: Tangential, X: ExtraForces>(
        &self,
        blocks: &[PlaneBlock],
        (springs, annuli): (&mut [SpringBlock], &mut [AnnuliBlock]),
        constants: &[ConstantsBlock],
        extras: X,
        loads: &mut ChunkLoads,
    ) -> bool {
        self.backend.run(PlaneForces::<N, T, X> {
            places: self.places,
            motions: self.motions,
            planes: self.planes,
            blocks,
            springs,
            annuli,
            constants,
            extras,
            loads: &mut loads.slots,
            reactions: &mut loads.planes,
            step: self.step,
            laws: PhantomData,
        })
    }
}
