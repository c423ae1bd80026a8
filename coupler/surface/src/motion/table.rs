//! Motion by a table over time.

use std::path::Path;

use crate::csv::Csv;
use crate::error::InputError;
use crate::flaw::Flaw;
use crate::vector::{Spin, Vector};

const COLUMNS: [&str; 5] = ["t[s]", "x[m]", "y[m]", "z[m]", "angle[rad]"];

/// A row of a table of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableRow<const D: usize> {
    /// Time \[s\].
    pub time: f64,
    /// Displacement \[m\].
    pub displacement: Vector<D>,
    /// Angle \[rad\].
    pub angle: f64,
}

/// Displacement and angle, linear between rows; at rest before the first and after the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<const D: usize> {
    /// Unit vector along the axis of the angle; zero where the table has none.
    pub axis: Spin,
    rows: Vec<TableRow<D>>,
}

impl<const D: usize> Table<D> {
    /// The table of rows that ascend in time; displacement and angle count from the first row.
    pub fn new(axis: Spin, mut rows: Vec<TableRow<D>>) -> Self {
        if let Some(&first) = rows.first() {
            for row in &mut rows {
                row.displacement -= first.displacement;
                row.angle -= first.angle;
            }
        }
        Self { axis, rows }
    }

    /// Reads the table from a csv file; it may have an angle only where there is an axis.
    ///
    /// # Errors
    /// A file that cannot be read; fewer than two rows, times that do not ascend, an angle without axis.
    pub fn read(path: &Path, axis: Spin) -> Result<Self, InputError> {
        Csv::read(path, &COLUMNS, &COLUMNS[..1], |csv| Self::of(csv, axis))
    }

    fn of(csv: &Csv, axis: Spin) -> Result<Self, Flaw> {
        let unused = COLUMNS[1 + D..4].iter().find(|column| csv.has(column));
        if let Some(column) = unused {
            return Err(Flaw::at(1, format!("the column {column:?} has no effect in 2D; delete it")));
        }
        if csv.has(COLUMNS[4]) != (axis != Spin::zeros()) {
            let what = "a column \"angle[rad]\" and the keys of its axis go together; state both or none";
            return Err(Flaw::at(1, what.into()));
        }
        let mut rows: Vec<TableRow<D>> = Vec::new();
        for (line, [time, x, y, z, angle]) in csv.rows(COLUMNS) {
            if let Some(before) = rows.last().filter(|before| before.time >= time) {
                let what = format!("t[s]: {time} is not after the time before, {}", before.time);
                return Err(Flaw::at(line, what));
            }
            rows.push(TableRow { time, displacement: Vector::from_fn(|k, _| [x, y, z][k]), angle });
        }
        if rows.len() < 2 {
            return Err(Flaw::whole(format!("has {} rows; a table of motion needs 2 or more", rows.len())));
        }
        Ok(Self::new(axis, rows))
    }

    /// Displacement and angle at a time \[s\], and their rates \[m/s, rad/s\].
    pub(super) fn at(&self, time: f64) -> (TableRow<D>, TableRow<D>) {
        let rest = TableRow { time, displacement: Vector::zeros(), angle: 0.0 };
        let next = self.rows.partition_point(|row| row.time <= time);
        match (next.checked_sub(1).and_then(|last| self.rows.get(last)), self.rows.get(next)) {
            (None, _) => (rest, rest),
            (Some(last), None) => (TableRow { time, ..*last }, rest),
            (Some(last), Some(next)) => {
                let duration = next.time - last.time;
                let slope = TableRow {
                    time,
                    displacement: (next.displacement - last.displacement) / duration,
                    angle: (next.angle - last.angle) / duration,
                };
                let since = time - last.time;
                let row = TableRow {
                    time,
                    displacement: last.displacement + slope.displacement * since,
                    angle: last.angle + slope.angle * since,
                };
                (row, slope)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_met_and_joined_by_straight_lines() {
        let row =
            |time: f64, x: f64, angle: f64| TableRow { time, displacement: Vector::from([x, 0.0]), angle };
        let table = Table::new(Spin::z(), vec![row(1.0, 5.0, 0.5), row(2.0, 7.0, 0.5), row(4.0, 6.0, 1.5)]);
        let at = |time: f64| {
            let (place, rate) = table.at(time);
            [place.displacement.x, place.angle, rate.displacement.x, rate.angle]
        };
        assert_eq!(at(0.5), [0.0, 0.0, 0.0, 0.0]);
        assert_eq!(at(1.5), [1.0, 0.0, 2.0, 0.0]);
        assert_eq!(at(3.0), [1.5, 0.5, -0.5, 0.5]);
        assert_eq!(at(9.0), [1.0, 1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_file_that_is_no_table_of_motion_says_why() {
        let read = |text: &str, axis: Spin| {
            Csv::parse(text, &COLUMNS, &COLUMNS[..1]).and_then(|csv| Table::<2>::of(&csv, axis))
        };
        let table = read("t[s],y[m]\n0,1\n2,5\n", Spin::zeros()).unwrap();
        assert_eq!(table.at(1.0).0.displacement, Vector::from([0.0, 2.0]));
        let error = |text: &str| format!("lid.csv{}", read(text, Spin::zeros()).unwrap_err());
        assert_eq!(error("t[s]\n0\n"), "lid.csv: has 1 rows; a table of motion needs 2 or more");
        assert_eq!(error("t[s]\n0\n0\n"), "lid.csv:3: t[s]: 0 is not after the time before, 0");
        assert!(error("t[s],angle[rad]\n").contains("go together"));
        assert!(error("t[s],z[m]\n").contains("no effect in 2D"));
        assert!(read("t[s]\n0\n1\n", Spin::z()).is_err());
    }
}
