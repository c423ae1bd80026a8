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
    /// Volume that there should be: the first one, and what came in through inlets since, less what left.
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
    /// ∫ ½ |v|² dV.
    pub kinetic: f64,
    /// ∫ x dV; the potential energy is −ρ g · of it.
    pub moment: Vector<D>,
}

/// What remeshing in all did to the energies per density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyBooks<const D: usize> {
    /// Change of ∫ ½ |v|² dV.
    pub kinetic: Account,
    /// Of it what was taken from the relative motion of nodes: after events what the volume gained brought with it, and in
    /// space whatever remeshing would otherwise have given in all.
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

/// Writes the volume of each cell and of each node, its share of its cells and its drop; returns that of all cells.
pub fn volumes<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    cells: &mut Vec<f64>,
    nodes: &mut Vec<f64>,
) -> f64 {
    cells.clear();
    nodes.clear();
    nodes.extend_from_slice(&cloud.drop);
    for cell in &cloud.cells {
        let volume = volume_and_gradients(&cloud.vertices(cell)).0;
        cells.push(volume);
        for &node in cell {
            nodes[node as usize] += volume / N as f64;
        }
    }
    cells.iter().sum()
}

/// ∫ ½ |v|² dV of the cells (v linear in each) and of the drops, from the volumes of the cells.
pub fn kinetic_energy<const D: usize, const N: usize>(cloud: &Cloud<D, N>, cells: &[f64]) -> f64 {
    let mut kinetic = 0.0;
    for (cell, volume) in cloud.cells.iter().zip(cells) {
        let velocities = cell.map(|node| cloud.velocity[node as usize]);
        let sum: Vector<D> = std::array::from_fn(|k| velocities.iter().map(|v| v[k]).sum());
        let squares: f64 = velocities.iter().map(|v| dot(v, v)).sum();
        kinetic += 0.5 * volume * (dot(&sum, &sum) + squares) / (N * (N + 1)) as f64;
    }
    let drops = cloud.velocity.iter().zip(&cloud.drop);
    kinetic + drops.map(|(v, drop)| 0.5 * drop * dot(v, v)).sum::<f64>()
}

/// ∫ x dV of the cells and the drops, from the volumes of the nodes.
pub fn moment<const D: usize, const N: usize>(cloud: &Cloud<D, N>, nodes: &[f64]) -> Vector<D> {
    std::array::from_fn(|k| cloud.place.iter().zip(nodes).map(|(x, volume)| volume * x[k]).sum())
}

/// Energy of the fluid between grains: of the share ε of the cells, given at the nodes, and of the drops.
pub fn energy_between_grains<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    void_fraction: &[f64],
) -> Energy<D> {
    let (mut cells, mut nodes) = (Vec::new(), Vec::new());
    volumes(cloud, &mut cells, &mut nodes);
    for (cell, volume) in cloud.cells.iter().zip(&mut cells) {
        *volume *= cell.iter().map(|&node| void_fraction[node as usize]).sum::<f64>() / N as f64;
    }
    nodes.iter_mut().zip(void_fraction).for_each(|(volume, void)| *volume *= void);
    Energy { kinetic: kinetic_energy(cloud, &cells), moment: moment(cloud, &nodes) }
}

/// Energy of the cells and of the drops.
pub fn energy<const D: usize, const N: usize>(cloud: &Cloud<D, N>) -> Energy<D> {
    let (mut cells, mut nodes) = (Vec::new(), Vec::new());
    volumes(cloud, &mut cells, &mut nodes);
    Energy { kinetic: kinetic_energy(cloud, &cells), moment: moment(cloud, &nodes) }
}
