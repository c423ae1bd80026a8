//! Corrections of the pressure, a fixed number of them.

use super::{Correct, Iterate, Verdict};
use crate::backend::pfem::flow::krylov::StepOperator;
use crate::backend::pfem::flow::preconditioner::{Preconditioning, StepPreconditioner};
use linear::Preconditioner;

/// Corrections in a step: a wave whose surface is that of the predictor, or of one correction, grows without bound.
const CORRECTIONS: u64 = 3;
/// The most passes of a step: each beyond the corrections is for nodes that met a wall.
const PASSES: u64 = 10;

/// What preconditions the whole system, applied once a pass: v* with the pressure of the last one, the change of pressure
/// from ∇·v*, and v with that change.
pub struct FractionalStep;

impl<const D: usize, const N: usize> Correct<D, N> for FractionalStep {
    fn judge(&self, iterate: &Iterate) -> Verdict {
        let corrected = iterate.passes >= CORRECTIONS && iterate.met == 0;
        match iterate.passes {
            _ if corrected || iterate.residual <= iterate.allowed => Verdict::Done,
            PASSES => Verdict::Failed,
            _ => Verdict::Again,
        }
    }

    fn correct(
        &mut self,
        _: &Iterate,
        operator: &StepOperator<'_, D, N>,
        parts: &mut Preconditioning<D>,
        right: &[f64],
        increment: &mut [f64],
    ) -> u64 {
        StepPreconditioner { operator, parts }.apply(right, increment);
        1
    }
}
