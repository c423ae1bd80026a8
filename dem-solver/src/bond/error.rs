//! What may be wrong with bonds.

use thiserror::Error;

/// Why bonds are refused.
#[derive(Debug, PartialEq, Error)]
pub enum BondError {
    /// A bond of a grain that is not there.
    #[error(
        "bond of grains {one} and {other}: grain {missing} does not exist among {grains} grains; bond grains that are inserted at the start, or leave the bond out"
    )]
    MissingGrain {
        /// Identity of one grain.
        one: u64,
        /// Identity of the other.
        other: u64,
        /// That of the two which is missing.
        missing: u64,
        /// Number of grains.
        grains: usize,
    },
    /// A bond of a grain with itself.
    #[error("bond of grains {grain} and {grain}: a grain cannot be bonded to itself; name two grains")]
    WithItself {
        /// Its identity.
        grain: u64,
    },
    /// Two bonds of one pair.
    #[error("bond of grains {one} and {other}: it is there twice; leave one of them out")]
    Twice {
        /// Identity of one grain.
        one: u64,
        /// Identity of the other.
        other: u64,
    },
    /// A bond between centres that coincide or are nowhere.
    #[error(
        "bond of grains {one} and {other}: the distance of their centres is {length} m; it must be positive and finite; insert the grains apart from each other"
    )]
    NoLength {
        /// Identity of one grain.
        one: u64,
        /// Identity of the other.
        other: u64,
        /// Distance of the centres \[m\].
        length: f64,
    },
    /// A bond of a law that is not there.
    #[error(
        "bond of grains {one} and {other}: it follows law {law}, but there are {laws}; state the law, or name one that is stated"
    )]
    MissingLaw {
        /// Identity of one grain.
        one: u64,
        /// Identity of the other.
        other: u64,
        /// Index of the law.
        law: u32,
        /// Number of laws.
        laws: usize,
    },
}
