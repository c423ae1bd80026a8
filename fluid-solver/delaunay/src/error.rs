//! What keeps points from being triangulated.

use std::fmt;

/// What keeps points from being triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// A coordinate is infinite or not a number.
    NotFinite {
        /// Index of the point.
        point: usize,
    },
    /// A coordinate of a point that is put in or moved is 2⁶⁰ times as large as those that were triangulated together.
    TooFar {
        /// Index of the point.
        point: usize,
    },
    /// Points and ranks differ in number.
    Ranks {
        /// Number of points.
        points: usize,
        /// Number of ranks.
        ranks: usize,
    },
    /// More points than indices of 32 bits can tell apart.
    TooMany {
        /// Number of points.
        points: usize,
    },
}

/// Points that one triangulation may have: their cells, counted four times, are numbered with 32 bits.
pub(crate) const MOST_POINTS: usize = 100_000_000;

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { point } => {
                write!(
                    out,
                    "point {point} has a coordinate that is not finite: give every point finite coordinates"
                )
            }
            Self::TooFar { point } => {
                write!(
                    out,
                    "point {point} has a coordinate more than 2^60 times as large as those triangulated together: triangulate all points anew"
                )
            }
            Self::Ranks { points, ranks } => {
                write!(out, "{points} points but {ranks} ranks: give one rank per point")
            }
            Self::TooMany { points } => {
                write!(
                    out,
                    "{points} points in one triangulation, at most {MOST_POINTS} are allowed: coarsen the cloud"
                )
            }
        }
    }
}

impl std::error::Error for Error {}
