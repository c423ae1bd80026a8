//! The last correction of a step: the sum of the residual.

use super::exchange::Part;
use super::krylov::{StepOperator, split_mut};
use crate::element::simplex::Vector;
use linear::dense;

/// Adds a constant velocity to the free unknowns so that the momentum residual of the free rows sums to zero, and leaves
/// the residual in `rows`: what the linear solver left over is a defect of the momentum balance, however small.
pub fn balance_momentum<const D: usize>(
    operator: &StepOperator<'_, D>,
    velocity: &mut [Vector<D>],
    pressure: &[f64],
    rows: &mut [f64],
    scratch: &mut [f64],
) {
    let StepOperator { constraints, measure, .. } = operator;
    let (rows, continuity) = split_mut::<D>(rows);
    operator.evaluate(Part::Affine, (velocity, pressure), (&mut *rows, &mut *continuity));
    let defect = sum_of_free(operator, rows);

    let zero = vec![0.0; measure.len()];
    let mut response = [[0.0; D]; D];
    for direction in 0..D {
        let unit: Vector<D> = std::array::from_fn(|k| if k == direction { 1.0 } else { 0.0 });
        let mut constant = vec![unit; measure.len()];
        constraints.project(&mut constant);
        let (momentum, volume) = split_mut::<D>(scratch);
        operator.evaluate(Part::Linear, (&constant, &zero), (&mut *momentum, volume));
        let sum = sum_of_free(operator, momentum);
        for k in 0..D {
            response[k][direction] = sum[k];
        }
    }
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

fn sum_of_free<const D: usize>(operator: &StepOperator<'_, D>, rows: &[Vector<D>]) -> Vector<D> {
    let constrained = operator.constraints.sum_of_constrained(rows);
    let all = rows.iter().fold([0.0; D], |sum: Vector<D>, row| std::array::from_fn(|k| sum[k] + row[k]));
    std::array::from_fn(|k| all[k] - constrained[k])
}
