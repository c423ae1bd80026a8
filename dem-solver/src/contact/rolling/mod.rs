//! Resistance to rolling.

mod cdt;
mod epsd;
mod epsd2;

use super::coefficients::{Coefficients, Growth};
use crate::lanes::{Lanes, Vec3};
use crate::material::PairMaterial;

pub use cdt::Cdt;
pub use epsd::Epsd;
pub use epsd2::Epsd2;

/// What stays constant in the rolling of two bodies as long as they do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RollingConstants<L = f64> {
    /// Coefficient of rolling friction μ_r \[-\].
    pub friction: L,
    /// Effective radius R* \[m\].
    pub effective_radius: L,
    /// Stiffness against rolling, N m times the normal law's unit of growth.
    pub stiffness: L,
    /// Damping of rolling, N m s times the normal law's unit of growth.
    pub damping: L,
}

/// Two bodies that roll on each other.
#[derive(Clone, Copy, Debug)]
pub struct Rolling<L> {
    /// Unit normal n, from the first body to the second.
    pub normal: Vec3<L>,
    /// Spin of the first body relative to the second \[rad/s\]; its part along n is not rolling.
    pub spin: Vec3<L>,
    /// Elastic normal force k_n δ \[N\].
    pub elastic: L,
    /// |F_n| of all normal forces \[N\].
    pub pressing: L,
    /// Growth of stiffness and damping with the overlap.
    pub growth: Growth<L>,
    /// Time since the spring was last moved \[s\].
    pub step: L,
}

/// A law for the torque that resists rolling.
pub trait Resistance {
    /// Whether contacts remember a torque.
    const REMEMBERS: bool;

    /// Stiffness and damping of [`RollingConstants`], with I the inertia of the two bodies about their contact
    /// \[kg m²\].
    fn stiffness_and_damping(
        coefficients: &Coefficients,
        pair: &PairMaterial,
        effective_radius: f64,
        inertia: f64,
    ) -> (f64, f64);

    /// The torque that brakes the first body and drives the second \[N m\]; moves the spring, which holds `torque`.
    fn torque<L: Lanes>(
        constants: &RollingConstants<L>,
        rolling: &Rolling<L>,
        torque: &mut Vec3<L>,
    ) -> Vec3<L>;
}

/// The laws of resistance to rolling that a case can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RollingLaw {
    /// `"cdt"`: [`Cdt`].
    Cdt,
    /// `"epsd"`: [`Epsd`].
    Epsd,
    /// `"epsd2"`: [`Epsd2`].
    Epsd2,
}

impl RollingLaw {
    /// Whether contacts remember a torque.
    pub fn remembers(self) -> bool {
        match self {
            Self::Cdt => Cdt::REMEMBERS,
            Self::Epsd => Epsd::REMEMBERS,
            Self::Epsd2 => Epsd2::REMEMBERS,
        }
    }

    /// The constants of two bodies of effective radius R* \[m\] and inertia I about their contact \[kg m²\].
    pub fn constants(
        self,
        coefficients: &Coefficients,
        pair: &PairMaterial,
        effective_radius: f64,
        inertia: f64,
    ) -> RollingConstants {
        let (stiffness, damping) = match self {
            Self::Cdt => Cdt::stiffness_and_damping(coefficients, pair, effective_radius, inertia),
            Self::Epsd => Epsd::stiffness_and_damping(coefficients, pair, effective_radius, inertia),
            Self::Epsd2 => Epsd2::stiffness_and_damping(coefficients, pair, effective_radius, inertia),
        };
        RollingConstants { friction: pair.rolling_friction, effective_radius, stiffness, damping }
    }

    /// The torque that brakes the first body and drives the second \[N m\]; moves the spring, which holds `torque`.
    #[inline(always)]
    pub fn torque<L: Lanes>(
        self,
        constants: &RollingConstants<L>,
        rolling: &Rolling<L>,
        torque: &mut Vec3<L>,
    ) -> Vec3<L> {
        match self {
            Self::Cdt => Cdt::torque(constants, rolling, torque),
            Self::Epsd => Epsd::torque(constants, rolling, torque),
            Self::Epsd2 => Epsd2::torque(constants, rolling, torque),
        }
    }
}
