//! Approximate inverse of the Schur complement of the pressure.

use super::nodal::Assembly;
use super::topology::Topology;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::dot;
use linear::{Amg, AmgOptions, Csr, Preconditioner, SparseCholesky};

/// Up to so many nodes the pressure matrix is factored, above it has a multigrid cycle.
const DIRECT: [usize; 2] = [20_000, 3_000];

/// The free surface as a spring: its part of the pressure matrix is this many times (θΔt/ρ)/h_n the mass of the face.
const SURFACE: f64 = 2.0;

/// Added to the diagonal of the pressure matrix, relative: a vessel without surface leaves the level of pressure open.
const LEVEL: f64 = 1e-9;

/// P ≈ the Schur complement of the pressure: (θΔt/ρ)[∫∇N_i·∇N_j + Σ_faces (c/h_n) ∫N_i N_j] + V_i/(κΔt).
///
/// The inertia of the stabilisation cancels ∫N_i∇·v inside, where τ = θΔt/ρ; what is left of both is on the surface. For θΔt/ρ
/// stands a mobility, which is more at slivers ([`Preconditioning::refresh`](super::preconditioner::Preconditioning::refresh)).
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

    /// Takes the cells of a pass; `mobility` stands for θΔt/ρ in a cell with these nodes.
    ///
    /// # Errors
    /// A coefficient that is not finite.
    pub fn refresh<const D: usize, const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        assembly: &Assembly<D, N>,
        mobility: impl Fn(usize, &[u32; N]) -> f64,
        compressibility: f64,
    ) -> Result<(), linear::Error> {
        self.matrix.values_mut().fill(0.0);
        for (index, (nodes, cell)) in cloud.cells.iter().zip(&assembly.cells).enumerate() {
            let mobility = mobility(index, nodes);
            for i in 0..N {
                for j in 0..N {
                    let entry = mobility * cell.inverse * dot(&cell.areas[i], &cell.areas[j]);
                    self.matrix.add(nodes[i] as usize, nodes[j] as usize, entry);
                }
            }
        }
        for_each_surface_entry(cloud, assembly, mobility, |i, j, entry| self.matrix.add(i, j, entry));
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
}

impl Preconditioner for Pressure {
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

/// Calls `visit` with i, j and ∫(2m/h_n)N_i N_j over each face of the free surface, m being the mobility of its cell.
pub fn for_each_surface_entry<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    assembly: &Assembly<D, N>,
    mobility: impl Fn(usize, &[u32; N]) -> f64,
    mut visit: impl FnMut(usize, usize, f64),
) {
    cloud.for_each_free_face(|index, opposite| {
        let (nodes, cell) = (&cloud.cells[index], &assembly.cells[index]);
        let square = dot(&cell.areas[opposite], &cell.areas[opposite]);
        let entry = SURFACE * mobility(index, nodes) * cell.inverse * square / (D + 1) as f64;
        for i in (0..N).filter(|&i| i != opposite) {
            for j in (0..N).filter(|&j| j != opposite) {
                let twice = if i == j { 2.0 } else { 1.0 };
                visit(nodes[i] as usize, nodes[j] as usize, twice * entry);
            }
        }
    });
}
