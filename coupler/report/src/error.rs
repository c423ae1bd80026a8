//! Why a report could not be written.

use std::path::PathBuf;

use case_io::output::OutputError;

/// The report or a picture could not be made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// There is no run to report on.
    #[error("{}: not the directory of a run: found neither summary.json nor series/ nor frames/; name the directory given to --out", directory.display())]
    NoRun {
        /// The directory asked for.
        directory: PathBuf,
    },
    /// A file could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A picture too small or too large.
    #[error("picture of {} × {} pixels: each side must be {smallest} to {largest}", found[0], found[1])]
    PictureSize {
        /// Width and height asked for.
        found: [u32; 2],
        /// Smallest side.
        smallest: u32,
        /// Largest side.
        largest: u32,
    },
    /// A mesh that contradicts itself.
    #[error("mesh of a picture: {what} {found} does not match its {points} points; write the frame anew")]
    Mesh {
        /// What does not match.
        what: &'static str,
        /// Its value.
        found: usize,
        /// Number of points.
        points: usize,
    },
    /// The picture could not be drawn or encoded.
    #[error("a picture could not be encoded as PNG; make it smaller")]
    Png,
    /// The plotting library refused.
    #[error("plot {title:?} could not be drawn: {problem}")]
    Plot {
        /// Which plot.
        title: String,
        /// What the library said.
        problem: String,
    },
}
