//! When a window's iterations have converged, and when they never will.
//!
//! A change is held against a reference that has an absolute floor, so that a start from rest converges; both are root
//! mean squares over nodes or grains, so that a floor is a velocity, a pressure, a force, whatever the mesh.

mod force_residual;
mod judge;
mod relative_norm;

pub use force_residual::ForceResidual;
pub use judge::{Judge, Residuals, Verdict};
pub use relative_norm::RelativeNorm;

/// How much a quantity changed in an iteration, and what that is held against.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// Root mean square of the change.
    pub change: f64,
    /// Root mean square of the reference.
    pub reference: f64,
}

/// A measure of convergence.
pub trait Measure {
    /// Its name in reports.
    const NAME: &'static str;
    /// The test in symbols.
    const FORMULA: &'static str;
    /// Where it is published.
    const SOURCE: &'static str;

    /// The change in parts of what is tolerated \[-\]: converged at 1 and below; not a number if the change is not.
    fn residual(&self, change: &Change) -> f64;
}

/// The measures of the program; a window converges when all have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureKind {
    /// [`RelativeNorm`], of velocity and of pressure.
    RelativeNorm,
    /// [`ForceResidual`], of the forces on the grains.
    ForceResidual,
}

impl MeasureKind {
    /// Every measure.
    pub const ALL: &[MeasureKind] = &[MeasureKind::RelativeNorm, MeasureKind::ForceResidual];

    /// Name, formula and source.
    pub fn explain(self) -> [&'static str; 3] {
        match self {
            MeasureKind::RelativeNorm => [RelativeNorm::NAME, RelativeNorm::FORMULA, RelativeNorm::SOURCE],
            MeasureKind::ForceResidual => {
                [ForceResidual::NAME, ForceResidual::FORMULA, ForceResidual::SOURCE]
            }
        }
    }
}
