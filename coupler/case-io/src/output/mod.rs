//! What a run leaves on disk for people and other programs: series (CSV) and frames (VTK).
//!
//! Every file that is replaced as a whole is written under a temporary name and then renamed, so that a reader
//! never meets half a file. A series grows by whole rows.

mod error;
mod replace_file;
pub mod series;
#[cfg(test)]
pub(crate) mod test_directory;
pub mod vtk;

pub use error::OutputError;
pub use replace_file::{replace_file, replace_file_durably};

pub(crate) use replace_file::{read_file, sync_directory};

// Bulk arrays are written as they lie in memory.
const _: () = assert!(cfg!(target_endian = "little"), "the file formats are little-endian");
