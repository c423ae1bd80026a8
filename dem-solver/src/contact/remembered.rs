//! What a contact remembers while the list that knows it is made anew.

use super::history::History;

/// The spring of a touching pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Remembered {
    /// Row of the first grain.
    pub i: u32,
    /// Row of the second grain.
    pub j: u32,
    /// Its spring, and all it remembers besides.
    pub spring: History,
}
