//! How velocity and pressure of a step are found.

mod fractional_step;
mod monolithic;
mod segregated;

use super::krylov::StepOperator;
use super::nodal::Assembly;
use super::preconditioner::Preconditioning;
use crate::backend::pfem::cloud::Cloud;
use fractional_step::FractionalStep;
use monolithic::Monolithic;
use segregated::Segregated;

/// How velocity and pressure of a step are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scheme {
    /// Both at once, until nothing is left of the equations.
    #[default]
    Monolithic,
    /// One after the other until they hardly change, with terms that make each solvable alone: the scheme of the papers.
    Segregated,
    /// A velocity with the old pressure, a correction of the pressure, and the velocity that goes with it, three times.
    FractionalStep,
}

impl Scheme {
    /// What solves by it.
    pub(super) fn solver<const D: usize, const N: usize>(self) -> Box<dyn Correct<D, N>> {
        match self {
            Self::Monolithic => Box::new(Monolithic::new()),
            Self::Segregated => Box::new(Segregated::default()),
            Self::FractionalStep => Box::new(FractionalStep),
        }
    }
}

/// What a scheme decides by: how far the iterate has come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Iterate {
    /// Passes done.
    pub passes: u64,
    /// Norm of what is left of the rows, and the one allowed (N).
    pub residual: f64,
    pub allowed: f64,
    /// Relative change of velocity or pressure in the last pass, whichever is larger.
    pub change: f64,
    /// How many nodes met a wall in the last pass.
    pub met: usize,
    /// Whether the viscosity depends on the rate of shear.
    pub is_plastic: bool,
}

/// What to do with an iterate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// It is the solution.
    Done,
    /// It wants another pass.
    Again,
    /// It will not become one.
    Failed,
}

/// A scheme: passes of residual, correction, new geometry.
pub(super) trait Correct<const D: usize, const N: usize>: Send {
    /// θ of the step, that of the case being `stated`.
    fn implicitness(&self, stated: f64) -> f64 {
        stated
    }

    /// Whether v_n is to be freed of its divergence before the step.
    fn projects(&self) -> bool {
        true
    }

    /// What the pressure matrix is a Laplacian of: (m³ s/kg) of a cell; none for θΔt/ρ.
    fn mobility(&self) -> Option<fn(&super::cell::Cell<D, N>) -> f64> {
        None
    }

    /// Adds rows of volume that only this scheme has.
    fn add_volumes(&self, _: &Cloud<D, N>, _: &Assembly<D, N>, _pressure: &[f64], _volumes: &mut [f64]) {}

    /// Whether the iterate is good enough.
    fn judge(&self, iterate: &Iterate) -> Verdict;

    /// Finds the increments of velocity and pressure that take the rows by `right`; how many linear iterations it took.
    fn correct(
        &mut self,
        iterate: &Iterate,
        operator: &StepOperator<'_, D, N>,
        parts: &mut Preconditioning<D>,
        right: &[f64],
        increment: &mut [f64],
    ) -> u64;
}
