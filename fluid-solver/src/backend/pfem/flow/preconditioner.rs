//! Approximate inverse of the system of a pass.

use super::chunks::for_each;
use super::krylov::{StepOperator, split, split_mut};
use super::nodal::{Assembly, Fields};
use super::topology::Topology;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, dot};
use linear::{Amg, AmgOptions, Csr, Preconditioner, SparseCholesky};

/// Up to so many nodes the pressure matrix is factored, above it has a multigrid cycle.
const DIRECT: [usize; 2] = [20_000, 3_000];

/// The free surface as a spring: its part of the pressure matrix is this many times (θΔt/ρ)/h_n the mass of the face.
const SURFACE: f64 = 2.0;

/// Added to the diagonal of the pressure matrix, relative: a vessel without surface leaves the level of pressure open.
const LEVEL: f64 = 1e-9;

/// Viscosity is neglected in the diagonal of momentum below this share of inertia.
const INERT: f64 = 1e-2;

/// P ≈ the Schur complement of the pressure: (θΔt/ρ)[∫∇N_i·∇N_j + Σ_faces (c/h_n) ∫N_i N_j] + V_i/(κΔt).
///
/// The inertia of the stabilisation cancels ∫N_i∇·v inside, where τ = θΔt/ρ; what is left of both is on the surface.
pub struct Pressure {
    matrix: Csr,
    solver: Option<Solver>,
}

enum Solver {
    Direct(SparseCholesky),
    Multigrid(Amg),
}

impl Pressure {
    /// To be refreshed before use.
    pub fn new<const N: usize>(topology: &Topology<N>) -> Self {
        Self { matrix: Csr::zeros(topology.pattern().clone()), solver: None }
    }

    /// Takes the cells of a pass.
    ///
    /// # Errors
    /// A coefficient that is not finite.
    pub fn refresh<const D: usize, const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        assembly: &Assembly<D, N>,
        mobility: f64,
        compressibility: f64,
    ) -> Result<(), linear::Error> {
        self.matrix.values_mut().fill(0.0);
        for (nodes, cell) in cloud.cells.iter().zip(&assembly.cells) {
            for i in 0..N {
                for j in 0..N {
                    let entry = mobility * cell.inverse * dot(&cell.areas[i], &cell.areas[j]);
                    self.matrix.add(nodes[i] as usize, nodes[j] as usize, entry);
                }
            }
        }
        cloud.for_each_free_face(|index, opposite| {
            let (nodes, cell) = (&cloud.cells[index], &assembly.cells[index]);
            let square = dot(&cell.areas[opposite], &cell.areas[opposite]);
            let entry = SURFACE * mobility * cell.inverse * square / (D + 1) as f64;
            for i in (0..N).filter(|&i| i != opposite) {
                for j in (0..N).filter(|&j| j != opposite) {
                    let twice = if i == j { 2.0 } else { 1.0 };
                    self.matrix.add(nodes[i] as usize, nodes[j] as usize, twice * entry);
                }
            }
        });
        for (node, volume) in assembly.volumes.iter().enumerate() {
            let diagonal = self.matrix.get(node, node);
            let more = if diagonal > 0.0 { compressibility * volume + LEVEL * diagonal } else { 1.0 };
            self.matrix.add(node, node, more);
        }
        match &mut self.solver {
            Some(Solver::Direct(cholesky)) => cholesky.refresh(&self.matrix),
            Some(Solver::Multigrid(amg)) => amg.refresh(&self.matrix),
            None if cloud.place.len() <= DIRECT[D - 2] => {
                self.solver = Some(Solver::Direct(SparseCholesky::new(&self.matrix)?));
                Ok(())
            }
            None => {
                self.solver = Some(Solver::Multigrid(Amg::new(&self.matrix, AmgOptions::default())?));
                Ok(())
            }
        }
    }

    /// z ← P⁻¹ r.
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        match &mut self.solver {
            Some(Solver::Direct(cholesky)) => {
                z.copy_from_slice(r);
                cholesky.solve_in_place(z);
            }
            Some(Solver::Multigrid(amg)) => amg.apply(r, z),
            None => z.copy_from_slice(r),
        }
    }
}

