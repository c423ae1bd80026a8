//! What stays constant in a contact as long as the two bodies do.

use crate::lanes::Lanes;

/// Stiffness and damping of a pair before they grow with the overlap, and its friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<L = f64> {
    /// Normal stiffness, N/m times the law's unit of growth.
    pub normal_stiffness: L,
    /// Normal damping, N s/m times the law's unit of growth.
    pub normal_damping: L,
    /// Tangential stiffness.
    pub tangential_stiffness: L,
    /// Tangential damping.
    pub tangential_damping: L,
    /// Coefficient of sliding friction μ \[-\].
    pub sliding_friction: L,
    /// 1/m*, m* the effective mass of the two bodies \[1/kg\].
    pub inverse_mass: L,
}

impl Coefficients {
    /// The same constants in every lane.
    #[inline(always)]
    pub fn splat<L: Lanes>(&self) -> Coefficients<L> {
        Coefficients {
            normal_stiffness: L::splat(self.normal_stiffness),
            normal_damping: L::splat(self.normal_damping),
            tangential_stiffness: L::splat(self.tangential_stiffness),
            tangential_damping: L::splat(self.tangential_damping),
            sliding_friction: L::splat(self.sliding_friction),
            inverse_mass: L::splat(self.inverse_mass),
        }
    }
}

/// How stiffness and damping grow with the overlap: factors on [`Coefficients`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth<L = f64> {
    /// Factor on the stiffnesses.
    pub stiffness: L,
    /// Factor on the dampings.
    pub damping: L,
}

impl<L: Lanes> Growth<L> {
    /// None: a linear contact.
    #[inline(always)]
    pub fn none() -> Self {
        Self { stiffness: L::splat(1.0), damping: L::splat(1.0) }
    }
}
