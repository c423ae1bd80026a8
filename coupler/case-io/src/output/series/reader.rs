//! Reading a series for checks and plots.

use std::path::Path;

use super::{Column, Title};
use crate::output::{OutputError, read_file};

/// A series in memory, column by column.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    columns: Vec<Column>,
}

impl Series {
    /// Reads a finished file, such as a reference: the last row counts with or without a line end.
    ///
    /// # Errors
    /// The file cannot be read, a title is not `name[unit]`, a row has another length, or a cell is no number.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let bytes = read_file(path)?;
        Self::parse(path, &String::from_utf8_lossy(&bytes))
    }

    /// Reads what a run has written so far: a last row without its line end was being written when the run was
    /// killed, and is ignored.
    ///
    /// # Errors
    /// As [`Series::read`].
    pub fn read_of_run(path: &Path) -> Result<Self, OutputError> {
        let bytes = read_file(path)?;
        let text = String::from_utf8_lossy(&bytes);
        Self::parse(path, &text[..text.rfind('\n').map_or(0, |end| end + 1)])
    }

    fn parse(path: &Path, text: &str) -> Result<Self, OutputError> {
        let malformed = |line: usize, what: String, found: &str, expected: String| OutputError::Malformed {
            place: format!("{}:{line}", path.display()),
            what,
            found: format!("{found:?}"),
            expected,
            advice: "correct or delete the line",
        };

        let mut rows = text.lines().enumerate().map(|(row, line)| (row + 1, line));
        let (_, first) = rows.next().unwrap_or((1, ""));
        let mut columns = Vec::new();
        for title in first.split(',') {
            let title: Title = title
                .parse()
                .map_err(|()| malformed(1, "title of a column".to_owned(), title, "name[unit]".to_owned()))?;
            columns.push(Column { title, values: Vec::new() });
        }
        for (line, row) in rows {
            let count = row.split(',').count();
            if count != columns.len() {
                let expected = format!("{} cells", columns.len());
                return Err(malformed(line, "number of cells".to_owned(), &count.to_string(), expected));
            }
            for (column, cell) in columns.iter_mut().zip(row.split(',')) {
                let value = cell.trim().parse().map_err(|_| {
                    malformed(
                        line,
                        format!("cell of the column {}", column.title),
                        cell,
                        "a number".to_owned(),
                    )
                })?;
                column.values.push(value);
            }
        }
        Ok(Self { columns })
    }

    /// All columns; the first one is time.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The first column.
    pub fn time(&self) -> Option<&Column> {
        self.columns.first()
    }

    /// The column of that name, whatever its unit.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.title.name == name)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.time().map_or(0, |times| times.values.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::test_directory::TestDirectory;
    use std::fs;

    fn read_by(reader: fn(&Path) -> Result<Series, OutputError>, text: &str) -> Result<Series, OutputError> {
        let directory = TestDirectory::new();
        let path = directory.path("a.csv");
        fs::write(&path, text).unwrap();
        reader(&path)
    }

    fn read(text: &str) -> Result<Series, OutputError> {
        read_by(Series::read, text)
    }

    #[test]
    fn columns_are_found_by_name() {
        let series = read("t[s],vz[m/s]\n0.0,-1e-3\n0.5, 2\n").unwrap();
        assert_eq!(series.column("vz").unwrap().values, [-1e-3, 2.0]);
        assert_eq!(series.column("vz").unwrap().title.unit, "m/s");
        assert_eq!(series.rows(), 2);
        assert!(series.column("vx").is_none());
    }

    #[test]
    fn titles_without_rows_are_an_empty_series() {
        assert_eq!(read("t[s],vz[m/s]\n").unwrap().rows(), 0);
    }

    #[test]
    fn a_last_row_without_line_end_counts_in_a_reference_but_not_in_a_run() {
        let text = "t[s],n[1]\n0.0,1.0\n0.1,12";
        assert_eq!(read(text).unwrap().rows(), 2);
        assert_eq!(read_by(Series::read_of_run, text).unwrap().rows(), 1);
    }

    #[test]
    fn errors_name_line_and_column() {
        let message = |text: &str| read(text).unwrap_err().to_string();
        assert!(message("").contains("a.csv:1"));
        assert!(message("time,v[m]\n").contains("\"time\""));
        assert!(message("t[s],v[m]\n0.0,1.0\n0.1\n").contains("a.csv:3"));
        let error = message("t[s],v[m]\n0.0,fast\n");
        assert!(error.contains("v[m]") && error.contains("\"fast\""), "{error}");
    }
}
