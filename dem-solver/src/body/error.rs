//! What may be wrong with a clump.

use thiserror::Error;

/// Why a clump is refused.
#[derive(Debug, PartialEq, Error)]
pub enum BodyError {
    /// It is made of nothing.
    #[error("clump: it has no members; state at least one")]
    NoMembers,
    /// A member that is no sphere.
    #[error("clump: member {member} has the radius {radius} m; it must be positive and finite")]
    BadRadius {
        /// Which, counted from 0.
        member: usize,
        /// Its radius \[m\].
        radius: f64,
    },
    /// A member that is nowhere, or off the plane.
    #[error(
        "clump: member {member} lies at ({}, {}, {}) m; all three must be finite, and z = 0 in two dimensions", .at[0], .at[1], .at[2]
    )]
    BadPlace {
        /// Which, counted from 0.
        member: usize,
        /// Its centre \[m\].
        at: [f64; 3],
    },
    /// It weighs nothing.
    #[error("clump: its mass is {mass} kg; it must be positive and finite; state a density or a mass")]
    NoMass {
        /// Its mass \[kg\].
        mass: f64,
    },
    /// No distribution of mass has this inertia.
    #[error(
        "clump: its principal moments of inertia are {}, {} and {} kg m^2; each must be positive and at most the sum of the others", .moments[0], .moments[1], .moments[2]
    )]
    BadInertia {
        /// The moments \[kg m²\].
        moments: [f64; 3],
    },
}
