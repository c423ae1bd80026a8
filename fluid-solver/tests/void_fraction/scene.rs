//! Meshes with grains on them.

use fluid_solver::deposit::Deposit;
use fluid_solver::mesh::Mesh;
use fluid_solver::mesh::generate::{BoxMesh, Jitter};
use fluid_solver::mesh::locate::Locator;
use fluid_solver::void_fraction::{Grain, NodeKernel, VoidFractionError, Weights, void_fraction};
use std::f64::consts::PI;

pub struct Scene<const D: usize, const N: usize> {
    pub mesh: Mesh<D, N>,
    pub locator: Locator<D>,
    pub kernel: NodeKernel<D>,
    pub hosts: Vec<Option<u32>>,
    pub weights: Weights,
}

impl<const D: usize, const N: usize> Scene<D, N> {
    pub fn new(mesh: Mesh<D, N>, smallest: f64, largest: f64) -> Self {
        let kernel = NodeKernel::new(&mesh, smallest..=largest).unwrap();
        Self { locator: Locator::new(&mesh), mesh, kernel, hosts: Vec::new(), weights: Weights::default() }
    }

    pub fn weigh(&mut self, grains: &[Grain<D>]) -> Result<(), VoidFractionError> {
        self.kernel.weigh(&self.mesh, &self.locator, grains, &mut self.hosts, &mut self.weights)
    }

    /// Void fraction of grains of the given volumes.
    pub fn void_fraction(
        &mut self,
        grains: &[Grain<D>],
        volumes: &[f64],
        floor: f64,
    ) -> Result<Vec<f64>, VoidFractionError> {
        self.weigh(grains)?;
        let mut field = vec![0.0; self.mesh.node_count()];
        let measure = self.mesh.measure();
        void_fraction(&self.weights, volumes, measure, floor, &mut Deposit::default(), &mut field)?;
        Ok(field)
    }
}

pub fn sphere(diameter: f64) -> f64 {
    PI / 6.0 * diameter.powi(3)
}

/// A unit box.
pub fn unit_box<const D: usize, const N: usize>(cells: usize, periodic: bool, jitter: f64) -> Mesh<D, N> {
    let jitter = (jitter > 0.0).then_some(Jitter { fraction: jitter, seed: 5 });
    BoxMesh { lower: [0.0; D], upper: [1.0; D], cells: [cells; D], periodic: [periodic; D], jitter }
        .generate()
        .unwrap()
}

/// Uniform random numbers in `[0, 1)`.
pub fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Grains at random places of the unit box, with diameters between two bounds.
pub fn random_grains<const D: usize>(count: usize, smallest: f64, largest: f64) -> Vec<Grain<D>> {
    let mut next = random(99);
    let grain = |_| Grain {
        position: std::array::from_fn(|_| next()),
        diameter: (smallest + (largest - smallest) * next()).min(largest),
    };
    (0..count).map(grain).collect()
}
