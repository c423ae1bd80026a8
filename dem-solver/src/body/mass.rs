//! Mass and inertia of clumps.

use std::f64::consts::PI;

use nalgebra::Matrix3;

use super::Member;
use super::union::{Moments, moments_of_union};
use crate::vector::Vector;

/// How a body resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// m \[kg\].
    pub mass: f64,
    /// Centre of mass \[m\].
    pub centre: Vector<3>,
    /// Inertia tensor about the centre of mass \[kg m²\].
    pub inertia: Matrix3<f64>,
}

impl MassProperties {
    /// Of spheres of one density \[kg/m³\]. Exact where none overlap; where some do, matter that two share counts once,
    /// and the integrals are found to 1e-5.
    pub fn of_spheres(members: &[Member], density: f64) -> Self {
        let moments = if overlap(members) {
            moments_of_union(members, false)
        } else {
            sum(members, |r| {
                let volume = 4.0 / 3.0 * PI * r.powi(3);
                (volume, 0.2 * volume * r * r)
            })
        };
        Self::of(&moments, density)
    }

    /// Of discs in the plane z = 0, in a slab of this depth \[m\]. Only the moment about z has a meaning.
    pub fn of_discs(members: &[Member], density: f64, depth: f64) -> Self {
        let moments = if overlap(members) {
            moments_of_union(members, true)
        } else {
            sum(members, |r| (PI * r * r, 0.25 * PI * r.powi(4)))
        };
        Self::of(&moments, density * depth)
    }

    /// I = ρ (tr S 1 - S), S = ∫ (x - c)(x - c)ᵀ dV.
    fn of(moments: &Moments, density: f64) -> Self {
        let centre = moments.first / moments.volume;
        let central = moments.second - centre * centre.transpose() * moments.volume;
        let inertia = (Matrix3::from_diagonal_element(central.trace()) - central) * density;
        Self { mass: density * moments.volume, centre, inertia }
    }
}

/// Sums over members, whose volume and second moment about a diameter follow from their radius.
fn sum(members: &[Member], shape: impl Fn(f64) -> (f64, f64)) -> Moments {
    let mut moments = Moments::zero();
    for Member { offset, radius } in members {
        let (volume, own) = shape(*radius);
        moments.add(volume, offset, own);
    }
    moments
}

/// Members share matter where they overlap by more than this fraction, and less than 1e-11 of it below.
const TOUCHING: f64 = 1e-6;

/// Whether any two members share matter.
fn overlap(members: &[Member]) -> bool {
    members.iter().enumerate().any(|(k, one)| {
        members[..k].iter().any(|other| {
            let reach = one.radius + other.radius;
            (one.offset - other.offset).norm() < reach * (1.0 - TOUCHING)
        })
    })
}
