//! Whole files, written under a temporary name and renamed.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::OutputError;

/// Replaces `path` by the concatenation of `pieces`: a reader sees the old file or the new one, never a part.
///
/// # Errors
/// [`OutputError::System`] if the file cannot be written or renamed; the old file is then untouched.
pub fn replace_file(path: &Path, pieces: &[&[u8]]) -> Result<(), OutputError> {
    replace(path, pieces, false)
}

/// As [`replace_file`], and the new file survives a loss of power from the moment the function returns.
///
/// # Errors
/// As [`replace_file`].
pub fn replace_file_durably(path: &Path, pieces: &[&[u8]]) -> Result<(), OutputError> {
    replace(path, pieces, true)?;
    sync_directory(path.parent().unwrap_or(Path::new("")))
}

fn replace(path: &Path, pieces: &[&[u8]], sync: bool) -> Result<(), OutputError> {
    let temporary = temporary_name(path);
    let written = (|| {
        let mut file = File::create(&temporary)?;
        for piece in pieces {
            file.write_all(piece)?;
        }
        if sync { file.sync_all() } else { Ok(()) }
    })();
    if let Err(source) = written {
        // A full disk must not stay full because of a half-written file; the first error is the one to tell.
        let _ = fs::remove_file(&temporary);
        return Err(OutputError::System { action: "write", path: temporary, source });
    }
    fs::rename(&temporary, path).map_err(OutputError::system("rename a new file to", path))
}

/// `frame.vtu` → `frame.vtu.tmp`, in the same directory: a rename must not cross file systems.
fn temporary_name(path: &Path) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(".tmp");
    PathBuf::from(name)
}

/// Makes renames inside `directory` survive a loss of power.
pub(crate) fn sync_directory(directory: &Path) -> Result<(), OutputError> {
    let directory = if directory.as_os_str().is_empty() { Path::new(".") } else { directory };
    File::open(directory).and_then(|handle| handle.sync_all()).map_err(OutputError::system("sync", directory))
}

/// The whole file as bytes.
pub(crate) fn read_file(path: &Path) -> Result<Vec<u8>, OutputError> {
    fs::read(path).map_err(OutputError::system("read", path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::test_directory::TestDirectory;

    #[test]
    fn the_new_file_replaces_the_old_one_and_leaves_nothing_beside_it() {
        let directory = TestDirectory::new();
        let path = directory.path("note");
        replace_file(&path, &[b"old and longer"]).unwrap();
        replace_file_durably(&path, &[b"ne", b"w"]).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(directory.root()).unwrap().count(), 1);
    }

    #[test]
    fn a_missing_directory_is_named_in_the_error() {
        let directory = TestDirectory::new();
        let error = replace_file(&directory.path("absent/note"), &[b""]).unwrap_err().to_string();
        assert!(error.contains("absent/note.tmp") && error.contains("write"), "{error}");
    }
}
