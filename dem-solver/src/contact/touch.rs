//! The force between two bodies that touch.

use super::coefficients::Coefficients;
use super::normal::Normal;
use super::tangential::{Annuli, Sliding, Spring, Tangential};
use crate::lanes::{Lanes, Vec3};

/// Two bodies in contact.
#[derive(Clone, Copy, Debug)]
pub struct Touch<L> {
    /// Unit normal n, from the first body to the second.
    pub normal: Vec3<L>,
    /// Overlap δ > 0 \[m\].
    pub overlap: L,
    /// Velocity of the first body at the contact relative to the second \[m/s\].
    pub velocity: Vec3<L>,
}

/// What two bodies in contact do to each other.
#[derive(Clone, Copy, Debug)]
pub struct Response<L> {
    /// Force on the first body \[N\].
    pub force: Vec3<L>,
    /// |F_n| of all normal forces \[N\].
    pub pressing: L,
}

/// The forces of a normal law, of an attraction \[N\] and of a tangential law; moves the spring by `step` \[s\].
#[inline(always)]
pub fn touch_force<const D: usize, N: Normal<D>, T: Tangential, L: Lanes>(
    coefficients: &Coefficients<L>,
    touch: &Touch<L>,
    attraction: L,
    (spring, annuli): (&mut Spring<L>, &mut Annuli<L>),
    step: L,
) -> Response<L> {
    let closing = touch.velocity.dot(touch.normal);
    let normal_force = N::force(coefficients, touch.overlap, closing, step) - attraction;
    let pressing = normal_force.max(-normal_force);
    let closing_after = closing - normal_force * coefficients.inverse_mass * step;
    let overlap_ahead = if N::ENDS_STIFF { Some(touch.overlap + closing_after * step) } else { None };
    let sliding = Sliding {
        normal: touch.normal,
        velocity: touch.velocity - touch.normal * closing,
        limit: coefficients.sliding_friction * pressing,
        overlap_ahead,
        step,
    };
    let friction = T::force(coefficients, N::growth(touch.overlap), &sliding, spring, annuli);
    Response { force: friction - touch.normal * normal_force, pressing }
}
