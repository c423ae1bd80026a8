//! How far apart two runs of one case are, and whether that is too far.

mod statistics;
mod trajectories;

use case_io::summary::Check;

pub use statistics::compare_statistics;
pub use trajectories::compare_trajectories;

/// A series of the report: columns over the times of the samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Name of the file.
    pub name: String,
    /// Title `name[unit]` and values of each column.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// What came out.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The verdicts.
    pub checks: Vec<Check>,
    /// What is plotted.
    pub curves: Vec<Curves>,
}

/// A verdict on a difference, relative to its scale.
fn check(name: String, difference: f64, scale: f64, tolerance: f64, why: String) -> Check {
    // Where nothing happens on either side, nothing differs.
    let value = if scale > 0.0 { difference / scale } else { difference };
    Check { name, value, reference: 0.0, tolerance, pass: value <= tolerance, why }
}
