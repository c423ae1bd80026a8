//! The restart point: one transaction over the checkpoints of all participants.
//!
//! ```text
//! restart/window-120/            complete: dem-solver, fluid-solver, coupler, manifest.json
//! restart/window-140/            complete
//! restart/window-160.tmp/        being written, or left by a run that was killed: never read
//! ```

use std::fs;
use std::path::{Path, PathBuf};

use super::manifest::{Manifest, Part};
use crate::output::{OutputError, sync_directory};

/// How many complete restart points stay.
const KEPT: usize = 2;

/// A restart point that is being written; it becomes real in [`RestartPoint::commit`].
#[derive(Debug)]
pub struct RestartPoint {
    restart: PathBuf,
    window: u64,
}

/// Where a participant writes its part of the open restart point of a window.
pub fn part_path(restart: &Path, window: u64, part: &str) -> PathBuf {
    temporary(restart, window).join(part)
}

fn temporary(restart: &Path, window: u64) -> PathBuf {
    restart.join(format!("window-{window}.tmp"))
}

fn complete(restart: &Path, window: u64) -> PathBuf {
    restart.join(format!("window-{window}"))
}

impl RestartPoint {
    /// Opens the transaction: makes `restart/window-N.tmp/`, empty.
    ///
    /// # Errors
    /// The directory cannot be made.
    pub fn begin(restart: &Path, window: u64) -> Result<Self, OutputError> {
        let directory = temporary(restart, window);
        if directory.exists() {
            fs::remove_dir_all(&directory).map_err(OutputError::system("remove", &directory))?;
        }
        fs::create_dir_all(&directory).map_err(OutputError::system("create", &directory))?;
        Ok(Self { restart: restart.to_path_buf(), window })
    }

    /// Where a part is to be written.
    pub fn part(&self, name: &str) -> PathBuf {
        part_path(&self.restart, self.window, name)
    }

    /// Closes the transaction: notes size and checksum of the named parts, syncs, renames to `window-N` and removes
    /// all but the two newest. Restart points of later windows are of a run that was cut back: they go too.
    ///
    /// # Errors
    /// A part that is missing, a time that is not finite, or a disk that refuses; the restart points so far stay.
    pub fn commit(
        self,
        t: f64,
        dt: f64,
        case_hash: &str,
        program_version: &str,
        parts: &[&str],
    ) -> Result<PathBuf, OutputError> {
        let open = temporary(&self.restart, self.window);
        let manifest = Manifest {
            window: self.window,
            t,
            dt,
            case_hash: case_hash.to_owned(),
            program_version: program_version.to_owned(),
            parts: parts.iter().map(|name| Part::of_file(&open, name)).collect::<Result<_, _>>()?,
        };
        manifest.write(&open)?;

        let closed = complete(&self.restart, self.window);
        if closed.exists() {
            fs::remove_dir_all(&closed).map_err(OutputError::system("remove", &closed))?;
        }
        fs::rename(&open, &closed).map_err(OutputError::system("rename a new restart point to", &closed))?;
        sync_directory(&self.restart)?;

        let windows = windows(&self.restart)?;
        let later = windows.iter().filter(|&&window| window > self.window);
        let earlier = windows.iter().filter(|&&window| window <= self.window).rev().skip(KEPT);
        for &window in later.chain(earlier) {
            let directory = complete(&self.restart, window);
            fs::remove_dir_all(&directory).map_err(OutputError::system("remove", &directory))?;
        }
        Ok(closed)
    }
}

/// A complete and verified restart point.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Its directory.
    pub directory: PathBuf,
    /// What it holds.
    pub manifest: Manifest,
}

/// A restart point that cannot be used.
#[derive(Debug, Clone, PartialEq)]
pub struct Skipped {
    /// Its directory.
    pub directory: PathBuf,
    /// Why not.
    pub why: String,
}

