//! The fluid behind one trait: what the coupling asks of a backend, whatever its mesh does.

pub mod eulerian;
pub mod imposed;
pub mod pfem;
mod stages;

pub use stages::Stages;

use crate::error::FluidError;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use case_io::document::{Backend, Case};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::ledger::FluidLedger;
use interface::message::{Norms, Surface, TooLarge};
use std::path::Path;

/// Whether the fluid feels the grains.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Response {
    /// It gives way to them and takes their reactions.
    TwoWay,
    /// It flows as if they were not there.
    OneWay,
}

/// A window t_n → t_n + Δt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Start t_n \[s\].
    pub time: f64,
    /// Length Δt \[s\].
    pub length: f64,
}

impl Step {
    /// The end t_n + Δt \[s\].
    pub fn end(self) -> f64 {
        self.time + self.length
    }
}

/// What solving an iteration gave.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// For the convergence of the coupling.
    pub norms: Norms,
    /// The fluid's books of the window as this iterate has them.
    pub ledger: FluidLedger,
    /// Linear iterations.
    pub iterations: u64,
}

/// What came of solving an iteration.
#[derive(Clone, Debug)]
pub enum Attempt {
    /// The equations hold.
    Solved(Box<Solution>),
    /// Not with this Δt: the state is to be restored and the window offered anew, shorter.
    TooLarge(TooLarge),
}

impl Attempt {
    /// The solution, if there is one.
    pub fn solved(self) -> Option<Solution> {
        match self {
            Self::Solved(solution) => Some(*solution),
            Self::TooLarge(_) => None,
        }
    }
}

/// The fluid at a point, for probes and series.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointValue {
    /// u \[m/s\].
    pub velocity: [f64; 3],
    /// p \[Pa\].
    pub pressure: f64,
    /// n_f \[-\].
    pub void_fraction: f64,
}

/// A fluid. The order of calls in a window is `save`, then per iteration `project`, `solve`, `prepare_samples`,
/// `sample` for each row, and `restore` before the next iteration or `commit` after the last.
pub trait FluidBackend: Send {
    /// Number of nodes; 0 for a field without a mesh.
    fn nodes(&self) -> u64;

    /// Findings for `coupler check`: sizes and limits, with what binds them.
    fn notes(&self) -> Vec<String>;

    /// The surface of the mesh: what grains may touch; none without a mesh.
    fn surface(&self) -> Option<Surface>;

    /// Largest Δt from the present state \[s\]: a bound of accuracy (Courant number), infinite where none applies.
    fn largest_step(&self) -> f64;

    /// The grains at t_n when there are new, fewer or re-sorted ones: n_f(t_n) is theirs from now on, and their
    /// coming and going is no ∂n_f/∂t. Samples are prepared at their places.
    ///
    /// # Errors
    /// A grain outside the fluid where that is not allowed, n_f below its floor, a non-finite number.
    fn populate(&mut self, time: f64, grains: &[GrainRow]) -> Result<(), FluidError>;

    /// Saves the state.
    fn save(&mut self);

    /// Goes back to the state saved.
    fn restore(&mut self);

    /// Places the grains at t_n + Δt: weights, n_f, ∂n_f/∂t.
    ///
    /// # Errors
    /// As [`FluidBackend::populate`].
    fn project(&mut self, step: Step, grains: &[GrainRow]) -> Result<(), FluidError>;

    /// Solves for u and p at t_n + Δt with the reactions F − β_e(u − v*) of the grains as placed last.
    ///
    /// # Errors
    /// The linear solver does not converge; a non-finite number (which node).
    fn solve(&mut self, step: Step, reactions: &[ReactionRow]) -> Result<Attempt, FluidError>;

    /// Recovers the fields that are sampled, with the present u and p.
    fn prepare_samples(&mut self);

    /// The fluid at row `row` of the grains placed last.
    fn sample(&self, row: usize) -> SampleRow;

    /// Makes the iterate history.
    ///
    /// # Errors
    /// A moved mesh that cannot be made anew.
    fn commit(&mut self, step: Step) -> Result<(), FluidError>;

    /// The fluid at a point; none outside.
    fn at(&self, time: f64, point: [f64; 3]) -> Option<PointValue>;

    /// Height, along the last axis, of the surface above or below a point \[m\]; none where there is no fluid, or no free surface.
    fn elevation(&self, _point: [f64; 3]) -> Option<f64> {
        None
    }

    /// Whether it has a free surface.
    fn has_surface(&self) -> bool {
        false
    }

    /// Where the time went; zeros of a backend that does not tell.
    fn stages(&self) -> Stages {
        Stages::default()
    }

    /// What was gained and lost, by what did it: name with unit, value; for the summary.
    fn audits(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    /// How often something happened, for the summary.
    fn counters(&self) -> Vec<(String, u64)> {
        Vec::new()
    }

    /// Fluid volume, momentum, energies and extremes: name with unit, value.
    fn statistics(&self, time: f64) -> Vec<(&'static str, f64)>;

    /// Writes nodes, cells and fields to `stem` + extension and returns the file; none without a mesh.
    ///
    /// # Errors
    /// The disk's.
    fn write_frame(&self, stem: &Path, compress: bool) -> Result<Option<std::path::PathBuf>, FluidError>;

    /// Adds all that the next window depends on.
    fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a>;

    /// Goes on from a checkpoint.
    ///
    /// # Errors
    /// A checkpoint of another mesh or field.
    fn load_checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), FluidError>;
}

/// The backend of a case; `two_way` if the fluid feels the grains.
///
/// # Errors
/// What the backend refuses in the case or its mesh.
pub fn of(case: &Case, two_way: bool) -> Result<Box<dyn FluidBackend>, FluidError> {
    let fluid = case.document.fluid.as_ref();
    let response = if two_way { Response::TwoWay } else { Response::OneWay };
    match fluid.map(|fluid| (fluid, fluid.backend)) {
        Some((_, Backend::Imposed)) => match imposed::Imposed::of(&case.document) {
            Some(imposed) => Ok(Box::new(imposed)),
            None => Err(case
                .error("fluid.field", "it is missing", "a field", "state velocity and pressure")
                .into()),
        },
        Some((fluid, Backend::Eulerian)) => eulerian::of(case, fluid, response),
        Some((fluid, Backend::Pfem)) => pfem::of(case, fluid, response),
        None => Err(case.error("fluid", "it is missing", "a table", "add [fluid]").into()),
    }
}
