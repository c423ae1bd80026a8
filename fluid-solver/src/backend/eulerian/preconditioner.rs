//! Approximate inverse of the system of a step.

use super::krylov::{StepOperator, remove_sum, split, split_mut};
use super::matrices::Matrices;
use super::schur::Schur;
use super::velocity_multigrid::VelocityMultigrid;
use super::velocity_sweep::VelocitySweep;
use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use crate::grains::Compliance;
use crate::mesh::Mesh;
use crate::parallel::for_each_node;
use linear::{Pattern, Preconditioner, vector};
use std::sync::Arc;

/// Above this μ/(a₀ρh²) the velocity has multigrid: the two cost the same there.
const VISCOUS: f64 = 5.0;

/// What resists a change of velocity.
#[derive(Clone, Copy)]
pub struct Resistances<'a> {
    /// a₀ (1/s).
    pub rate: f64,
    /// ρ (kg/m³).
    pub density: f64,
    /// μ (Pa s).
    pub viscosity: f64,
    /// ε at the nodes.
    pub void_fraction: &'a [f64],
    /// β per volume at the nodes (kg/(m³ s)).
    pub drag: &'a [f64],
}

impl Resistances<'_> {
    /// a₀ρε + β at a node (kg/(m³ s)).
    fn at(&self, node: usize) -> f64 {
        self.rate * self.density * self.void_fraction[node] + self.drag[node]
    }

    /// ε²/(a₀ρε + β) at a node (m³ s/kg): the fluid's own mobility.
    pub fn own_mobility(&self, node: usize) -> f64 {
        self.void_fraction[node] * self.void_fraction[node] / self.at(node)
    }

    /// κ = (ε + r)(ε + e)/(a₀ρε + β) + k at the nodes (m³ s/kg), with how the grains give way; empty if no grain acts.
    pub fn mobility(&self, compliance: &[Compliance]) -> Vec<f64> {
        let mobility = |(node, void): (usize, &f64)| {
            let Compliance { relayed, entrained, pressed } =
                compliance.get(node).copied().unwrap_or_default();
            (void + relayed) * (void + entrained) / self.at(node) + pressed
        };
        self.void_fraction.iter().enumerate().map(mobility).collect()
    }
}

/// Nodal spacing (m).
pub fn spacing<const D: usize, const N: usize>(mesh: &Mesh<D, N>) -> f64 {
    (vector::sum(mesh.measure()) / mesh.node_count() as f64).powf(1.0 / D as f64)
}

/// The parts of the approximate inverse.
pub struct Preconditioning<const D: usize> {
    /// For the pressure.
    pub schur: Schur,
    sweep: VelocitySweep<D>,
    multigrid: VelocityMultigrid,
    is_viscous: bool,
    /// Δ (kg/s).
    inertia: Vec<f64>,
    /// (4/3) μ/(ε_a|N_a|).
    viscous: Vec<f64>,
    volumes: Vec<f64>,
    forces: Vec<Vector<D>>,
}

impl<const D: usize> Preconditioning<D> {
    /// To be refreshed before use.
    pub fn new(pattern: &Arc<Pattern>, enclosed: bool) -> Self {
        let nodes = pattern.rows();
        Self {
            schur: Schur::new(pattern.clone(), enclosed),
            sweep: VelocitySweep::new(pattern),
            multigrid: VelocityMultigrid::new(pattern.clone()),
            is_viscous: false,
            inertia: vec![0.0; nodes],
            viscous: vec![0.0; nodes],
            volumes: vec![0.0; nodes],
            forces: vec![[0.0; D]; nodes],
        }
    }

    /// Δ = lumped inertia and drag, or the diagonal where it is larger (kg/s).
    pub fn inertia(&self) -> &[f64] {
        &self.inertia
    }

    /// Takes new matrices, for the velocity.
    ///
    /// # Errors
    /// A coefficient that is not finite or a diagonal that cannot be inverted.
    pub fn refresh<const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        matrices: &Matrices<D>,
        constraints: &Constraints<D>,
        resistance: &Resistances<'_>,
    ) -> Result<(), linear::Error> {
        for (i, &slot) in matrices.pattern.diagonal_slots()?.iter().enumerate() {
            let measure = mesh.measure()[i];
            let block = &matrices.momentum.blocks()[slot as usize];
            let diagonal = (0..D).map(|k| block[k][k]).sum::<f64>() / D as f64;
            self.inertia[i] = (measure * resistance.at(i)).max(diagonal + measure * resistance.drag[i]);
            self.viscous[i] = 4.0 / 3.0 * resistance.viscosity / (resistance.void_fraction[i] * measure);
        }
        let inertia = resistance.rate * resistance.density * spacing(mesh).powi(2);
        self.is_viscous = resistance.viscosity > VISCOUS * inertia;
        if self.is_viscous {
            self.multigrid.refresh(&matrices.momentum, &matrices.drag.resistance, constraints)
        } else {
            self.sweep.refresh(&matrices.momentum, &matrices.drag.resistance, constraints)
        }
    }
}

/// An incomplete block factorisation.
///
/// Where inertia prevails u* = Â⁻¹ r_u, p = Ŝ⁻¹(r_p − Gᵀu*), u = u* + Δ⁻¹ G p, with Δ the lumped inertia and drag and
/// Ŝ ≈ GᵀΔ⁻¹G. Where viscosity does, p = Ŝ⁻¹ r_p, u = Â⁻¹(r_u + G p): no diagonal stands for a Laplacian there.
pub struct StepPreconditioner<'a, const D: usize> {
    /// What is to be inverted.
    pub operator: &'a StepOperator<'a, D>,
    /// The approximate inverses of its blocks.
    pub parts: &'a mut Preconditioning<D>,
}

impl<const D: usize> Preconditioner for StepPreconditioner<'_, D> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let ((r_u, r_p), (u, p)) = (split::<D>(r), split_mut::<D>(z));
        let StepOperator { matrices, constraints, .. } = self.operator;
        if self.parts.is_viscous {
            self.solve_pressure(r_p, None, p);
            for_each_node(&mut self.parts.forces, |i, force| {
                let gradient = matrices.gradient(i, p);
                *force = std::array::from_fn(|k| r_u[i][k] + gradient[k]);
            });
            self.parts.multigrid.apply(constraints, &self.parts.forces, u);
        } else {
            self.parts.sweep.apply(&matrices.momentum, r_u, u);
            self.solve_pressure(r_p, Some(u), p);
            let inertia = &self.parts.inertia;
            for_each_node(u, |i, u| {
                let gradient = matrices.gradient(i, p);
                *u = std::array::from_fn(|k| u[k] + gradient[k] / inertia[i]);
            });
            constraints.project(u);
        }
    }
}

impl<const D: usize> StepPreconditioner<'_, D> {
    /// p ← Ŝ⁻¹(r_p − Gᵀu), r_p being rows of continuity as the operator scales them.
    fn solve_pressure(&mut self, r_p: &[f64], u: Option<&[Vector<D>]>, p: &mut [f64]) {
        let StepOperator { matrices, measure, scale, enclosed, .. } = self.operator;
        let Preconditioning { schur, viscous, volumes, .. } = &mut *self.parts;
        for_each_node(volumes, |i, volume| {
            *volume = r_p[i] / scale - u.map_or(0.0, |u| matrices.divergence(i, u));
        });
        if *enclosed {
            remove_sum(measure, volumes);
        }
        schur.apply(viscous, volumes, p);
        if *enclosed {
            let mean = vector::dot(p, measure) / vector::sum(measure);
            p.iter_mut().for_each(|p| *p -= mean);
        }
    }
}
