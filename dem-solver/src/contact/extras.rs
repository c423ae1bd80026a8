//! Laws that contacts may have besides normal and tangential force.

use super::cohesion::{CohesionConstants, CohesionLaw, Hold, Proximity};
use super::lubrication::Lubrication;
use super::rolling::{RollingConstants, RollingLaw};
use super::twisting::TwistingLaw;
use crate::lanes::Lanes;

/// The laws of a scene besides normal and tangential force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extras {
    /// How contacts that rub resist rolling, if they do.
    pub rolling: Option<RollingLaw>,
    /// How contacts that rub resist twisting, if they do.
    pub twisting: Option<TwistingLaw>,
    /// What liquid between bodies that come near or part does, if there is any.
    pub lubrication: Option<Lubrication>,
    /// How bodies attract each other that touch or have touched, if they do.
    pub cohesion: Option<CohesionLaw>,
}

impl Extras {
    /// Whether there is any.
    pub fn any(&self) -> bool {
        *self != Self::default()
    }

    /// How two bodies hold together that touch or not; see [`CohesionLaw::hold`].
    #[inline(always)]
    pub fn hold<L: Lanes>(
        self,
        constants: &ExtraConstants<L>,
        proximity: &Proximity<L>,
        touching: L::Mask,
        bridge: &mut L,
    ) -> Hold<L> {
        match self.cohesion {
            Some(law) => law.hold(&constants.cohesion, proximity, touching, bridge),
            None => Hold::none(proximity.overlap, touching),
        }
    }

    /// Largest gap over which two bodies may act on each other \[m\].
    #[inline(always)]
    pub fn reach<L: Lanes>(self, constants: &ExtraConstants<L>) -> L {
        let cut_off = self.lubrication.map_or(0.0, |lubrication| lubrication.cut_off);
        constants.cohesion.reach.max(L::splat(cut_off))
    }

    /// The overlap at which the normal law alone has the contact of two bodies that touch \[m\].
    pub fn indentation(self, constants: &ExtraConstants, overlap: f64) -> f64 {
        self.cohesion.map_or(overlap, |law| law.indentation(&constants.cohesion, overlap))
    }
}

/// What stays constant in them as long as the two bodies do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExtraConstants<L = f64> {
    /// Of the resistance to rolling.
    pub rolling: RollingConstants<L>,
    /// Of the attraction.
    pub cohesion: CohesionConstants<L>,
    /// Of the lubrication: [`Lubrication::strength`] \[N s\].
    pub lubrication: L,
    /// Effective radius R* \[m\].
    pub effective_radius: L,
}
