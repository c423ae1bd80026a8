//! Smooth bodies.

use super::{Sliding, Spring, Tangential};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::vector::Vector;

/// No tangential force, F_t = 0: for scenes where no pair has friction.
#[derive(Clone, Copy, Debug)]
pub struct Frictionless;

impl<const D: usize> Tangential<D> for Frictionless {
    const REMEMBERS: bool = false;

    #[inline]
    fn force(_: &Coefficients, _: Growth, _: &Sliding<D>, _: &mut Spring<D>) -> Vector<D> {
        Vector::zeros()
    }
}
