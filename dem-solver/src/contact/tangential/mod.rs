//! Tangential contact laws.

mod coulomb;
mod frictionless;
mod liggghts_history;

use super::coefficients::{Coefficients, Growth};
use crate::vector::Vector;

pub use coulomb::Coulomb;
pub use frictionless::Frictionless;
pub use liggghts_history::LiggghtsHistory;

/// Memory of a rubbing contact; all zero before the first touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Spring<const D: usize> {
    /// Elongation s of the tangential spring, as the first body sees it \[m\].
    pub elongation: Vector<D>,
    /// Its stiffness when it was last loaded \[N/m\].
    pub stiffness: f64,
}

impl<const D: usize> Spring<D> {
    /// The spring of two bodies that do not touch.
    pub fn relaxed() -> Self {
        Self { elongation: Vector::zeros(), stiffness: 0.0 }
    }

    /// Whether the two bodies touched in the last step.
    pub fn is_active(&self) -> bool {
        self.stiffness > 0.0
    }

    /// The spring as the second body sees it.
    pub fn reversed(self) -> Self {
        Self { elongation: -self.elongation, ..self }
    }
}

/// What sliding asks of a tangential law.
#[derive(Clone, Copy, Debug)]
pub struct Sliding<const D: usize> {
    /// Unit normal n, from the first body to the second.
    pub normal: Vector<D>,
    /// Tangential velocity of the first body's surface relative to the second's \[m/s\].
    pub velocity: Vector<D>,
    /// Largest force that friction bears, μ |F_n| \[N\].
    pub limit: f64,
    /// Time since the spring was last moved \[s\].
    pub step: f64,
}

/// A law for the tangential force of two bodies in contact.
pub trait Tangential<const D: usize> {
    /// Whether contacts remember a [`Spring`].
    const REMEMBERS: bool;

    /// The force on the first body \[N\]; moves the spring by one step.
    fn force(
        coefficients: &Coefficients,
        growth: Growth,
        sliding: &Sliding<D>,
        spring: &mut Spring<D>,
    ) -> Vector<D>;
}

/// The vector, cut to this length if it is longer.
#[inline]
fn shortened<const D: usize>(vector: Vector<D>, length: f64) -> Vector<D> {
    let squared = vector.norm_squared();
    if squared > length * length { vector * (length / squared.sqrt()) } else { vector }
}