/// What [`latest`] found.
#[derive(Debug, Clone, PartialEq)]
pub struct Search {
    /// The newest restart point that is complete and undamaged.
    pub found: Option<Found>,
    /// The newer ones that are not, newest first, and the unfinished ones.
    pub skipped: Vec<Skipped>,
}

/// Looks for the newest complete and undamaged restart point in `restart/`.
///
/// # Errors
/// The directory cannot be read. A damaged restart point is no error: it is skipped and told.
pub fn latest(restart: &Path) -> Result<Search, OutputError> {
    let mut search = Search { found: None, skipped: Vec::new() };
    for name in names(restart)? {
        if name.starts_with("window-") && name.ends_with(".tmp") {
            let why = "unfinished: the run ended while it was written".to_owned();
            search.skipped.push(Skipped { directory: restart.join(name), why });
        }
    }
    for window in windows(restart)?.into_iter().rev() {
        let directory = complete(restart, window);
        match Manifest::read_and_verify(&directory) {
            Ok(manifest) if manifest.window == window => {
                search.found = Some(Found { directory, manifest });
                break;
            }
            Ok(manifest) => {
                let why = format!("its manifest is of window {}", manifest.window);
                search.skipped.push(Skipped { directory, why });
            }
            Err(fault) => search.skipped.push(Skipped { directory, why: fault.to_string() }),
        }
    }
    Ok(search)
}

/// Numbers of the complete restart points, ascending.
fn windows(restart: &Path) -> Result<Vec<u64>, OutputError> {
    let mut windows: Vec<u64> =
        names(restart)?.iter().filter_map(|name| name.strip_prefix("window-")?.parse().ok()).collect();
    windows.sort_unstable();
    Ok(windows)
}

/// The entries of the directory, sorted.
fn names(restart: &Path) -> Result<Vec<String>, OutputError> {
    let read = || -> std::io::Result<Vec<String>> {
        let entries = fs::read_dir(restart)?;
        entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect()
    };
    let mut names = read().map_err(OutputError::system("read", restart))?;
    names.sort_unstable();
    Ok(names)
}

#[cfg(test)]
mod tests {
    use super::super::{Checkpoint, CheckpointWriter};
    use super::*;
    use crate::output::test_directory::TestDirectory;

    const PARTS: [&str; 2] = ["dem-solver", "coupler"];

    fn write(restart: &Path, window: u64) -> PathBuf {
        let point = RestartPoint::begin(restart, window).unwrap();
        for part in PARTS {
            CheckpointWriter::new(part, &window)
                .array("x", &[window as f64])
                .write(&point.part(part))
                .unwrap();
        }
        point.commit(window as f64 * 0.1, 0.1, "abc", "0.1.0", &PARTS).unwrap()
    }

    fn found_window(search: &Search) -> Option<u64> {
        search.found.as_ref().map(|found| found.manifest.window)
    }

    #[test]
    fn the_newest_is_found_with_every_bit_of_its_time() {
        let directory = TestDirectory::new();
        (1..=3).for_each(|window| drop(write(directory.root(), window)));
        let search = latest(directory.root()).unwrap();
        assert!(search.skipped.is_empty());
        let found = search.found.unwrap();
        assert_eq!(found.manifest.window, 3);
        assert_eq!(found.manifest.t.to_bits(), (3.0f64 * 0.1).to_bits());
        assert_eq!(
            (found.manifest.case_hash.as_str(), found.manifest.program_version.as_str()),
            ("abc", "0.1.0")
        );
        let part = Checkpoint::read(&found.directory.join("coupler"), "coupler").unwrap();
        assert_eq!(part.metadata::<u64>().unwrap(), 3);
    }

