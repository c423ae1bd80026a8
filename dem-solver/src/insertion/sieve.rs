//! Sieve curves from files.

use std::path::Path;

use super::sizes::Class;
use surface::Flaw;
use surface::InputError;
use surface::csv::Csv;

const COLUMNS: [&str; 2] = ["diameter[m]", "passing[-]"];

/// Reads a sieve curve: the share of the mass that is smaller than each diameter, from 0 to 1.
///
/// # Errors
/// A file that cannot be read, or whose curve does not ascend from 0 to 1.
pub fn read_sieve(path: &Path) -> Result<Vec<Class>, InputError> {
    Csv::read(path, &COLUMNS, &COLUMNS, classes)
}

fn classes(csv: &Csv) -> Result<Vec<Class>, Flaw> {
    let rows: Vec<_> = csv.rows(COLUMNS).collect();
    let (Some((first, [smallest, none])), Some((last, [_, all]))) = (rows.first(), rows.last()) else {
        return Err(Flaw::whole("holds no row; a sieve curve needs two or more"));
    };
    if *smallest <= 0.0 {
        return Err(Flaw::at(*first, format!("diameter[m]: found {smallest}; it must be positive")));
    }
    if *none != 0.0 || *all != 1.0 {
        let (line, found, wanted) = if *none == 0.0 { (*last, all, 1) } else { (*first, none, 0) };
        let what =
            format!("passing[-]: found {found}; a sieve curve starts with 0 and ends with 1, here {wanted}");
        return Err(Flaw::at(line, what));
    }
    let class = |pair: &[(usize, [f64; 2])]| {
        let [(_, [smallest, before]), (line, [largest, passing])] = [pair[0], pair[1]];
        if largest <= smallest || passing < before {
            let what = format!("({largest}, {passing}) does not ascend from ({smallest}, {before})");
            return Err(Flaw::at(line, what));
        }
        Ok(Class { smallest: 0.5 * smallest, largest: 0.5 * largest, mass: passing - before })
    };
    rows.windows(2).map(class).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<Class>, Flaw> {
        Csv::parse(text, &COLUMNS, &COLUMNS).and_then(|csv| classes(&csv))
    }

    #[test]
    fn a_curve_becomes_classes_of_radii() {
        let curve = read("diameter[m],passing[-]\n2e-3,0\n4e-3,0.25\n8e-3,1\n").unwrap();
        assert_eq!(
            curve,
            [
                Class { smallest: 1e-3, largest: 2e-3, mass: 0.25 },
                Class { smallest: 2e-3, largest: 4e-3, mass: 0.75 }
            ]
        );
    }

    #[test]
    fn a_curve_that_is_none_says_where() {
        let error =
            |rows: &str| format!("a.csv{}", read(&format!("diameter[m],passing[-]\n{rows}")).unwrap_err());
        assert_eq!(error(""), "a.csv: holds no row; a sieve curve needs two or more");
        assert_eq!(error("0,0\n1,1\n"), "a.csv:2: diameter[m]: found 0; it must be positive");
        assert!(
            error("1,0.1\n2,1\n").starts_with("a.csv:2: passing[-]: found 0.1; a sieve curve starts with 0")
        );
        assert!(error("1,0\n2,0.9\n").starts_with("a.csv:3: passing[-]: found 0.9"));
        assert_eq!(error("1,0\n3,0.5\n2,1\n"), "a.csv:4: (2, 1) does not ascend from (3, 0.5)");
    }
}
