//! Smooth bodies.

use super::{Annuli, Sliding, Spring, Tangential};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::{Lanes, Vec3};

/// No tangential force, F_t = 0: for scenes where no pair has friction.
#[derive(Clone, Copy, Debug)]
pub struct Frictionless;

impl Tangential for Frictionless {
    const REMEMBERS: bool = false;

    #[inline(always)]
    fn force<L: Lanes>(
        _: &Coefficients<L>,
        _: Growth<L>,
        _: &Sliding<L>,
        _: &mut Spring<L>,
        _: &mut Annuli<L>,
    ) -> Vec3<L> {
        Vec3::zero()
    }
}
