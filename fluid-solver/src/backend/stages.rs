//! Where the time of a backend goes.

use std::iter::Sum;

/// Processor time of the thread that leads, since the start (s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stages {
    /// Nodes are triangulated.
    pub mesh: f64,
    /// The surface is followed: nodes come and go, the fluid is told from the void, surfaces merge and break.
    pub boundary: f64,
    /// Volumes, energy and momentum are carried to the new mesh.
    pub transfer: f64,
    /// Geometry, contacts and the rows of the system.
    pub assembly: f64,
    /// Its approximate inverse and its linear solver.
    pub solve: f64,
}

impl Sum for Stages {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), |sum, part| Self {
            mesh: sum.mesh + part.mesh,
            boundary: sum.boundary + part.boundary,
            transfer: sum.transfer + part.transfer,
            assembly: sum.assembly + part.assembly,
            solve: sum.solve + part.solve,
        })
    }
}
