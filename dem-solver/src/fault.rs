//! What may go wrong while grains move. Hot loops record the first fault, the step looks once.

use thiserror::Error;

/// The first thing that went wrong in a step.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Fault {
    /// A velocity or a spin became infinite or not a number.
    #[error("grain {grain}: its velocity or spin is not finite")]
    NotFinite {
        /// Identity of the grain.
        grain: u64,
    },
    /// A grain left the domain, and the case wants the run to stop then.
    #[error("grain {grain}: its centre left the domain at ({}, {}, {}) m", .at[0], .at[1], .at[2])]
    Escaped {
        /// Identity of the grain.
        grain: u64,
        /// Where it was seen.
        at: [f64; 3],
    },
    /// Two centres coincide.
    #[error("grains {one} and {other}: their centres coincide, so that the contact has no direction")]
    Coincident {
        /// Identity of one grain.
        one: u64,
        /// Identity of the other grain.
        other: u64,
    },
    /// A centre lies in a wall.
    #[error(
        "grain {grain}: its centre lies in a surface of wall {wall}, so that the contact has no direction"
    )]
    OnWall {
        /// Identity of the grain.
        grain: u64,
        /// Index of the wall.
        wall: u32,
    },
    /// A contact of two grains is deeper than the smaller radius.
    #[error(
        "grain {grain}: its centre is inside grain {other}: the overlap is {depth:.3} of its radius, the relative speed {speed:.3e} m/s; at most 1 is a contact"
    )]
    TooDeep {
        /// Identity of the smaller grain.
        grain: u64,
        /// Identity of the other.
        other: u64,
        /// Overlap, over the radius of the smaller \[-\].
        depth: f64,
        /// Relative speed \[m/s\].
        speed: f64,
    },
    /// A centre is behind a wall, or would be at the next look.
    #[error(
        "grain {grain}: its centre goes through wall {wall}: the overlap is {depth:.3} of its radius, the speed {speed:.3e} m/s; at most 1 is a contact"
    )]
    ThroughWall {
        /// Identity of the grain.
        grain: u64,
        /// Index of the wall.
        wall: u32,
        /// Overlap, over the radius \[-\].
        depth: f64,
        /// Speed at the contact \[m/s\].
        speed: f64,
    },
}

impl Fault {
    /// What the user can do about it.
    pub fn advice(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "take a smaller substep, or look for forces that are not finite",
            Self::Escaped { .. } => {
                "enlarge grains.domain, close the walls, or set grains.escape = \"remove\""
            }
            Self::Coincident { .. } | Self::OnWall { .. } => {
                "insert grains apart from each other and from walls, take a smaller substep or a stiffer material"
            }
            Self::TooDeep { .. } | Self::ThroughWall { .. } => {
                "take a stiffer material (under a linear law, a characteristic velocity as high as the impacts) or a smaller substep, and insert grains apart"
            }
        }
    }
}
