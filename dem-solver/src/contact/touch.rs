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
    /// Overlap δ > 0, or that of bodies without attraction in a contact as wide \[m\].
    pub overlap: L,
    /// Velocity of the first body at the contact relative to the second \[m/s\].
    pub velocity: Vec3<L>,
}

/// What two bodies in contact do to each other.
#[derive(Clone, Copy, Debug)]
pub struct Response<L> {
    /// Force on the first body \[N\].
    pub force: Vec3<L>,
    /// |F_n| of all normal forces that friction feels \[N\].
    pub pressing: L,
}

/// The forces of a normal law and of a tangential law, with an attraction \[N\] that friction feels and that is not among
/// them; moves the spring by `step` \[s\].
#[inline(always)]
pub fn touch_force<const D: usize, N: Normal<D>, T: Tangential, L: Lanes>(
    coefficients: &Coefficients<L>,
    touch: &Touch<L>,
    felt: L,
    (spring, annuli): (&mut Spring<L>, &mut Annuli<L>),
    step: L,
) -> Response<L> {
    let closing = touch.velocity.dot(touch.normal);
    let push = N::force(coefficients, touch.overlap, closing, step);
    let felt = push - felt;
    let pressing = felt.max(-felt);
    let closing_after = closing - push * coefficients.inverse_mass * step;
    let overlap_ahead = if N::ENDS_STIFF { Some(touch.overlap + closing_after * step) } else { None };
    let sliding = Sliding {
        normal: touch.normal,
        velocity: touch.velocity - touch.normal * closing,
        limit: coefficients.sliding_friction * pressing,
        overlap_ahead,
        step,
    };
    let friction = T::force(coefficients, N::growth(touch.overlap), &sliding, spring, annuli);
    Response { force: friction - touch.normal * push, pressing }
}
