//! Laws that contacts may have besides normal and tangential force.

use super::cohesion::CohesionLaw;
use super::rolling::{RollingConstants, RollingLaw};

/// The laws of a scene besides normal and tangential force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extras {
    /// How contacts that rub resist rolling, if they do.
    pub rolling: Option<RollingLaw>,
    /// How bodies that touch cohere, if they do.
    pub cohesion: Option<CohesionLaw>,
}

impl Extras {
    /// Whether there is any.
    pub fn any(&self) -> bool {
        self.rolling.is_some() || self.cohesion.is_some()
    }
}

/// What stays constant in them as long as the two bodies do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExtraConstants<L = f64> {
    /// Of the resistance to rolling.
    pub rolling: RollingConstants<L>,
    /// Density k of cohesive energy \[J/m³\].
    pub cohesion: L,
}
