//! Grains from a file: CSV with units in the header, or a LIGGGHTS text dump.

use std::fs;
use std::path::Path;

use crate::error::DemError;
use crate::flaw::Flaw;

/// A grain as a file states it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileGrain {
    /// Centre \[m\]; z = 0 where the file has none.
    pub centre: [f64; 3],
    /// Velocity \[m/s\], if stated.
    pub velocity: Option<[f64; 3]>,
    /// Radius \[m\], if stated.
    pub radius: Option<f64>,
}

const CSV_COLUMNS: [&str; 7] = ["x[m]", "y[m]", "z[m]", "vx[m/s]", "vy[m/s]", "vz[m/s]", "diameter[m]"];
const DUMP_COLUMNS: [&str; 7] = ["x", "y", "z", "vx", "vy", "vz", "radius"];

/// Reads the grains of a file; of a dump with several snapshots the last.
///
/// # Errors
/// A file that cannot be read, has no grain, lacks x or y, or holds a value that is no finite number.
pub fn read_grains(path: &Path) -> Result<Vec<FileGrain>, DemError> {
    let text =
        fs::read_to_string(path).map_err(|source| DemError::Unreadable { path: path.into(), source })?;
    let grains = if text.starts_with("ITEM:") { read_dump(&text) } else { read_csv(&text) };
    let bad = |flaw: Flaw| DemError::BadFile { path: path.into(), flaw };
    match grains {
        Ok(grains) if grains.is_empty() => Err(bad(Flaw::whole("holds no grain; it needs at least one row"))),
        Ok(grains) => Ok(grains),
        Err(flaw) => Err(bad(flaw)),
    }
}

fn read_csv(text: &str) -> Result<Vec<FileGrain>, Flaw> {
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    let header = lines.next().map_or("", |(_, line)| line);
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    if let Some(unknown) = names.iter().find(|name| !CSV_COLUMNS.contains(name)) {
        return Err(Flaw::at(1, format!("unknown column {unknown:?}; allowed: {}", CSV_COLUMNS.join(", "))));
    }
    let columns = Columns::of(1, &names, &CSV_COLUMNS)?;
    let rows = lines.filter(|(_, line)| !line.trim().is_empty());
    rows.map(|(number, line)| columns.grain(number, line.split(',').map(str::trim), 0.5)).collect()
}

fn read_dump(text: &str) -> Result<Vec<FileGrain>, Flaw> {
    let lines: Vec<&str> = text.lines().collect();
    let start = lines
        .iter()
        .rposition(|line| line.starts_with("ITEM: ATOMS"))
        .ok_or_else(|| Flaw::whole("no line \"ITEM: ATOMS\"; a LIGGGHTS dump has one before its rows"))?;
    let names: Vec<&str> = lines[start].split_whitespace().skip(2).collect();
    let columns = Columns::of(start + 1, &names, &DUMP_COLUMNS)?;
    let rows = lines.iter().enumerate().skip(start + 1).filter(|(_, line)| !line.trim().is_empty());
    let grains: Vec<_> = rows
        .map(|(index, line)| columns.grain(index + 1, line.split_whitespace(), 1.0))
        .collect::<Result<_, _>>()?;
    let stated = lines[..start].iter().rposition(|line| line.starts_with("ITEM: NUMBER OF ATOMS"));
    let stated = stated.and_then(|at| lines[at + 1].trim().parse::<usize>().ok());
    match stated {
        Some(count) if count != grains.len() => Err(Flaw::whole(format!(
            "{} rows where {count} are announced; the dump was cut short, write it again",
            grains.len()
        ))),
        _ => Ok(grains),
    }
}

/// Where each of x, y, z, vx, vy, vz and the size stands in a row.
struct Columns<'a> {
    names: &'a [&'a str; 7],
    at: [Option<usize>; 7],
    width: usize,
}

