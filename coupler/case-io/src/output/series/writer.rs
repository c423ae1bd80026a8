//! Writing a series row by row.

use std::fs::{File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use super::{Series, Title};
use crate::output::{OutputError, read_file, replace_file};

/// A series that grows by one row per output time; every row is on its way to disk when [`SeriesWriter::row`] returns.
#[derive(Debug)]
pub struct SeriesWriter {
    path: PathBuf,
    file: File,
    columns: usize,
}

impl SeriesWriter {
    /// Starts a series, replacing what is there. Titles are `name[unit]`; the first one is time.
    ///
    /// # Errors
    /// A title that is not `name[unit]`, a title twice, no title at all, or a file that cannot be written.
    pub fn create(path: &Path, titles: &[&str]) -> Result<Self, OutputError> {
        let inconsistent = |found: String, expected: &str| OutputError::Inconsistent {
            path: path.to_path_buf(),
            what: "titles of the columns".to_owned(),
            found,
            expected: expected.to_owned(),
        };
        if titles.is_empty() {
            return Err(inconsistent("none".to_owned(), "at least time, \"t[s]\""));
        }
        for (i, title) in titles.iter().enumerate() {
            if title.parse::<Title>().is_err() {
                return Err(inconsistent(format!("{title:?}"), "name[unit], without commas and quotes"));
            }
            if titles[..i].contains(title) {
                return Err(inconsistent(format!("{title:?} twice"), "every title once"));
            }
        }
        let mut file = File::create(path).map_err(OutputError::system("create", path))?;
        let row = titles.join(",") + "\n";
        file.write_all(row.as_bytes()).map_err(OutputError::system("write", path))?;
        Ok(Self { path: path.to_path_buf(), file, columns: titles.len() })
    }

    /// Goes on with a series that a resumed run has cut back by [`cut_after`].
    ///
    /// # Errors
    /// The file cannot be opened, or its titles are others.
    pub fn append(path: &Path, titles: &[&str]) -> Result<Self, OutputError> {
        let bytes = read_file(path)?;
        let first = bytes.split(|&byte| byte == b'\n').next().unwrap_or_default();
        let expected = titles.join(",");
        if first != expected.as_bytes() {
            return Err(OutputError::Malformed {
                place: format!("{}:1", path.display()),
                what: "titles of the columns".to_owned(),
                found: String::from_utf8_lossy(first).into_owned(),
                expected,
                advice: "resume with the case that began the run",
            });
        }
        let file =
            OpenOptions::new().append(true).open(path).map_err(OutputError::system("append to", path))?;
        Ok(Self { path: path.to_path_buf(), file, columns: titles.len() })
    }

    /// Adds one row: the time and the values in the order of the titles. Non-finite values are written as such.
    ///
    /// # Errors
    /// A row of another length, or a file that cannot be written.
    pub fn row(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns {
            return Err(OutputError::Inconsistent {
                path: self.path.clone(),
                what: "length of the row".to_owned(),
                found: values.len().to_string(),
                expected: format!("{} values", self.columns),
            });
        }
        let cells: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
        let row = cells.join(",") + "\n";
        // One call per row: a killed run leaves whole rows.
        self.file.write_all(row.as_bytes()).map_err(OutputError::system("write", &self.path))
    }
}

/// Drops the rows after `time` and a last row that is not whole, as a resumed run writes them anew.
///
/// # Errors
/// The file cannot be read or written, or is no series.
pub fn cut_after(path: &Path, time: f64) -> Result<(), OutputError> {
    let series = Series::read_of_run(path)?;
    let keep = series.time().map_or(0, |times| times.values.partition_point(|&row| row <= time));
    let bytes = read_file(path)?;
    let end: usize = bytes.split_inclusive(|&byte| byte == b'\n').take(1 + keep).map(<[u8]>::len).sum();
    if end == bytes.len() { Ok(()) } else { replace_file(path, &[&bytes[..end]]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::test_directory::TestDirectory;
    use std::fs;

    const TITLES: [&str; 2] = ["t[s]", "vz[m/s]"];

    #[test]
    fn every_bit_of_a_number_survives() {
        let directory = TestDirectory::new();
        let path = directory.path("a.csv");
        let mut writer = SeriesWriter::create(&path, &TITLES).unwrap();
        let values = [0.1 + 0.2, -0.0, 5e-324, f64::MAX, 1.0 / 3.0, f64::INFINITY, f64::NEG_INFINITY];
        for (i, value) in values.into_iter().enumerate() {
            writer.row(&[i as f64, value]).unwrap();
        }
        let series = Series::read(&path).unwrap();
        let read: Vec<u64> =
            series.column("vz").unwrap().values.iter().map(|value| value.to_bits()).collect();
        assert_eq!(read, values.map(f64::to_bits));
    }

    #[test]
    fn rows_are_on_disk_at_once() {
        let directory = TestDirectory::new();
        let path = directory.path("a.csv");
        let mut writer = SeriesWriter::create(&path, &TITLES).unwrap();
        writer.row(&[0.5, f64::NAN]).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "t[s],vz[m/s]\n0.5,NaN\n");
    }

    #[test]
    fn stop_cut_and_append_give_the_same_file_as_running_through() {
        let directory = TestDirectory::new();
        let (through, resumed) = (directory.path("through.csv"), directory.path("resumed.csv"));
        let row = |step: u32| [f64::from(step) * 0.1, f64::from(step).sin()];
        let mut writer = SeriesWriter::create(&through, &TITLES).unwrap();
        (0..10).for_each(|step| writer.row(&row(step)).unwrap());

        let mut writer = SeriesWriter::create(&resumed, &TITLES).unwrap();
        (0..7).for_each(|step| writer.row(&row(step)).unwrap());
        writer.file.write_all(b"0.7000").unwrap();
        drop(writer);
        cut_after(&resumed, row(4)[0]).unwrap();
        let mut writer = SeriesWriter::append(&resumed, &TITLES).unwrap();
        (5..10).for_each(|step| writer.row(&row(step)).unwrap());
        assert_eq!(fs::read(&resumed).unwrap(), fs::read(&through).unwrap());
    }

    #[test]
    fn a_row_killed_in_mid_write_is_cut_even_if_its_time_would_stay() {
        let directory = TestDirectory::new();
        let path = directory.path("a.csv");
        fs::write(&path, "t[s],vz[m/s]\n0.0,1.0\n0.1,2").unwrap();
        cut_after(&path, 1.0).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "t[s],vz[m/s]\n0.0,1.0\n");
    }

    #[test]
    fn wrong_titles_and_rows_are_refused() {
        let directory = TestDirectory::new();
        let path = directory.path("a.csv");
        for titles in [&[][..], &["t"], &["t[s]", "t[s]"], &["a,b[1]"]] {
            assert!(SeriesWriter::create(&path, titles).is_err(), "{titles:?}");
        }
        assert!(!path.exists());
        let mut writer = SeriesWriter::create(&path, &TITLES).unwrap();
        let error = writer.row(&[1.0]).unwrap_err().to_string();
        assert!(error.contains("found 1, expected 2"), "{error}");
        let error = SeriesWriter::append(&path, &["t[s]", "vx[m/s]"]).unwrap_err().to_string();
        assert!(error.contains("a.csv:1") && error.contains("vz[m/s]"), "{error}");
    }
}
