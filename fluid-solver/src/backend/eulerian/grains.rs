//! The grains on the mesh: weights, volumes, and the rows they sample.

use super::exchange::{Exchange, Reaction};
use super::flow::{Flow, in_space};
use super::recovery::Recovered;
use crate::deposit::Deposit;
use crate::error::FluidError;
use crate::mesh::Mesh;
use crate::mesh::locate::Locator;
use crate::sample::sample;
use crate::void_fraction::{Grain, NodeKernel, VoidFractionError, own_share, void_fraction};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use std::f64::consts::PI;

/// Void fractions below this are refused: discs and spheres in contact leave more.
const SMALLEST_VOID_FRACTION: f64 = 0.05;
/// Numbers per node that are sampled: u, ∇p, ∇·τ, Du/Dt, ∇×u, ∇(p − p′) with three components each, and ε.
const SAMPLED: usize = 19;

/// The grains placed last.
pub struct GrainsOnMesh<const D: usize> {
    locator: Locator<D>,
    kernel: Option<NodeKernel<D>>,
    /// Smallest and largest diameter that the kernel is made for (m).
    diameters: Option<[f64; 2]>,
    grains: Vec<Grain<D>>,
    hosts: Vec<Option<u32>>,
    /// V_p (m³; m² in 2D).
    volumes: Vec<f64>,
    /// The reactions and the weights.
    pub exchange: Exchange<D>,
    /// ε at the nodes.
    pub void_fraction: Vec<f64>,
    deposit: Deposit<1>,
    fields: Vec<[f64; SAMPLED]>,
    samples: Vec<[f64; SAMPLED]>,
}

