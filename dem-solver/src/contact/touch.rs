//! The force between two bodies that touch.

use super::coefficients::Coefficients;
use super::normal::Normal;
use super::tangential::{Sliding, Spring, Tangential};
use crate::vector::Vector;

/// Two bodies in contact.
#[derive(Clone, Copy, Debug)]
pub struct Touch<const D: usize> {
    /// Unit normal n, from the first body to the second.
    pub normal: Vector<D>,
    /// Overlap δ > 0 \[m\].
    pub overlap: f64,
    /// Velocity of the first body at the contact relative to the second \[m/s\].
    pub velocity: Vector<D>,
}

/// Force on the first body \[N\], by a normal law and a tangential law; moves the spring by `step` \[s\].
#[inline]
pub fn touch_force<const D: usize, N: Normal<D>, T: Tangential<D>>(
    coefficients: &Coefficients,
    touch: &Touch<D>,
    spring: &mut Spring<D>,
    step: f64,
) -> Vector<D> {
    let closing = touch.velocity.dot(&touch.normal);
    let normal_force = N::force(coefficients, touch.overlap, closing, step);
    let sliding = Sliding {
        normal: touch.normal,
        velocity: touch.velocity - touch.normal * closing,
        limit: coefficients.sliding_friction * normal_force.abs(),
        step,
    };
    T::force(coefficients, N::growth(touch.overlap), &sliding, spring) - touch.normal * normal_force
}
