//! Velocity and pressure at once.

use super::{Correct, Iterate, Verdict};
use crate::backend::pfem::flow::krylov::StepOperator;
use crate::backend::pfem::flow::preconditioner::{Preconditioning, StepPreconditioner};
use linear::{FlexibleGmres, Stopping};

/// Linear iterations between restarts, and the most of a pass. The softest directions of a yield stress are as many as there are
/// cells that yield: with 40 between restarts they are found and forgotten for ever.
const ITERATIONS: [usize; 2] = [160, 400];
/// The most passes of a step, with one viscosity and with one that depends on the rate of shear.
const PASSES: [u64; 2] = [20, 60];
/// What a linear solve leaves of the residual that it began with, at most: geometry and viscosity change after it anyway.
const FORCING: [f64; 2] = [0.02, 0.1];

/// Newton's method but for the geometry, by flexible GMRES.
pub struct Monolithic {
    krylov: FlexibleGmres,
}

impl Monolithic {
    pub fn new() -> Self {
        Self { krylov: FlexibleGmres::new(0, ITERATIONS[0]) }
    }
}

impl<const D: usize, const N: usize> Correct<D, N> for Monolithic {
    fn judge(&self, iterate: &Iterate) -> Verdict {
        if iterate.residual <= iterate.allowed {
            Verdict::Done
        } else if iterate.passes < PASSES[usize::from(iterate.is_plastic)] {
            Verdict::Again
        } else {
            Verdict::Failed
        }
    }

    fn correct(
        &mut self,
        iterate: &Iterate,
        operator: &StepOperator<'_, D, N>,
        parts: &mut Preconditioning<D>,
        right: &[f64],
        increment: &mut [f64],
    ) -> u64 {
        let forcing = FORCING[usize::from(iterate.is_plastic)];
        let absolute = (forcing * iterate.residual).max(0.5 * iterate.allowed);
        let stopping = Stopping { relative: 0.0, absolute, iterations: ITERATIONS[1] };
        increment.fill(0.0);
        let mut preconditioner = StepPreconditioner { operator, parts };
        self.krylov.solve(operator, &mut preconditioner, right, increment, stopping).iterations as u64
    }
}
