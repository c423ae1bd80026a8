//! Where the time of remeshing goes.

use crate::backend::Stages;

/// Processor time of remeshing (s).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spent {
    /// The surface is read and shifted, nodes come and go.
    pub management: f64,
    /// The nodes are triangulated.
    pub mesh: f64,
    /// The fluid is told from the void.
    pub recognition: f64,
    /// Voids, slivers and pieces; the fluid becomes the cells.
    pub settling: f64,
    /// Volumes, energy and momentum, before and after.
    pub transfer: f64,
}

impl Spent {
    /// In all (s).
    pub fn total(&self) -> f64 {
        self.management + self.mesh + self.recognition + self.settling + self.transfer
    }

    /// As stages of a step.
    pub fn stages(&self) -> Stages {
        let boundary = self.management + self.recognition + self.settling;
        Stages { mesh: self.mesh, boundary, transfer: self.transfer, ..Stages::default() }
    }
}
