//! Multigrid for the velocity, where viscosity couples more than the next nodes within a step.

use super::incidence::for_each_row;
use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use linear::{Amg, AmgOptions, BlockCsr, Csr, Pattern, Preconditioner};
use std::sync::Arc;

/// A V-cycle for each component on the scalar part of A: the symmetric part of tr(A_ij)/D, with the drag d.
///
/// Nodes whose velocity is prescribed stand alone; at slip walls the result is projected.
pub struct VelocityMultigrid {
    matrix: Csr,
    amg: Option<Amg>,
    right: Vec<f64>,
    solution: Vec<f64>,
}

impl VelocityMultigrid {
    /// To be refreshed before use.
    pub fn new(pattern: Arc<Pattern>) -> Self {
        let rows = pattern.rows();
        Self { matrix: Csr::zeros(pattern), amg: None, right: vec![0.0; rows], solution: vec![0.0; rows] }
    }

    /// Takes new values.
    ///
    /// # Errors
    /// A coefficient that is not finite, a diagonal that is not positive.
    pub fn refresh<const D: usize>(
        &mut self,
        a: &BlockCsr<D>,
        drag: &[f64],
        constraints: &Constraints<D>,
    ) -> Result<(), linear::Error> {
        let pattern = a.pattern().clone();
        let mut prescribed = vec![false; pattern.rows()];
        for node in constraints.nodes().iter().filter(|node| node.free == [[0.0; D]; D]) {
            prescribed[node.node as usize] = true;
        }
        let trace = |slot: usize| (0..D).map(|k| a.blocks()[slot][k][k]).sum::<f64>() / D as f64;
        let mut rows = vec![(); pattern.rows()];
        for_each_row(&pattern, self.matrix.values_mut(), &mut rows, |i, values, ()| {
            for ((value, slot), &j) in values.iter_mut().zip(pattern.slots(i)).zip(pattern.row(i)) {
                let j = j as usize;
                *value = if i == j {
                    trace(slot) + drag[i]
                } else if prescribed[i] || prescribed[j] {
                    0.0
                } else {
                    0.5 * (trace(slot) + pattern.slot(j, i).map_or(0.0, trace))
                };
            }
        });
        match &mut self.amg {
            Some(amg) => amg.refresh(&self.matrix),
            None => {
                self.amg = Some(Amg::new(&self.matrix, AmgOptions::default())?);
                Ok(())
            }
        }
    }

    /// z ← approximate A⁻¹ r on the free components.
    pub fn apply<const D: usize>(
        &mut self,
        constraints: &Constraints<D>,
        r: &[Vector<D>],
        z: &mut [Vector<D>],
    ) {
        let Some(amg) = &mut self.amg else { return z.copy_from_slice(r) };
        for k in 0..D {
            self.right.iter_mut().zip(r).for_each(|(right, r)| *right = r[k]);
            amg.apply(&self.right, &mut self.solution);
            z.iter_mut().zip(&self.solution).for_each(|(z, solution)| z[k] = *solution);
        }
        constraints.project(z);
    }
}
