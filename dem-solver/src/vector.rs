//! Vectors of `D` components, and how they meet the three components of spin and torque.

use crate::lanes::Vec3;

pub use surface::vector::{Spin, Vector, embed, restrict, spin_velocity};

/// Torque r × F of a force that acts at `arm` from the centre.
#[inline]
pub fn moment<const D: usize>(arm: &Vector<D>, force: &Vector<D>) -> Spin {
    embed(arm).cross(&embed(force))
}

/// The vector as the contact laws take it.
#[inline]
pub fn lane(v: &Spin) -> Vec3<f64> {
    Vec3::new(v.x, v.y, v.z)
}

/// A vector of the contact laws.
#[inline]
pub fn unlane(v: Vec3<f64>) -> Spin {
    Spin::new(v.x, v.y, v.z)
}
