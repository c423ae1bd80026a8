//! What can go wrong while reading or writing the files of a run.

use std::io;
use std::path::{Path, PathBuf};

/// A file of a run could not be written, or does not hold what it should.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The operating system refused.
    #[error("cannot {action} {}: {source}; check the path, its permissions and the free space", path.display())]
    System {
        /// The verb: read, write, rename, …
        action: &'static str,
        /// Which file or directory.
        path: PathBuf,
        /// The system's answer.
        source: io::Error,
    },
    /// A text file (series, index, summary, manifest) does not follow its format.
    #[error("{place}: {what}: found {found}, expected {expected}; {advice}")]
    Malformed {
        /// Which file, and `:line` where it is known.
        place: String,
        /// What is wrong.
        what: String,
        /// What was read.
        found: String,
        /// What the format allows.
        expected: String,
        /// What to do.
        advice: &'static str,
    },
    /// The caller handed over data that do not belong together.
    #[error("cannot write {}: {what}: found {found}, expected {expected}", path.display())]
    Inconsistent {
        /// Which file was to be written.
        path: PathBuf,
        /// What is wrong.
        what: String,
        /// The value handed over.
        found: String,
        /// The value that would fit.
        expected: String,
    },
    /// The file does not begin like a checkpoint.
    #[error("{}: not a checkpoint: begins with {found:02x?}, expected {expected:02x?}; name a file from restart/window-N/", path.display())]
    NotCheckpoint {
        /// Which file.
        path: PathBuf,
        /// Its first bytes.
        found: Vec<u8>,
        /// The magic bytes.
        expected: [u8; 8],
    },
    /// The checkpoint was written in another version of the format.
    #[error("{}: checkpoint format version {found}, expected {expected}; resume with the program that wrote it", path.display())]
    OtherVersion {
        /// Which file.
        path: PathBuf,
        /// The version in the file.
        found: u32,
        /// The version this program reads and writes.
        expected: u32,
    },
    /// The checkpoint belongs to another participant.
    #[error("{}: checkpoint of kind {found:?}, expected {expected:?}; were two files exchanged?", path.display())]
    OtherKind {
        /// Which file.
        path: PathBuf,
        /// The kind in the file.
        found: String,
        /// The kind asked for.
        expected: String,
    },
    /// The file ends too early or too late.
    #[error("{}: section {section:?}: the file holds {found} bytes, expected {expected}; use an earlier restart point", path.display())]
    OtherLength {
        /// Which file.
        path: PathBuf,
        /// Which section, or `header`.
        section: String,
        /// Bytes in the file.
        found: u64,
        /// Bytes the file should have.
        expected: u64,
    },
    /// The bytes are not the ones that were written.
    #[error("{}: section {section:?} is damaged: checksum {found:016x}, expected {expected:016x}; use an earlier restart point", path.display())]
    Damaged {
        /// Which file.
        path: PathBuf,
        /// Which section, or `header`.
        section: String,
        /// Checksum of the bytes read.
        found: u64,
        /// Checksum stored when they were written.
        expected: u64,
    },
    /// The checkpoint does not hold the section, or holds it with another type.
    #[error("{}: section {section:?}: found {found}, expected {expected}; resume with the program that wrote it", path.display())]
    OtherSection {
        /// Which file.
        path: PathBuf,
        /// Which section.
        section: String,
        /// What is there.
        found: String,
        /// What was asked for.
        expected: String,
    },
}

impl OutputError {
    /// For `map_err` after a call to the operating system.
    pub fn system(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::System { action, path, source }
    }
}
