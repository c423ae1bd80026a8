//! How a body gives way where its members are pushed.

use nalgebra::Matrix3;

use super::Member;
use crate::vector::Vector;

/// Largest accelerations that a unit force gives the point of a member on which it acts \[1/kg\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mobility {
    /// By a normal force, which points to the member's centre: 1/M + λ(\[o\]ᵀ I⁻¹ \[o\]), o the offset of the centre, \[o\] its
    /// cross product, λ the largest eigenvalue.
    pub normal: f64,
    /// By any force on the surface, at most: 1/M + (√λ + r/√I₁)².
    pub any: f64,
}

impl Mobility {
    /// That of a member of a body of this mass \[kg\] and principal moments, ascending \[kg m²\].
    pub fn of(member: &Member, mass: f64, moments: &[f64; 3]) -> Self {
        let cross = member.offset.cross_matrix();
        let turning =
            cross.transpose() * Matrix3::from_diagonal(&Vector::from(moments.map(f64::recip))) * cross;
        let lever = turning.symmetric_eigenvalues().max().max(0.0).sqrt();
        let to_surface = member.radius / moments[0].sqrt();
        Self { normal: 1.0 / mass + lever.powi(2), any: 1.0 / mass + (lever + to_surface).powi(2) }
    }
}
