//! What the coupler leaves on disk: `series/convergence.csv`, `series/ledger.csv`, its part of restart points.

use crate::error::CouplerError;
use crate::ledger::{ROWS, Residuals};
use crate::owed::Owed;
use crate::window::Outcome;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use case_io::output::series::{SeriesWriter, cut_after};
use case_io::summary::Counts;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The name of the coupler's part of a restart point.
pub const PART: &str = "coupler";

const COUPLING: [&str; 7] = [
    "t[s]",
    "window[s]",
    "iterations[-]",
    "substeps[-]",
    "linear-iterations[-]",
    "velocity-change[-]",
    "force-change[-]",
];

/// Open series of the coupler.
pub struct Record {
    coupling: SeriesWriter,
    ledger: SeriesWriter,
}

fn paths(out: &Path) -> (PathBuf, PathBuf) {
    (out.join("series/convergence.csv"), out.join("series/ledger.csv"))
}

fn ledger_titles() -> Vec<String> {
    std::iter::once("t[s]".to_string()).chain(ROWS.iter().map(|row| format!("{row}[-]"))).collect()
}

impl Record {
    /// Starts the series.
    ///
    /// # Errors
    /// The disk's.
    pub fn create(out: &Path) -> Result<Record, CouplerError> {
        let (coupling, ledger) = paths(out);
        let titles = ledger_titles();
        let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
        Ok(Record {
            coupling: SeriesWriter::create(&coupling, &COUPLING)?,
            ledger: SeriesWriter::create(&ledger, &titles)?,
        })
    }

    /// Goes on after `time`.
    ///
    /// # Errors
    /// The disk's.
    pub fn resume(out: &Path, time: f64) -> Result<Record, CouplerError> {
        let (coupling, ledger) = paths(out);
        cut_after(&coupling, time)?;
        cut_after(&ledger, time)?;
        let titles = ledger_titles();
        let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
        Ok(Record {
            coupling: SeriesWriter::append(&coupling, &COUPLING)?,
            ledger: SeriesWriter::append(&ledger, &titles)?,
        })
    }

    /// A row of a committed window.
    ///
    /// # Errors
    /// The disk's.
    pub fn row(
        &mut self,
        time: f64,
        step: f64,
        outcome: &Outcome,
        residuals: &Residuals,
    ) -> Result<(), CouplerError> {
        let (velocity, force) =
            outcome.residuals.map_or((0.0, 0.0), |changes| (changes.velocity, changes.force));
        let counts = [u64::from(outcome.iterations), outcome.substeps, outcome.linear_iterations]
            .map(|count| count as f64);
        let [iterations, substeps, linear] = counts;
        self.coupling.row(&[time, step, iterations, substeps, linear, velocity, force])?;
        let row: Vec<f64> = std::iter::once(time).chain(residuals.iter().copied()).collect();
        self.ledger.row(&row)?;
        Ok(())
    }
}

/// What of the coupler's state is not an array.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    /// Time reached \[s\].
    pub time: f64,
    /// Number of the window committed.
    pub window: u64,
    /// Work so far.
    pub counts: Counts,
    /// Largest residuals of the ledger so far.
    pub maxima: Residuals,
    /// Largest Δt by (DEM, fluid) \[s\].
    pub largest_step: (f64, f64),
    /// Relaxation between iterations.
    pub relaxation: crate::acceleration::Acceleration,
}

/// Writes the coupler's part of a restart point.
///
/// # Errors
/// The disk's.
pub fn save(path: &Path, memory: &Memory, owed: &Owed) -> Result<(), CouplerError> {
    let writer = CheckpointWriter::new(PART, memory).array("ids", owed.ids());
    Ok(writer.array("owed", owed.impulses().as_flattened()).write(path)?)
}

/// Reads the coupler's part of a restart point.
///
/// # Errors
/// A damaged or foreign file.
pub fn load(path: &Path) -> Result<(Memory, Owed), CouplerError> {
    let checkpoint = Checkpoint::read(path, PART)?;
    let impulses: Vec<f64> = checkpoint.array("owed")?;
    let owed = Owed::new(checkpoint.array("ids")?, impulses.as_chunks::<3>().0.to_vec());
    Ok((checkpoint.metadata()?, owed))
}
