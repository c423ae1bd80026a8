//! Grains from a file: CSV with units in the header, a LIGGGHTS text dump, or XYZ.

mod columns;
mod dump;
mod table;
mod xyz;

use std::fs;
use std::path::Path;

use surface::{Flaw, InputError};

/// A grain as a file states it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileGrain {
    /// Centre \[m\]; z = 0 where the file has none.
    pub centre: [f64; 3],
    /// Velocity \[m/s\], if stated.
    pub velocity: Option<[f64; 3]>,
    /// Angular velocity \[rad/s\], if stated.
    pub angular_velocity: Option<[f64; 3]>,
    /// Radius \[m\], if stated.
    pub radius: Option<f64>,
}

/// Reads the grains of a file in SI units; of a dump or an XYZ file with several snapshots the last.
///
/// # Errors
/// A file that cannot be read, has no grain, lacks x or y, or holds a value that is no finite number.
pub fn read_grains(path: &Path) -> Result<Vec<FileGrain>, InputError> {
    let text =
        fs::read_to_string(path).map_err(|source| InputError::Unreadable { path: path.into(), source })?;
    let grains = if text.starts_with("ITEM:") {
        dump::read(&text)
    } else if xyz::count(text.lines().next().unwrap_or_default()).is_some() {
        xyz::read(&text)
    } else {
        table::read(&text)
    };
    let bad = |flaw: Flaw| InputError::BadFile { path: path.into(), flaw };
    match grains {
        Ok(grains) if grains.is_empty() => Err(bad(Flaw::whole("holds no grain; it needs at least one row"))),
        Ok(grains) => Ok(grains),
        Err(flaw) => Err(bad(flaw)),
    }
}
