//! Approximate inverse of the pressure Schur complement.

use super::incidence::{Incidence, for_each_row};
use super::outlet::Outlets;
use crate::element::simplex::dot;
use crate::mesh::Mesh;
use linear::{Amg, AmgOptions, Csr, NullSpace, Pattern, Preconditioner, SparseCholesky};
use std::sync::Arc;

/// The factor is kept while κ has changed by less than this everywhere.
const STALE: f64 = 0.05;
/// Up to so many nodes the Laplacian is factored, above it has a multigrid cycle.
const DIRECT: [usize; 2] = [20_000, 3_000];

/// S⁻¹ ≈ (4/3) μ (ε M_p)⁻¹ + (−∇·κ∇)⁻¹, κ = (ε + r)(ε + e)/(a₀ρε + β) + k (m³ s/kg).
///
/// On an outlet, where the pressure is stated weakly, G 1 = −∮ε N n ≠ 0 and the Laplacian gets G D⁻¹Gᵀ of the constants,
/// κ_a |∮N_a n|²/|N_a|, on its diagonal. 4/3: the viscosity of a gradient field.
///
/// Source: Cahouet and Chabard, *Int. J. Numer. Meth. Fluids* 8 (1988) 869.
pub struct Schur {
    matrix: Csr,
    /// κ at the nodes that the solver was made for; empty before the first.
    mobility: Vec<f64>,
    solver: Option<Solver>,
    enclosed: bool,
}

enum Solver {
    Direct(SparseCholesky),
    Multigrid(Amg),
}

impl Schur {
    /// A solver to be made when κ is known; `enclosed` if the pressure has a free constant.
    pub fn new(pattern: Arc<Pattern>, enclosed: bool) -> Self {
        Self { matrix: Csr::zeros(pattern), mobility: Vec::new(), solver: None, enclosed }
    }

    /// The κ that the solver was made for.
    pub fn mobility(&self) -> &[f64] {
        &self.mobility
    }

    /// Makes the solver for κ at the nodes, unless the present one is near enough.
    ///
    /// # Errors
    /// A κ that is not finite and positive.
    pub fn refresh<const D: usize, const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        incidence: &Incidence<N>,
        outlets: &Outlets<D>,
        mobility: &[f64],
    ) -> Result<(), linear::Error> {
        let near = |(old, new): (&f64, &f64)| (new - old).abs() <= STALE * old.abs();
        let fresh = self.mobility.len() == mobility.len() && self.mobility.iter().zip(mobility).all(near);
        if fresh && self.solver.is_some() {
            return Ok(());
        }
        self.mobility.clear();
        self.mobility.extend_from_slice(mobility);
        self.fill(mesh, incidence, outlets);
        let direct = mesh.node_count() <= DIRECT[D - 2];
        if direct && self.enclosed {
            // Holds the constant, which the right-hand sides have not.
            let slot = self.matrix.pattern().slots(0).start;
            self.matrix.values_mut()[slot] *= 2.0;
        }
        match &mut self.solver {
            Some(Solver::Direct(cholesky)) => cholesky.refresh(&self.matrix)?,
            Some(Solver::Multigrid(amg)) => amg.refresh(&self.matrix)?,
            None if direct => self.solver = Some(Solver::Direct(SparseCholesky::new(&self.matrix)?)),
            None => {
                let null_space = if self.enclosed { NullSpace::Constant } else { NullSpace::Empty };
                let options = AmgOptions { null_space, ..AmgOptions::default() };
                self.solver = Some(Solver::Multigrid(Amg::new(&self.matrix, options)?));
            }
        }
        Ok(())
    }

    /// The Laplacian of κ, taken as its mean in each cell.
    fn fill<const D: usize, const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        incidence: &Incidence<N>,
        outlets: &Outlets<D>,
    ) {
        let pattern = self.matrix.pattern().clone();
        let mobility = &self.mobility;
        let mut openings = vec![[0.0; D]; mesh.node_count()];
        for (node, opening) in outlets.openings() {
            let sum = &mut openings[node as usize];
            *sum = std::array::from_fn(|k| sum[k] + opening[k]);
        }
        for_each_row(&pattern, self.matrix.values_mut(), &mut openings, |row, values, opening| {
            values.fill(0.0);
            for corner in incidence.of(row) {
                let (cell, i) = (corner.cell as usize, corner.local as usize);
                let nodes = mesh.cell_nodes(cell);
                let mean = nodes.iter().map(|&node| mobility[node as usize]).sum::<f64>() / N as f64;
                let gradients = &mesh.gradients()[cell];
                for (j, &entry) in corner.entries.iter().enumerate() {
                    values[entry as usize] += mesh.volumes()[cell] * mean * dot(&gradients[i], &gradients[j]);
                }
            }
            let diagonal = pattern.row(row).partition_point(|&column| (column as usize) < row);
            values[diagonal] += mobility[row] * dot(opening, opening) / mesh.measure()[row];
        });
    }

    /// z ← S⁻¹ r, `viscous` being (4/3) μ/(ε_a |N_a|).
    pub fn apply(&mut self, viscous: &[f64], r: &[f64], z: &mut [f64]) {
        match &mut self.solver {
            Some(Solver::Direct(cholesky)) => {
                z.copy_from_slice(r);
                cholesky.solve_in_place(z);
            }
            Some(Solver::Multigrid(amg)) => amg.apply(r, z),
            None => z.fill(0.0),
        }
        for ((z, r), viscous) in z.iter_mut().zip(r).zip(viscous) {
            *z += viscous * r;
        }
    }
}
