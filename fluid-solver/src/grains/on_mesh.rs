//! The grains on the mesh: weights, volumes, and the rows they sample.

use super::exchange::{Exchange, Reaction};
use super::placing::{Placing, ball_volume};
use super::recovery::{Recovered, gradient_changes};
use crate::deposit::Deposit;
use crate::element::simplex::{Vector, in_space};
use crate::error::FluidError;
use crate::mesh::Mesh;
use crate::sample::sample;
use crate::void_fraction::{Grain, VoidFractionError, own_share, void_fraction};
use interface::frames::{GrainRow, ReactionRow, SampleRow};

/// Void fractions below this are refused: discs in contact leave 0.093, spheres more, and kernels see beds up to 8 % denser.
const SMALLEST_VOID_FRACTION: f64 = 0.02;
/// Numbers per node that are sampled: u, ∇p, ∇·τ, Du/Dt, ∇×u, ∇(p − p′) with three components each, ε and γ̇.
const SAMPLED: usize = 20;
/// Where ε and γ̇ are.
const VOID_FRACTION: usize = 18;
const SHEAR_RATE: usize = 19;

/// Forces that grains take from the fluid, all of them in sum (N; N/m in 2D).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken<const D: usize> {
    /// Σ[β_e(u − v*) + R ∇(p − p′)].
    pub drag: Vector<D>,
    /// Σ V(−∇p + ∇·τ).
    pub stress: Vector<D>,
    /// ΣF, what they give.
    pub explicit: Vector<D>,
    /// Sum of the sizes of drag and explicit forces.
    pub scale: f64,
}

/// The fluid that grains are in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    /// Density ρ (kg/m³).
    pub density: f64,
    /// Dynamic viscosity μ that a grain meets (Pa s).
    pub viscosity: f64,
}

/// The grains placed last.
pub struct GrainsOnMesh<const D: usize> {
    grains: Vec<Grain<D>>,
    /// Share of each grain's volume that is in the fluid.
    wetted: Vec<f64>,
    /// Volume of each grain that is in the fluid (m³; m² in 2D).
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
    pub fn new(nodes: usize) -> Self {
        Self {
            grains: Vec::new(),
            wetted: Vec::new(),
            volumes: Vec::new(),
            exchange: Exchange::default(),
            void_fraction: vec![1.0; nodes],
            deposit: Deposit::default(),
            fields: Vec::new(),
            samples: Vec::new(),
        }
    }

    /// Number of grains.
    pub fn count(&self) -> usize {
        self.grains.len()
    }

    /// Volume of all grains that is in the fluid (m³; m² in 2D).
    pub fn wetted_volume(&self) -> f64 {
        linear::vector::sum(&self.volumes)
    }

    /// Places the grains: weights and ε.
    ///
    /// # Errors
    /// A position that is not finite, a diameter that was not expected, ε below its floor.
    pub fn place<const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        rows: &[GrainRow],
        placing: &mut impl Placing<D, N>,
    ) -> Result<(), FluidError> {
        self.grains.clear();
        self.grains.extend(rows.iter().map(|row| Grain {
            position: std::array::from_fn(|k| row.position[k]),
            diameter: 2.0 * row.radius,
        }));
        let weights = self.exchange.weights_mut();
        placing.place(mesh, &self.grains, weights, &mut self.wetted)?;
        self.volumes.clear();
        self.volumes
            .extend(rows.iter().zip(&self.wetted).map(|(row, wetted)| wetted * ball_volume::<D>(row.radius)));
        let (volumes, measure) = (&self.volumes, mesh.measure());
        self.void_fraction.resize(measure.len(), 1.0);
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

    /// What all grains take of the fields recovered; `measure` is that of the nodes when the grains were placed.
    pub fn taken(&self, velocity: &[Vector<D>], recovered: &[Recovered<D>], measure: &[f64]) -> Taken<D> {
        let (drag, explicit, scale) = self.exchange.totals(velocity, &gradient_changes(recovered));
        let mut stress = [0.0; D];
        for (a, recovered) in recovered.iter().enumerate() {
            let solids = (1.0 - self.void_fraction[a]) * measure[a];
            for k in 0..D {
                stress[k] += solids * (recovered.stress_divergence[k] - recovered.pressure_gradient[k]);
            }
        }
        Taken { drag, stress, explicit, scale }
    }

    /// Samples the fields at all grains.
    pub fn sample(&mut self, velocity: &[Vector<D>], recovered: &[Recovered<D>]) {
        self.fields.clear();
        self.fields.extend(velocity.iter().zip(recovered).zip(&self.void_fraction).map(|((u, r), void)| {
            let vectors = [
                in_space(u),
                in_space(&r.pressure_gradient),
                in_space(&r.stress_divergence),
                in_space(&r.acceleration),
                r.vorticity,
                in_space(&r.gradient_change),
            ];
            std::array::from_fn(|k| match k {
                VOID_FRACTION => *void,
                SHEAR_RATE => r.shear_rate,
                _ => vectors[k / 3][k % 3],
            })
        }));
        self.samples.resize(self.grains.len(), [0.0; SAMPLED]);
        if self.exchange.weights().grains() > 0 {
            sample(self.exchange.weights(), &self.fields, &mut self.samples);
        }
    }

    /// u (m/s) and γ̇ (1/s) at a grain.
    pub fn motion(&self, row: usize) -> ([f64; 3], f64) {
        let values = &self.samples[row];
        ([values[0], values[1], values[2]], values[SHEAR_RATE])
    }

    /// The row of a grain, that of a slab of `depth` (m) in 2D; density 0 outside the fluid.
    pub fn row(&self, row: usize, measure: &[f64], medium: Medium, depth: f64) -> SampleRow {
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
            void_fraction: values[VOID_FRACTION],
            wetted_fraction: self.wetted[row],
            kernel_width: weights.width(row),
            own_share: own_share(weights, row, self.volumes[row], measure),
            density: medium.density,
            viscosity: medium.viscosity,
            relayed_force: vector(15).map(|slope| depth * self.exchange.relayed_volume(row) * slope),
        }
    }
}
