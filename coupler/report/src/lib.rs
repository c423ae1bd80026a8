//! Plots, pictures and the self-contained report of a run.
//!
//! [`report`] turns what a run has left in its directory into one `report.html` that needs nothing else: no script, no
//! style sheet, no picture from elsewhere. [`report_of_sweep`] lists the runs of a sweep, [`report_of_bench`] draws
//! error against work. [`picture_of`] draws a scene as PNG.
//!
//! It reads `summary.json`, `series/*.csv` (`convergence.csv` and `ledger.csv` have sections of their own) and the
//! collections `frames/*.pvd`: `.vtp` frames are grains with the fields `radius` and `velocity`, `.vtu` frames are
//! the fluid with the nodal field `velocity`.

mod axis;
mod bench;
mod error;
mod page;
mod picture;
mod plot;
mod run;
mod write;

pub use bench::{Amount, WorkPrecision, report_of_bench};
pub use error::ReportError;
pub use picture::{Bounds, FluidMesh, FluidView, Grain, PictureOptions, Scene, picture_of};
pub use run::scene_of;
pub use write::{report, report_of_sweep};
