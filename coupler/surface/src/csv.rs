//! Tables of numbers in csv files, units in the header.

use std::fs;
use std::path::Path;

use crate::error::InputError;
use crate::flaw::Flaw;

/// Rows of finite numbers under known columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Csv {
    /// Names of the columns.
    names: Vec<String>,
    /// Rows, with their lines in the file.
    rows: Vec<(usize, Vec<f64>)>,
}

impl Csv {
    /// The table in a text; each column is one of those `allowed`, and the `required` ones are there.
    ///
    /// # Errors
    /// Where the text is no such table.
    pub fn parse(text: &str, allowed: &[&str], required: &[&str]) -> Result<Self, Flaw> {
        let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line));
        let header = lines.next().map_or("", |(_, line)| line);
        let names: Vec<String> = header.split(',').map(|name| name.trim().to_string()).collect();
        if let Some(unknown) = names.iter().find(|name| !allowed.contains(&name.as_str())) {
            return Err(Flaw::at(1, format!("unknown column {unknown:?}; allowed: {}", allowed.join(", "))));
        }
        if let Some(missing) = required.iter().find(|wanted| !names.iter().any(|name| name == *wanted)) {
            return Err(Flaw::at(1, format!("no column {missing:?}; found: {}", names.join(", "))));
        }
        let filled = lines.filter(|(_, line)| !line.trim().is_empty());
        let rows = filled
            .map(|(number, line)| Ok((number, numbers(number, line.split(',').map(str::trim), &names)?)));
        let rows = rows.collect::<Result<_, Flaw>>()?;
        Ok(Self { names, rows })
    }

    /// What `take` makes of the table in a file.
    ///
    /// # Errors
    /// A file that cannot be read; flaws of its text, and those that `take` finds.
    pub fn read<T>(
        path: &Path,
        allowed: &[&str],
        required: &[&str],
        take: impl FnOnce(&Self) -> Result<T, Flaw>,
    ) -> Result<T, InputError> {
        let text = fs::read_to_string(path)
            .map_err(|source| InputError::Unreadable { path: path.into(), source })?;
        let taken = Self::parse(&text, allowed, required).and_then(|table| take(&table));
        taken.map_err(|flaw| InputError::BadFile { path: path.into(), flaw })
    }

    /// Whether there is a column of this name.
    pub fn has(&self, name: &str) -> bool {
        self.names.iter().any(|known| known == name)
    }

    /// The lines in the file, and the values of these columns, 0 where there is none.
    pub fn rows<const N: usize>(&self, names: [&str; N]) -> impl Iterator<Item = (usize, [f64; N])> {
        let at = names.map(|name| self.names.iter().position(|known| known == name));
        self.rows.iter().map(move |(line, row)| (*line, at.map(|at| at.map_or(0.0, |at| row[at]))))
    }
}

/// The finite numbers in the cells of a line, one for each name.
///
/// # Errors
/// Another number of cells; one that is not a finite number.
pub fn numbers<'a, N: AsRef<str>>(
    line: usize,
    cells: impl Iterator<Item = &'a str>,
    names: &[N],
) -> Result<Vec<f64>, Flaw> {
    let cells: Vec<&str> = cells.collect();
    if cells.len() != names.len() {
        let what = format!("{} values where the header has {}", cells.len(), names.len());
        return Err(Flaw::at(line, what));
    }
    let number = |(cell, name): (&&str, &N)| match cell.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(Flaw::at(line, format!("{}: {cell:?} is not a finite number", name.as_ref()))),
    };
    cells.iter().zip(names).map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_by_name_and_flaws_by_line() {
        let parse = |text: &str| Csv::parse(text, &["t[s]", "x[m]", "y[m]"], &["t[s]"]);
        let table = parse("x[m], t[s]\n1,2\n\n3, 4e1\n").unwrap();
        let rows: Vec<_> = table.rows(["t[s]", "y[m]", "x[m]"]).collect();
        assert_eq!(rows, [(2, [2.0, 0.0, 1.0]), (4, [40.0, 0.0, 3.0])]);
        assert!(table.has("x[m]") && !table.has("y[m]"));
        let error = |text: &str| format!("a.csv{}", parse(text).unwrap_err());
        assert_eq!(error("t[s],x\n"), "a.csv:1: unknown column \"x\"; allowed: t[s], x[m], y[m]");
        assert_eq!(error("x[m]\n1\n"), "a.csv:1: no column \"t[s]\"; found: x[m]");
        assert_eq!(error("t[s],x[m]\n1\n"), "a.csv:2: 1 values where the header has 2");
        assert_eq!(error("t[s]\n1\ninf\n"), "a.csv:3: t[s]: \"inf\" is not a finite number");
    }
}
