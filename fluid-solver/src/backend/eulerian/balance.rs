//! The last correction of a step: the sum of the residual.

use super::krylov::{StepOperator, split_mut};
use super::matrices::Part;
use crate::element::simplex::Vector;
use crate::parallel::for_each_node;
use linear::dense::{self, Block};

/// Adds a constant velocity to the free unknowns so that the momentum residual of the free rows sums to zero, and leaves
/// the residual in `rows`: what the linear solver left over is a defect of the momentum balance, however small.
pub fn balance_momentum<const D: usize>(
    operator: &StepOperator<'_, D>,
    velocity: &mut [Vector<D>],
    pressure: &[f64],
    rows: &mut [f64],
) {
    let StepOperator { constraints, measure, .. } = operator;
    let (rows, continuity) = split_mut::<D>(rows);
    operator.evaluate(Part::Affine, (velocity, pressure), (&mut *rows, &mut *continuity));
    let defect = sum_of_free(operator, rows);

    let response = response_to_constants(operator);
    // Singular where no node is free: nothing to correct then.
    let Some(inverse) = dense::inverse(&response) else { return };
    let shift = dense::multiply(&inverse, &defect);
    let mut change = vec![shift.map(|component| -component); measure.len()];
    constraints.project(&mut change);
    for (u, change) in velocity.iter_mut().zip(&change) {
        *u = std::array::from_fn(|k| u[k] + change[k]);
    }
    operator.evaluate(Part::Affine, (velocity, pressure), (rows, continuity));
}

/// Σ_i P_i Σ_j (A_ij + d_i δ_ij) P_j, P the projectors on the free components: the sum that constant velocities bring.
fn response_to_constants<const D: usize>(operator: &StepOperator<'_, D>) -> Block<D> {
    let StepOperator { matrices, constraints, measure, .. } = operator;
    let mut projectors = vec![None; measure.len()];
    for node in constraints.nodes() {
        projectors[node.node as usize] = Some(&node.free);
    }
    let mut responses = vec![[[0.0; D]; D]; measure.len()];
    for_each_node(&mut responses, |i, response| {
        let (columns, blocks) = matrices.momentum.row(i);
        let mut add = |block: &Block<D>, j: usize| {
            let block = projectors[j].map_or(*block, |free| dense::product(block, free));
            for (sum, value) in response.as_flattened_mut().iter_mut().zip(block.as_flattened()) {
                *sum += value;
            }
        };
        columns.iter().zip(blocks).for_each(|(&j, block)| add(block, j as usize));
        let resistance = matrices.drag.resistance[i];
        add(&std::array::from_fn(|k| std::array::from_fn(|l| if k == l { resistance } else { 0.0 })), i);
        if let Some(free) = projectors[i] {
            *response = dense::product(free, response);
        }
    });
    responses.iter().fold([[0.0; D]; D], |sum: Block<D>, response| {
        std::array::from_fn(|k| std::array::from_fn(|l| sum[k][l] + response[k][l]))
    })
}

fn sum_of_free<const D: usize>(operator: &StepOperator<'_, D>, rows: &[Vector<D>]) -> Vector<D> {
    let constrained = operator.constraints.sum_of_constrained(rows);
    let all = rows.iter().fold([0.0; D], |sum: Vector<D>, row| std::array::from_fn(|k| sum[k] + row[k]));
    std::array::from_fn(|k| all[k] - constrained[k])
}