    #[test]
    fn every_time_survives_the_manifest_bit_for_bit() {
        let directory = TestDirectory::new();
        let mut t = 1e-7f64;
        for _ in 0..60 {
            t *= 1.337_129_3;
            let manifest = Manifest {
                window: 1,
                t,
                dt: 1.0 / t,
                case_hash: String::new(),
                program_version: String::new(),
                parts: Vec::new(),
            };
            manifest.write(directory.root()).unwrap();
            assert_eq!(Manifest::read_and_verify(directory.root()).unwrap(), manifest);
        }
    }

    #[test]
    fn only_the_last_two_stay_in_numerical_order() {
        let directory = TestDirectory::new();
        [8, 9, 10, 11].into_iter().for_each(|window| drop(write(directory.root(), window)));
        assert_eq!(names(directory.root()).unwrap(), ["window-10", "window-11"]);
    }

    #[test]
    fn an_open_transaction_is_never_found_but_told() {
        let directory = TestDirectory::new();
        write(directory.root(), 1);
        let point = RestartPoint::begin(directory.root(), 2).unwrap();
        fs::write(point.part("dem-solver"), "half").unwrap();
        let search = latest(directory.root()).unwrap();
        assert_eq!(found_window(&search), Some(1));
        assert!(search.skipped[0].directory.ends_with("window-2.tmp"));
        assert!(search.skipped[0].why.contains("unfinished"));
    }

    #[test]
    fn a_part_that_is_missing_fails_the_commit_and_leaves_the_old_point() {
        let directory = TestDirectory::new();
        write(directory.root(), 1);
        let point = RestartPoint::begin(directory.root(), 2).unwrap();
        let error = point.commit(0.2, 0.1, "abc", "0.1.0", &["dem-solver"]).unwrap_err().to_string();
        assert!(error.contains("window-2.tmp/dem-solver"), "{error}");
        assert_eq!(found_window(&latest(directory.root()).unwrap()), Some(1));
    }

    #[test]
    fn a_damaged_part_or_manifest_is_skipped_with_the_reason() {
        type Harm = fn(&mut Vec<u8>);
        let damage: [(&str, Harm); 4] = [
            ("dem-solver", |bytes| bytes[60] ^= 1),
            ("dem-solver", |bytes| bytes.truncate(50)),
            ("manifest.json", |bytes| bytes.truncate(50)),
            // A digit of the time: still valid JSON.
            ("manifest.json", |bytes| {
                let text = String::from_utf8(bytes.clone()).unwrap().replace("\"t\": 0.2", "\"t\": 0.3");
                *bytes = text.into_bytes();
            }),
        ];
        for (file, harm) in damage {
            let directory = TestDirectory::new();
            write(directory.root(), 1);
            let path = write(directory.root(), 2).join(file);
            let whole = fs::read(&path).unwrap();
            let mut bytes = whole.clone();
            harm(&mut bytes);
            assert_ne!(bytes, whole);
            fs::write(&path, bytes).unwrap();
            let search = latest(directory.root()).unwrap();
            assert_eq!(found_window(&search), Some(1), "{file}");
            assert!(search.skipped[0].why.contains(file), "{}", search.skipped[0].why);
        }
    }

    #[test]
    fn a_lost_part_is_skipped_and_with_nothing_left_nothing_is_found() {
        let directory = TestDirectory::new();
        fs::remove_file(write(directory.root(), 1).join("coupler")).unwrap();
        fs::create_dir(directory.path("window-2")).unwrap();
        let search = latest(directory.root()).unwrap();
        assert_eq!(found_window(&search), None);
        assert_eq!(search.skipped.len(), 2);
        assert!(latest(&directory.path("absent")).is_err());
    }

    #[test]
    fn going_on_from_an_earlier_point_replaces_the_later_ones() {
        let directory = TestDirectory::new();
        write(directory.root(), 10);
        write(directory.root(), 20);
        write(directory.root(), 15);
        assert_eq!(names(directory.root()).unwrap(), ["window-10", "window-15"]);
        write(directory.root(), 15);
        assert_eq!(found_window(&latest(directory.root()).unwrap()), Some(15));
    }
}
