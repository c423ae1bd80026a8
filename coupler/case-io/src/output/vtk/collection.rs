//! PVD: the index that gives every frame its time.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::document::{escape, unescape};
use crate::output::{OutputError, read_file, replace_file};

/// One dated frame.
#[derive(Debug, Clone, PartialEq)]
pub struct CollectionEntry {
    /// Time \[s\].
    pub time: f64,
    /// File name, relative to the index.
    pub file: String,
}

/// The frames of one participant in order of time, on disk rewritten after every frame: an aborted run opens in
/// ParaView.
#[derive(Debug)]
pub struct Collection {
    path: PathBuf,
    entries: Vec<CollectionEntry>,
}

impl Collection {
    /// Starts an empty index at `path` (`.pvd`), replacing what is there.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let collection = Self { path: path.to_path_buf(), entries: Vec::new() };
        collection.write()?;
        Ok(collection)
    }

    /// Reads an index written by this type.
    ///
    /// # Errors
    /// The file cannot be read, or an entry has no finite time or no file name.
    pub fn open(path: &Path) -> Result<Self, OutputError> {
        let bytes = read_file(path)?;
        let text = String::from_utf8_lossy(&bytes);
        let mut entries = Vec::new();
        for (row, line) in text.lines().enumerate().filter(|(_, line)| line.starts_with("<DataSet ")) {
            let entry = attribute(line, "timestep")
                .and_then(|time| time.parse::<f64>().ok())
                .filter(|time| time.is_finite())
                .zip(attribute(line, "file"))
                .map(|(time, file)| CollectionEntry { time, file: unescape(file) });
            entries.push(entry.ok_or_else(|| OutputError::Malformed {
                place: format!("{}:{}", path.display(), row + 1),
                what: "entry of the frame index".to_owned(),
                found: line.to_owned(),
                expected: "<DataSet timestep=\"a number\" … file=\"a name\"/>".to_owned(),
                advice: "delete the line, or the index to lose the times of the frames",
            })?);
        }
        Ok(Self { path: path.to_path_buf(), entries })
    }

    /// The frames in the order of their times.
    pub fn entries(&self) -> &[CollectionEntry] {
        &self.entries
    }

    /// Adds a frame that has just been written beside the index, and rewrites the index.
    ///
    /// # Errors
    /// A time that is not finite or not later than the last one, or a file that cannot be written.
    pub fn push(&mut self, time: f64, file: &str) -> Result<(), OutputError> {
        let last = self.entries.last().map_or(f64::NEG_INFINITY, |entry| entry.time);
        if !(time.is_finite() && time > last) {
            return Err(OutputError::Inconsistent {
                path: self.path.clone(),
                what: format!("time of the frame {file:?}"),
                found: format!("{time:?} s"),
                expected: format!("a finite time after {last:?} s"),
            });
        }
        self.entries.push(CollectionEntry { time, file: file.to_owned() });
        self.write()
    }

    /// Forgets and deletes the frames after `time`, as a resumed run writes them anew.
    ///
    /// # Errors
    /// The index cannot be written or a frame cannot be deleted.
    pub fn truncate_after(&mut self, time: f64) -> Result<(), OutputError> {
        let keep = self.entries.partition_point(|entry| entry.time <= time);
        let dropped = self.entries.split_off(keep);
        // Index first: it must never name a frame that is gone.
        self.write()?;
        for entry in dropped {
            let frame = self.path.with_file_name(&entry.file);
            match fs::remove_file(&frame) {
                Err(source) if source.kind() != io::ErrorKind::NotFound => {
                    return Err(OutputError::System { action: "delete", path: frame, source });
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn write(&self) -> Result<(), OutputError> {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
        );
        for CollectionEntry { time, file } in &self.entries {
            let file = escape(file);
            let _ = writeln!(text, "<DataSet timestep=\"{time:?}\" part=\"0\" file=\"{file}\"/>");
        }
        text.push_str("</Collection>\n</VTKFile>\n");
        replace_file(&self.path, &[text.as_bytes()])
    }
}

/// The value of an attribute in one line of XML.
pub(super) fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let begin = line.find(&format!(" {name}=\""))? + name.len() + 3;
    let length = line[begin..].find('"')?;
    Some(&line[begin..begin + length])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::test_directory::TestDirectory;

    #[test]
    fn an_index_reads_back_with_every_bit_of_its_times() {
        let directory = TestDirectory::new();
        let path = directory.path("grains.pvd");
        let mut collection = Collection::create(&path).unwrap();
        for (time, file) in [(0.0, "a.vtp"), (0.1 + 0.2, "b & \"c\".vtp"), (1e9, "d.vtp")] {
            collection.push(time, file).unwrap();
            assert_eq!(Collection::open(&path).unwrap().entries(), collection.entries());
        }
    }

    #[test]
    fn truncation_keeps_the_frame_at_the_time_and_deletes_the_later_ones() {
        let directory = TestDirectory::new();
        let path = directory.path("grains.pvd");
        let mut collection = Collection::create(&path).unwrap();
        for step in 0..5 {
            let file = format!("grains-{step}.vtp");
            fs::write(directory.path(&file), "").unwrap();
            collection.push(f64::from(step) * 0.1, &file).unwrap();
        }
        fs::remove_file(directory.path("grains-4.vtp")).unwrap();
        collection.truncate_after(2.0 * 0.1).unwrap();
        assert_eq!(Collection::open(&path).unwrap().entries().len(), 3);
        assert!(directory.path("grains-2.vtp").exists());
        assert!(!directory.path("grains-3.vtp").exists());
        collection.push(0.3, "grains-3.vtp").unwrap();
    }

    #[test]
    fn time_goes_forward() {
        let directory = TestDirectory::new();
        let mut collection = Collection::create(&directory.path("grains.pvd")).unwrap();
        collection.push(1.0, "a").unwrap();
        for time in [1.0, 0.5, f64::NAN, f64::INFINITY] {
            assert!(collection.push(time, "b").is_err(), "{time}");
        }
        assert_eq!(collection.entries().len(), 1);
    }

    #[test]
    fn a_damaged_entry_is_refused_with_its_line() {
        let directory = TestDirectory::new();
        let path = directory.path("grains.pvd");
        fs::write(&path, "<Collection>\n<DataSet timestep=\"soon\" file=\"a\"/>\n").unwrap();
        let error = Collection::open(&path).unwrap_err().to_string();
        assert!(error.contains("grains.pvd:2") && error.contains("soon"), "{error}");
    }
}
