//! Laws that contacts may have besides normal and tangential force.

use super::cohesion::{CohesionConstants, CohesionLaw, Hold, Proximity};
use super::rolling::{RollingConstants, RollingLaw};
use crate::lanes::Lanes;

/// The laws of a scene besides normal and tangential force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extras {
    /// How contacts that rub resist rolling, if they do.
    pub rolling: Option<RollingLaw>,
    /// How bodies attract each other that touch or have touched, if they do.
    pub cohesion: Option<CohesionLaw>,
}

impl Extras {
    /// Whether there is any.
    pub fn any(&self) -> bool {
        self.rolling.is_some() || self.cohesion.is_some()
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
}

impl<L: Lanes> ExtraConstants<L> {
    /// Largest gap over which the two bodies may act on each other \[m\].
    #[inline(always)]
    pub fn reach(&self) -> L {
        self.cohesion.reach
    }
}