impl<'a> Columns<'a> {
    fn of(line: usize, names: &[&str], wanted: &'a [&'a str; 7]) -> Result<Self, Flaw> {
        let at = wanted.map(|wanted| names.iter().position(|name| *name == wanted));
        match at[..2].iter().position(Option::is_none) {
            Some(missing) => {
                Err(Flaw::at(line, format!("no column {:?}; found: {}", wanted[missing], names.join(", "))))
            }
            None => Ok(Self { names: wanted, at, width: names.len() }),
        }
    }

    fn grain<'l>(
        &self,
        line: usize,
        cells: impl Iterator<Item = &'l str>,
        radius_per_size: f64,
    ) -> Result<FileGrain, Flaw> {
        let cells: Vec<&str> = cells.collect();
        if cells.len() != self.width {
            let what = format!("{} values where the header has {}", cells.len(), self.width);
            return Err(Flaw::at(line, what));
        }
        let value = |column: usize| match self.at[column] {
            None => Ok(None),
            Some(at) => match cells[at].parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(Some(value)),
                _ => {
                    let what = format!("{}: {:?} is not a finite number", self.names[column], cells[at]);
                    Err(Flaw::at(line, what))
                }
            },
        };
        let or_zero = |column: usize| value(column).map(Option::unwrap_or_default);
        let velocity = [or_zero(3)?, or_zero(4)?, or_zero(5)?];
        let moves = self.at[3..6].iter().any(Option::is_some);
        let radius = value(6)?.map(|size| size * radius_per_size);
        if let Some(radius) = radius.filter(|radius| *radius <= 0.0) {
            let what = format!("{}: a radius of {radius} m; it must be positive", self.names[6]);
            return Err(Flaw::at(line, what));
        }
        Ok(FileGrain {
            centre: [or_zero(0)?, or_zero(1)?, or_zero(2)?],
            velocity: moves.then_some(velocity),
            radius,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_csv_gives_places_velocities_and_radii() {
        let grains = read_csv("x[m],y[m],vx[m/s],diameter[m]\n1,2,3,0.5\n\n4,5,6,1e-3\n").unwrap();
        assert_eq!(
            grains[0],
            FileGrain { centre: [1.0, 2.0, 0.0], velocity: Some([3.0, 0.0, 0.0]), radius: Some(0.25) }
        );
        assert_eq!(grains[1].radius, Some(5e-4));
    }

    #[test]
    fn the_last_snapshot_of_a_dump_counts() {
        let snapshot = |x: f64| {
            format!(
                "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id type x y z radius \n1 1 {x} 0 0.5 0.1 \n"
            )
        };
        let grains = read_dump(&(snapshot(0.25) + &snapshot(0.75))).unwrap();
        assert_eq!(grains, [FileGrain { centre: [0.75, 0.0, 0.5], velocity: None, radius: Some(0.1) }]);
    }

    #[test]
    fn messages_name_line_and_column() {
        let error = |text: &str| format!("grains.csv{}", read_csv(text).unwrap_err());
        assert_eq!(error("x[m],y[m]\n1,oops\n"), "grains.csv:2: y[m]: \"oops\" is not a finite number");
        assert_eq!(error("x[m],y[m]\n1,nan\n"), "grains.csv:2: y[m]: \"nan\" is not a finite number");
        assert_eq!(error("x[m],y[m]\n1\n"), "grains.csv:2: 1 values where the header has 2");
        assert_eq!(error("x[m],z[m]\n1,2\n"), "grains.csv:1: no column \"y[m]\"; found: x[m], z[m]");
        assert!(error("x,y\n1,2\n").starts_with("grains.csv:1: unknown column \"x\"; allowed: x[m], "));
        assert_eq!(
            error("x[m],y[m],diameter[m]\n0,0,-1\n"),
            "grains.csv:2: diameter[m]: a radius of -0.5 m; it must be positive"
        );
        let dump = |text: &str| format!("a.dump{}", read_dump(text).unwrap_err());
        let head = "ITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS x y\n";
        assert!(dump(&format!("{head}1 2\n")).starts_with("a.dump: 1 rows where 2 are announced"));
        assert_eq!(dump(&format!("{head}1 2\n3 x\n")), "a.dump:5: y: \"x\" is not a finite number");
    }
}
