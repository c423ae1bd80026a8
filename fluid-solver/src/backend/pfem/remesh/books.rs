//! What each stage did to the volume and the energy of the fluid.

use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, dot, volume_and_gradients};

/// A sum of changes and of their sizes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// Σ δ.
    pub sum: f64,
    /// Σ |δ|.
    pub absolute: f64,
}

impl Account {
    /// Books a change.
    pub fn add(&mut self, change: f64) {
        self.sum += change;
        self.absolute += change.abs();
    }
}

/// Volume of the cells (m³; m² in 2D), by what changed it. Drops in flight are counted apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VolumeBooks {
    /// Volume at the start.
    pub start: f64,
    /// Volume that there should be: the first one, and what came in through gates since, less what left; with grains also
    /// what is wet of them, less what was when they came.
    pub target: f64,
    /// Volume of the cells at the end of the last remeshing.
    pub cells: f64,
    /// Volume of the drops at the end of the last remeshing.
    pub drops: f64,
    /// The flow moved the nodes.
    pub flow: Account,
    /// Edges of the surface were collapsed and split, nodes landed on walls.
    pub management: Account,
    /// Surfaces crossed: what lay twice is counted once.
    pub overlap: Account,
    /// Gaps closed and voids filled.
    pub merging: Account,
    /// Cells broken off, the drops made of them not deducted.
    pub separation: Account,
    /// Drops taken up.
    pub absorption: Account,
    /// The surface was shifted to restore the target.
    pub correction: Account,
    /// Largest error so far, in parts of the target (or of the start, where more was there).
    pub largest_error: f64,
}

impl VolumeBooks {
    /// Books of a fluid at its start.
    pub fn start<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> Self {
        let (cells, drops) = (volume(cloud), cloud.drop.iter().sum());
        Self { start: cells + drops, target: cells + drops, cells, drops, ..Self::default() }
    }

    /// What is missing of the target (positive) or too much.
    pub fn missing(&self) -> f64 {
        self.target - self.cells - self.drops
    }

    /// Volume too much (positive) or missing, in parts of the target (or of the start, where more was there).
    pub fn error(&self) -> f64 {
        -self.missing() / self.target.max(self.start)
    }
}

/// Energies of the fluid per density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<const D: usize> {
    /// Σ ½ V_i |v_i|², V_i the share of a node in its cells, or its drop: the masses of the flow are at the nodes, and this
    /// is the energy that its steps keep.
    pub kinetic: f64,
    /// Σ V_i x_i = ∫ x dV; the potential energy is −ρ g · of it.
    pub moment: Vector<D>,
}

/// What remeshing in all did to the energies per density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyBooks<const D: usize> {
    /// Change of Σ ½ V_i |v_i|².
    pub kinetic: Account,
    /// Of it what was taken from the relative motion of nodes: what remeshing would otherwise have given in all.
    pub limiter: Account,
    /// Change of ∫ x dV.
    pub moment: [Account; D],
}

impl<const D: usize> Default for EnergyBooks<D> {
    fn default() -> Self {
        Self { kinetic: Account::default(), limiter: Account::default(), moment: [Account::default(); D] }
    }
}

impl<const D: usize> EnergyBooks<D> {
    /// What remeshing has given since the start, kinetic and potential.
    pub fn given(&self, acceleration: &Vector<D>) -> f64 {
        let potential = self.moment.iter().zip(acceleration).map(|(moment, a)| -a * moment.sum);
        self.kinetic.sum + potential.sum::<f64>()
    }

    /// Books the change from one energy to another.
    pub fn add(&mut self, before: &Energy<D>, after: &Energy<D>) {
        self.kinetic.add(after.kinetic - before.kinetic);
        for k in 0..D {
            self.moment[k].add(after.moment[k] - before.moment[k]);
        }
    }
}

/// The books of remeshing; a checkpoint holds them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Books<const D: usize> {
    /// Volume.
    pub volume: VolumeBooks,
    /// Energy.
    pub energy: EnergyBooks<D>,
}

impl<const D: usize> Books<D> {
    /// Books of a fluid at its start.
    pub fn start<const N: usize>(cloud: &Cloud<D, N>) -> Self {
        Self { volume: VolumeBooks::start(cloud), energy: EnergyBooks::default() }
    }
}

/// Volume of the cells.
pub fn volume<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> f64 {
    cloud.cells.iter().map(|cell| volume_and_gradients(&cloud.vertices(cell)).0).sum()
}

/// Writes the volume of each node, its share of its cells and its drop; returns that of all cells.
pub fn volumes<const D: usize, const N: usize>(cloud: &Cloud<D, N>, nodes: &mut Vec<f64>) -> f64 {
    nodes.clone_from(&cloud.drop);
    let mut sum = 0.0;
    for cell in &cloud.cells {
        let volume = volume_and_gradients(&cloud.vertices(cell)).0;
        sum += volume;
        for &node in cell {
            nodes[node as usize] += volume / N as f64;
        }
    }
    sum
}

impl<const D: usize> Energy<D> {
    /// That of nodes with these volumes.
    pub fn of<const N: usize>(cloud: &Cloud<D, N>, nodes: &[f64]) -> Self {
        let mut energy = Self { kinetic: 0.0, moment: [0.0; D] };
        for ((v, x), volume) in cloud.velocity.iter().zip(&cloud.place).zip(nodes) {
            energy.kinetic += 0.5 * volume * dot(v, v);
            (0..D).for_each(|k| energy.moment[k] += volume * x[k]);
        }
        energy
    }

    /// Kinetic and potential.
    pub fn total(&self, acceleration: &Vector<D>) -> f64 {
        self.kinetic - dot(acceleration, &self.moment)
    }
}

/// The volume of fluid between grains at each node, ε_i V_i (m³; m² in 2D).
pub fn volumes_between_grains<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    void_fraction: &[f64],
) -> Vec<f64> {
    let mut nodes = Vec::new();
    volumes(cloud, &mut nodes);
    nodes.iter_mut().zip(void_fraction).for_each(|(volume, void)| *volume *= void);
    nodes
}

/// Energy of the cells and of the drops.
pub fn energy<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> Energy<D> {
    let mut nodes = Vec::new();
    volumes(cloud, &mut nodes);
    Energy::of(cloud, &nodes)
}
