//! Tangential contact laws.

mod annuli;
mod coulomb;
mod frictionless;
mod liggghts_history;
mod partial_slip;

use super::coefficients::{Coefficients, Growth};
use super::twisting::Twist;
use crate::lanes::{Lanes, Vec3};

pub use annuli::{ANNULI, Annuli};
pub use coulomb::Coulomb;
pub use frictionless::Frictionless;
pub use liggghts_history::LiggghtsHistory;
pub use partial_slip::PartialSlip;

/// Memory of a contact; all zero before the first touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Spring<L = f64> {
    /// Force k_t s that the tangential spring holds, as the first body sees it \[N\].
    pub force: Vec3<L>,
    /// Its stiffness k_t when it was last loaded \[N/m\].
    pub stiffness: L,
    /// Torque that the spring against rolling holds \[N m\]; 0 where there is none.
    pub torque: Vec3<L>,
    /// 1 where something that outlasts touch holds the bodies together, else 0.
    pub bridge: L,
    /// What the spring against twisting holds.
    pub twist: Twist<L>,
}

impl<L: Lanes> Spring<L> {
    /// The spring of two bodies that do not touch.
    #[inline(always)]
    pub fn relaxed() -> Self {
        let zero = L::splat(0.0);
        Self {
            force: Vec3::zero(),
            stiffness: zero,
            torque: Vec3::zero(),
            bridge: zero,
            twist: Twist::relaxed(),
        }
    }

    /// The spring where the mask holds, else a relaxed one.
    #[inline(always)]
    pub fn only(self, mask: L::Mask) -> Self {
        Self {
            force: self.force.only(mask),
            stiffness: self.stiffness.only(mask),
            torque: self.torque.only(mask),
            bridge: self.bridge.only(mask),
            twist: self.twist.only(mask),
        }
    }
}

impl Spring {
    /// Whether the two bodies touched in the last step, or something held them together.
    pub fn is_active(&self) -> bool {
        self.stiffness > 0.0 || self.bridge > 0.0
    }

    /// The spring as the second body sees it.
    pub fn reversed(self) -> Self {
        Self { force: -self.force, torque: -self.torque, ..self }
    }

    /// Energy of the tangential spring, (k_t s)²/(2 k_t) \[J\].
    pub fn energy(&self) -> f64 {
        if self.stiffness > 0.0 { 0.5 * self.force.norm_squared() / self.stiffness } else { 0.0 }
    }
}

/// What sliding asks of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct Sliding<L> {
    /// Unit normal n, from the first body to the second.
    pub normal: Vec3<L>,
    /// Tangential velocity of the first body's surface relative to the second's \[m/s\].
    pub velocity: Vec3<L>,
    /// Largest force that friction bears, μ |F_n| \[N\].
    pub limit: L,
    /// Overlap that will be left in the next substep, negative where this is the last one of the contact \[m\]; nothing
    /// where stiffnesses vanish there.
    pub overlap_ahead: Option<L>,
    /// Time since the spring was last moved \[s\].
    pub step: L,
}

/// A law for the tangential force of two bodies in contact.
pub trait Tangential {
    /// Whether contacts remember a [`Spring`].
    const REMEMBERS: bool;
    /// Whether they remember [`Annuli`], too.
    const SLIPS_IN_PART: bool = false;

    /// The force on the first body \[N\]; moves the spring, and annuli if there are any, by one step.
    fn force<L: Lanes>(
        coefficients: &Coefficients<L>,
        growth: Growth<L>,
        sliding: &Sliding<L>,
        spring: &mut Spring<L>,
        annuli: &mut Annuli<L>,
    ) -> Vec3<L>;
}

/// The vector, cut to this length if it is longer.
#[inline(always)]
pub(super) fn shortened<L: Lanes>(vector: Vec3<L>, length: L) -> Vec3<L> {
    let squared = vector.norm_squared();
    let longer = (length * length).less(squared);
    if !L::any(longer) {
        return vector;
    }
    let one = L::splat(1.0);
    vector * L::select(longer, length / L::select(longer, squared, one).sqrt(), one)
}
