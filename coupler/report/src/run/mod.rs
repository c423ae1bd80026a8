//! What a run has left in its directory.

mod films;
mod frames;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use case_io::output::OutputError;
use case_io::output::series::Series;
use case_io::summary::Summary;

use crate::ReportError;
pub(crate) use films::{Films, Moment};
pub use frames::scene_of;

/// A run as it lies on disk. Files that cannot be read are noted and left out: a run that was aborted still has a
/// report.
pub(crate) struct Run {
    /// None if the run was killed before it could write one.
    pub(crate) summary: Option<Summary>,
    /// File stem and content, by name.
    pub(crate) series: Vec<(String, Series)>,
    pub(crate) films: Films,
    /// What could not be read.
    pub(crate) notes: Vec<String>,
}

impl Run {
    pub(crate) fn read(directory: &Path) -> Result<Self, ReportError> {
        let parts = ["summary.json", "series", "frames"];
        if !parts.iter().any(|part| directory.join(part).exists()) {
            return Err(ReportError::NoRun { directory: directory.to_path_buf() });
        }
        let mut notes = Vec::new();
        let mut keep = |result: Result<Option<Summary>, OutputError>| {
            result.unwrap_or_else(|fault| {
                notes.push(fault.to_string());
                None
            })
        };
        let summary_path = directory.join("summary.json");
        let summary = if summary_path.exists() { keep(Summary::read(&summary_path).map(Some)) } else { None };

        let mut series = Vec::new();
        for path in files(&directory.join("series"), "csv")? {
            match Series::read_of_run(&path) {
                Ok(content) => series.push((stem(&path), content)),
                Err(fault) => notes.push(fault.to_string()),
            }
        }
        let films = Films::open(&files(&directory.join("frames"), "pvd")?, &mut notes);
        Ok(Self { summary, series, films, notes })
    }
}

/// The files of one kind in a directory by name; none if there is no such directory.
fn files(directory: &Path, extension: &str) -> Result<Vec<PathBuf>, OutputError> {
    let list =
        || -> io::Result<Vec<PathBuf>> { fs::read_dir(directory)?.map(|entry| Ok(entry?.path())).collect() };
    match list() {
        Err(fault) if fault.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(source) => Err(OutputError::System { action: "read", path: directory.to_path_buf(), source }),
        Ok(mut paths) => {
            paths.retain(|path| path.extension().is_some_and(|found| found == extension));
            paths.sort_unstable();
            Ok(paths)
        }
    }
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned())
}
