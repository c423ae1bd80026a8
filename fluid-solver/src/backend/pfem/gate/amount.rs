//! How much fluid.

use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::remesh::energy;
use crate::element::simplex::{Vector, volume_and_areas};

/// An amount of fluid, in 2D per metre of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount<const D: usize> {
    /// Volume (m³).
    pub volume: f64,
    /// Momentum per density (m⁴/s).
    pub momentum: Vector<D>,
    /// Kinetic and potential energy per density (m⁵/s²).
    pub energy: f64,
}

/// What passed the gates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passed<const D: usize> {
    /// Through inlets.
    pub entered: Amount<D>,
    /// Through outlets.
    pub left: Amount<D>,
}

impl<const D: usize> Default for Amount<D> {
    fn default() -> Self {
        Self { volume: 0.0, momentum: [0.0; D], energy: 0.0 }
    }
}

impl<const D: usize> Amount<D> {
    /// What a cloud holds, drops included.
    pub fn of<const N: usize>(cloud: &Cloud<D, N>, acceleration: &Vector<D>) -> Self {
        let energy = energy(cloud);
        let potential: f64 = (0..D).map(|k| -acceleration[k] * energy.moment[k]).sum();
        let mut amount = Self { energy: energy.kinetic + potential, ..Self::default() };
        for cell in &cloud.cells {
            let volume = volume_and_areas(&cloud.vertices(cell)).0;
            amount.volume += volume;
            for &node in cell {
                amount.carry(volume / N as f64, &cloud.velocity[node as usize]);
            }
        }
        for (&drop, v) in cloud.drop.iter().zip(&cloud.velocity) {
            amount.volume += drop;
            amount.carry(drop, v);
        }
        amount
    }

    fn carry(&mut self, volume: f64, v: &Vector<D>) {
        self.momentum = std::array::from_fn(|k| self.momentum[k] + volume * v[k]);
    }

    /// This and more.
    pub fn and(&self, other: &Self) -> Self {
        self.plus(1.0, other)
    }

    /// This without a part of it.
    pub fn less(&self, other: &Self) -> Self {
        self.plus(-1.0, other)
    }

    fn plus(&self, sign: f64, other: &Self) -> Self {
        Self {
            volume: self.volume + sign * other.volume,
            momentum: std::array::from_fn(|k| self.momentum[k] + sign * other.momentum[k]),
            energy: self.energy + sign * other.energy,
        }
    }
}

impl<const D: usize> Passed<D> {
    /// This and more.
    pub fn and(&self, other: &Self) -> Self {
        Self { entered: self.entered.and(&other.entered), left: self.left.and(&other.left) }
    }
}