impl<const D: usize> GrainsOnMesh<D> {
    /// No grains.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        Self {
            locator: Locator::new(mesh),
            kernel: None,
            diameters: None,
            grains: Vec::new(),
            hosts: Vec::new(),
            volumes: Vec::new(),
            exchange: Exchange::default(),
            void_fraction: vec![1.0; mesh.node_count()],
            deposit: Deposit::default(),
            fields: Vec::new(),
            samples: Vec::new(),
        }
    }

    /// Where points are.
    pub fn locator(&self) -> &Locator<D> {
        &self.locator
    }

    /// The range of diameters that the weights depend on; a checkpoint holds it.
    pub fn diameters(&self) -> Option<&[f64; 2]> {
        self.diameters.as_ref()
    }

    /// Number of grains.
    pub fn count(&self) -> usize {
        self.grains.len()
    }

    /// Makes the kernel for a range of diameters.
    ///
    /// # Errors
    /// A range that is not positive and finite.
    pub fn prepare<const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        range: Option<[f64; 2]>,
    ) -> Result<(), FluidError> {
        self.kernel = match range {
            None => None,
            Some([smallest, largest]) => Some(NodeKernel::new(mesh, smallest..=largest)?),
        };
        self.diameters = range;
        Ok(())
    }

    /// Takes other grains: widens the kernel's range of diameters where theirs needs it.
    ///
    /// # Errors
    /// A diameter that is not positive and finite.
    pub fn admit<const N: usize>(&mut self, mesh: &Mesh<D, N>, rows: &[GrainRow]) -> Result<(), FluidError> {
        self.hosts.clear();
        let smallest = rows.iter().map(|row| 2.0 * row.radius).fold(f64::INFINITY, f64::min);
        let largest = rows.iter().map(|row| 2.0 * row.radius).fold(f64::NEG_INFINITY, f64::max);
        let range = match self.diameters {
            _ if rows.is_empty() => return Ok(()),
            Some([low, high]) if low <= smallest && largest <= high => return Ok(()),
            Some([low, high]) => [low.min(smallest), high.max(largest)],
            None => [smallest, largest],
        };
        self.prepare(mesh, Some(range))
    }

    /// Places the grains: weights and ε.
    ///
    /// # Errors
    /// A position that is not finite, a diameter that was not admitted, ε below its floor.
    pub fn place<const N: usize>(&mut self, mesh: &Mesh<D, N>, rows: &[GrainRow]) -> Result<(), FluidError> {
        self.grains.clear();
        self.grains.extend(rows.iter().map(|row| Grain {
            position: std::array::from_fn(|k| row.position[k]),
            diameter: 2.0 * row.radius,
        }));
        self.volumes.clear();
        self.volumes.extend(rows.iter().map(|row| match D {
            2 => PI * row.radius.powi(2),
            _ => 4.0 / 3.0 * PI * row.radius.powi(3),
        }));
        let weights = self.exchange.weights_mut();
        if let Some(kernel) = &self.kernel {
            kernel.weigh(mesh, &self.locator, &self.grains, &mut self.hosts, weights)?;
        }
        let (volumes, measure) = (&self.volumes, mesh.measure());
        let fields = &mut self.void_fraction;
        void_fraction(weights, volumes, measure, SMALLEST_VOID_FRACTION, &mut self.deposit, fields).map_err(
            |fault| match fault {
                VoidFractionError::BelowFloor { node, value, floor } => {
                    let position = in_space(&mesh.nodes()[node]);
                    FluidError::VoidFraction { node, position, value, floor }
                }
                other => other.into(),
            },
        )
    }

    /// Takes the reactions, those of a slab of `depth` (m) in 2D.
    pub fn react(&mut self, reactions: &[ReactionRow], depth: f64) {
        self.exchange.react(reactions.iter().zip(&self.volumes).map(|(row, &volume)| Reaction {
            coefficient: row.exchange_coefficient / depth,
            target: std::array::from_fn(|k| row.target_velocity[k]),
            force: std::array::from_fn(|k| row.force[k] / depth),
            relayed_volume: row.relayed_volume / depth,
            volume,
            inverse_mass: row.inverse_mass * depth,
        }));
    }

    /// Samples the fields at all grains.
    pub fn sample<const N: usize>(&mut self, flow: &Flow<D, N>, recovered: &[Recovered<D>]) {
        self.fields.clear();
        let velocity = flow.state().velocity.iter();
        self.fields.extend(velocity.zip(recovered).zip(&self.void_fraction).map(|((u, r), void)| {
            let vectors = [
                in_space(u),
                in_space(&r.pressure_gradient),
                in_space(&r.stress_divergence),
                in_space(&r.acceleration),
                r.vorticity,
                in_space(&r.gradient_change),
            ];
            std::array::from_fn(|k| if k < SAMPLED - 1 { vectors[k / 3][k % 3] } else { *void })
        }));
        self.samples.resize(self.grains.len(), [0.0; SAMPLED]);
        if self.exchange.weights().grains() > 0 {
            sample(self.exchange.weights(), &self.fields, &mut self.samples);
        }
    }

    /// The row of a grain, that of a slab of `depth` (m) in 2D; density 0 outside the fluid.
    pub fn row<const N: usize>(&self, row: usize, flow: &Flow<D, N>, depth: f64) -> SampleRow {
        let (measure, properties) = (flow.mesh().measure(), flow.properties());
        let weights = self.exchange.weights();
        if weights.row(row).0.is_empty() {
            return SampleRow::default();
        }
        let values = &self.samples[row];
        let vector = |first: usize| [values[first], values[first + 1], values[first + 2]];
        SampleRow {
            velocity: vector(0),
            pressure_gradient: vector(3),
            viscous_stress_divergence: vector(6),
            acceleration: vector(9),
            vorticity: vector(12),
            void_fraction: values[SAMPLED - 1],
            kernel_width: weights.width(row),
            own_share: own_share(weights, row, self.volumes[row], measure),
            density: properties.density,
            viscosity: properties.viscosity,
            relayed_force: vector(15).map(|slope| depth * self.exchange.relayed_volume(row) * slope),
        }
    }
}