/// What the preconditioner writes to.
#[derive(Debug, Default)]
pub struct Scratch<const D: usize> {
    /// Diagonal of momentum (kg/s).
    pub diagonal: Vec<f64>,
    /// (4/3) μ/V_i.
    pub viscous: Vec<f64>,
    pub momentum: Vec<Vector<D>>,
    pub volume: Vec<f64>,
    pub nothing: Vec<f64>,
}

impl<const D: usize> Scratch<D> {
    /// Takes the cells of a pass.
    pub fn refresh<const N: usize>(
        &mut self,
        topology: &Topology<N>,
        assembly: &Assembly<D, N>,
        inertia: f64,
    ) {
        let nodes = assembly.volumes.len();
        self.diagonal.resize(nodes, 0.0);
        self.viscous.resize(nodes, 0.0);
        self.momentum.resize(nodes, [0.0; D]);
        self.volume.resize(nodes, 0.0);
        self.nothing.resize(nodes, 0.0);
        for_each(&mut self.diagonal, |node, diagonal| {
            let mut sum = inertia * assembly.volumes[node];
            let inert = sum;
            for corner in topology.corners(node) {
                let cell = &assembly.cells[corner.cell as usize];
                let area = &cell.areas[corner.local as usize];
                sum += (1.0 + 1.0 / 3.0 / D as f64) * cell.viscosity * cell.inverse * dot(area, area);
            }
            // Where viscosity is nothing to inertia, inertia alone makes free fall exact.
            let kept = if sum < (1.0 + INERT) * inert { inert } else { sum };
            *diagonal = if kept > 0.0 { kept } else { 1.0 };
        });
        for_each(&mut self.viscous, |node, viscous| {
            let mut sum = 0.0;
            for corner in topology.corners(node) {
                let cell = &assembly.cells[corner.cell as usize];
                sum += cell.volume.abs() / N as f64 / cell.viscosity.max(f64::MIN_POSITIVE);
            }
            *viscous = if sum > 0.0 && sum.is_finite() { 4.0 / 3.0 / sum } else { 0.0 };
        });
    }
}

/// v* = D⁻¹ r_v; p = (P⁻¹ + (4/3) μ M⁻¹)(r_p − B v*); v = v* + D⁻¹ G p.
pub struct StepPreconditioner<'a, const D: usize, const N: usize> {
    /// What is to be inverted.
    pub operator: &'a StepOperator<'a, D, N>,
    /// For the pressure.
    pub pressure: &'a mut Pressure,
    /// The rest.
    pub scratch: &'a mut Scratch<D>,
}

impl<const D: usize, const N: usize> Preconditioner for StepPreconditioner<'_, D, N> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let ((r_v, r_p), (v, p)) = (split::<D>(r), split_mut::<D>(z));
        let Scratch { diagonal, viscous, momentum, volume, nothing } = &mut *self.scratch;
        let StepOperator { topology, constraints, inertia, scale, .. } = self.operator;
        for_each(v, |node, v| *v = constraints[node].free(&r_v[node].map(|r| r / diagonal[node])));
        let mut scratch = self.operator.scratch.borrow_mut();
        let super::krylov::Scratch { assembly, excess } = &mut *scratch;
        for_each(excess, |node, e| *e = v[node].map(|v| inertia * v));
        let fields = Fields { velocity: v, pressure: nothing, excess };
        assembly.evaluate(topology, fields, 0.0, momentum, volume);
        for_each(volume, |node, volume| *volume = r_p[node] / scale - *volume);
        self.pressure.apply(volume, p);
        for_each(p, |node, p| *p += viscous[node] * volume[node]);
        assembly.pressure_forces(topology, p, momentum);
        for_each(v, |node, v| {
            let change = constraints[node].free(&momentum[node].map(|force| force / diagonal[node]));
            *v = std::array::from_fn(|k| v[k] + change[k]);
        });
    }
}
