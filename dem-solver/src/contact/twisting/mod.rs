//! Resistance to twisting: spin about the normal.

mod marshall;

use super::coefficients::Coefficients;
use super::rolling::Rolling;
use crate::lanes::Lanes;

pub use marshall::Marshall;

/// What a contact remembers of being twisted; all zero before the first touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<L = f64> {
    /// Torque about the normal that the spring holds against the spin of the first body relative to the second \[N m\]; the
    /// same as the second body sees it.
    pub torque: L,
    /// Its stiffness when it was last loaded \[N m/rad\].
    pub stiffness: L,
}

impl<L: Lanes> Twist<L> {
    /// Not twisted.
    #[inline(always)]
    pub fn relaxed() -> Self {
        Self { torque: L::splat(0.0), stiffness: L::splat(0.0) }
    }

    /// The twist where the mask holds, else none.
    #[inline(always)]
    pub fn only(self, mask: L::Mask) -> Self {
        Self { torque: self.torque.only(mask), stiffness: self.stiffness.only(mask) }
    }
}

/// Two bodies that spin on each other about their normal.
#[derive(Clone, Copy, Debug)]
pub struct Twisting<L> {
    /// Spin of the first body relative to the second about the normal \[rad/s\].
    pub rate: L,
    /// Radius of the contact, squared, a² = R* δ \[m²\].
    pub contact_radius_squared: L,
    /// Tangential stiffness k_t \[N/m\].
    pub stiffness: L,
    /// Tangential damping c_t \[N s/m\].
    pub damping: L,
    /// Largest force that friction bears, μ |F_n| \[N\].
    pub limit: L,
    /// Time since the spring was last moved \[s\].
    pub step: L,
}

impl<L: Lanes> Twisting<L> {
    /// The twisting of bodies that spin so, at this indentation and effective radius \[m\].
    #[inline(always)]
    pub fn new(
        coefficients: &Coefficients<L>,
        rolling: &Rolling<L>,
        indentation: L,
        effective_radius: L,
    ) -> Self {
        Self {
            rate: rolling.spin.dot(rolling.normal),
            contact_radius_squared: effective_radius * indentation,
            stiffness: coefficients.tangential_stiffness * rolling.growth.stiffness,
            damping: coefficients.tangential_damping * rolling.growth.damping,
            limit: coefficients.sliding_friction * rolling.pressing,
            step: rolling.step,
        }
    }
}

/// A law for the torque that resists twisting.
pub trait Resistance {
    /// The torque about the normal that brakes the first body and drives the second \[N m\]; moves the spring.
    fn torque<L: Lanes>(twisting: &Twisting<L>, twist: &mut Twist<L>) -> L;
}

/// The laws of resistance to twisting that a case can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TwistingLaw {
    /// `"marshall"`: [`Marshall`].
    Marshall,
}

impl TwistingLaw {
    /// The torque about the normal that brakes the first body and drives the second \[N m\]; moves the spring.
    #[inline(always)]
    pub fn torque<L: Lanes>(self, twisting: &Twisting<L>, twist: &mut Twist<L>) -> L {
        match self {
            Self::Marshall => Marshall::torque(twisting, twist),
        }
    }
}
