//! A quantity over time, and what is taken of it.

use std::cmp::Ordering;

use crate::nearest::did_you_mean;
use crate::output::series::{Column, Series, Title};

/// A quantity over time: rows in order of time, at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    time: Vec<f64>,
    values: Vec<f64>,
}

/// A span of time; open where nothing is stated.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Window {
    pub from: Option<f64>,
    pub to: Option<f64>,
}

impl Trace {
    /// The column of that title over the first column, time.
    pub(super) fn of(series: &Series, title: &Title) -> Result<Self, String> {
        let time = series.time().map_or(&[][..], |column| &column.values);
        Self::new(time.to_vec(), column(series.columns(), title)?.values.clone())
    }

    /// Joins times (s, ascending) and values.
    ///
    /// # Errors
    /// No rows, columns of different length, or a time that does not ascend.
    pub fn new(time: Vec<f64>, values: Vec<f64>) -> Result<Self, String> {
        if time.is_empty() {
            return Err("there are no rows".into());
        }
        if time.len() != values.len() {
            return Err(format!("there are {} times and {} values", time.len(), values.len()));
        }
        match (1..time.len()).find(|&row| time[row].partial_cmp(&time[row - 1]) != Some(Ordering::Greater)) {
            Some(row) => {
                Err(format!("time does not ascend at row {}: {} after {}", row + 1, time[row], time[row - 1]))
            }
            None => Ok(Self { time, values }),
        }
    }

    /// The rows of a window; its ends are met to round-off of the times.
    pub(super) fn within(&self, window: Window) -> Result<Self, String> {
        let near = self.round_off();
        let inside = |time: f64| {
            window.from.is_none_or(|from| time >= from - near) && window.to.is_none_or(|to| time <= to + near)
        };
        let rows = (0..self.time.len()).filter(|&row| inside(self.time[row]));
        let (time, values) = rows.map(|row| (self.time[row], self.values[row])).unzip();
        Self::new(time, values).map_err(|_| {
            let end =
                |time: Option<f64>, open: &str| time.map_or(open.to_string(), |time| format!("{time} s"));
            let ends = [self.time[0], self.time[self.time.len() - 1]];
            format!(
                "there are no rows from {} to {}: they go from {} s to {} s",
                end(window.from, "the start"),
                end(window.to, "the end"),
                ends[0],
                ends[1]
            )
        })
    }

    fn round_off(&self) -> f64 {
        1e-9 * self.time.iter().fold(0.0, |largest: f64, time| largest.max(time.abs()))
    }

    /// The difference of another trace from this one, at this one's times, the other interpolated linearly.
    pub(super) fn error_of(&self, other: &Self) -> Result<Self, String> {
        let near = self.round_off();
        let (first, last) = (other.time[0], other.time[other.time.len() - 1]);
        let values: Result<Vec<f64>, String> = self
            .time
            .iter()
            .zip(&self.values)
            .map(|(&time, value)| {
                if time < first - near || time > last + near {
                    return Err(format!(
                        "the reference has a row at {time} s, the run goes from {first} s to {last} s"
                    ));
                }
                Ok(other.at(time) - value)
            })
            .collect();
        Ok(Self { time: self.time.clone(), values: values? })
    }

    /// Linear interpolation; the end values beyond the ends.
    fn at(&self, time: f64) -> f64 {
        let after = self.time.partition_point(|&t| t < time);
        if after == 0 {
            return self.values[0];
        }
        if after == self.time.len() {
            return self.values[after - 1];
        }
        let share = (time - self.time[after - 1]) / (self.time[after] - self.time[after - 1]);
        (1.0 - share) * self.values[after - 1] + share * self.values[after]
    }

    /// (1/T) ∫ f(value) dt by the trapezoidal rule; f of the value where there is one row.
    fn mean_of(&self, f: impl Fn(f64) -> f64) -> f64 {
        let span = self.time[self.time.len() - 1] - self.time[0];
        if span == 0.0 {
            return f(self.values[0]);
        }
        let trapezoid = |row: usize| {
            0.5 * (f(self.values[row]) + f(self.values[row + 1])) * (self.time[row + 1] - self.time[row])
        };
        (0..self.time.len() - 1).map(trapezoid).sum::<f64>() / span
    }

    pub(super) fn mean(&self) -> f64 {
        self.mean_of(|value| value)
    }

    pub(super) fn root_mean_square(&self) -> f64 {
        self.mean_of(|value| value * value).sqrt()
    }

    pub(super) fn last(&self) -> f64 {
        self.values[self.values.len() - 1]
    }

    pub(super) fn largest(&self) -> f64 {
        self.reduce(f64::max)
    }

    pub(super) fn smallest(&self) -> f64 {
        self.reduce(f64::min)
    }

    pub(super) fn largest_magnitude(&self) -> f64 {
        self.reduce(|a, b| a.abs().max(b.abs())).abs()
    }

    /// Joins all values; a NaN anywhere is the result.
    fn reduce(&self, join: fn(f64, f64) -> f64) -> f64 {
        if self.values.iter().any(|value| value.is_nan()) {
            return f64::NAN;
        }
        self.values.iter().copied().reduce(join).unwrap_or(f64::NAN)
    }
}

/// The column of that title.
pub(super) fn column<'a>(columns: &'a [Column], title: &Title) -> Result<&'a Column, String> {
    columns.iter().find(|column| column.title == *title).ok_or_else(|| {
        let known: Vec<String> = columns.iter().map(|column| column.title.to_string()).collect();
        let near = did_you_mean(&title.to_string(), &known);
        let problem = format!("there is no column {title}; allowed: {}; {near}", known.join(", "));
        problem.trim_end_matches("; ").into()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trace(rows: &[(f64, f64)]) -> Trace {
        Trace::new(rows.iter().map(|row| row.0).collect(), rows.iter().map(|row| row.1).collect()).unwrap()
    }

    #[test]
    fn the_mean_is_over_time_not_over_rows() {
        // v = t on uneven rows: mean 1/2, mean square by trapezoids slightly above 1/3.
        let ramp = trace(&[(0.0, 0.0), (0.1, 0.1), (0.2, 0.2), (0.3, 0.3), (1.0, 1.0)]);
        assert!((ramp.mean() - 0.5).abs() < 1e-15);
        let fine =
            trace(&(0..=1000).map(|k| (f64::from(k) / 1000.0, f64::from(k) / 1000.0)).collect::<Vec<_>>());
        assert!((fine.root_mean_square().powi(2) - 1.0 / 3.0).abs() < 1e-6);
        assert_eq!(trace(&[(3.0, -2.0)]).mean(), -2.0);
    }

    #[test]
    fn extremes_are_signed_and_the_magnitude_is_not() {
        let wave = trace(&[(0.0, 1.0), (1.0, -3.0), (2.0, 2.0)]);
        assert_eq!(
            (wave.largest(), wave.smallest(), wave.largest_magnitude(), wave.last()),
            (2.0, -3.0, 3.0, 2.0)
        );
        let spoilt = trace(&[(0.0, 1.0), (1.0, f64::NAN), (2.0, 2.0)]);
        assert!(spoilt.largest().is_nan() && spoilt.smallest().is_nan() && spoilt.mean().is_nan());
    }

    #[test]
    fn the_error_is_taken_at_the_rows_of_the_reference() {
        let reference = trace(&[(0.5, 1.0), (1.5, 2.0)]);
        let run = trace(&[(0.0, 0.0), (1.0, 2.0), (2.0, 4.0)]);
        assert_eq!(reference.error_of(&run).unwrap(), trace(&[(0.5, 0.0), (1.5, 1.0)]));
        let late = trace(&[(0.5, 1.0), (2.5, 2.0)]);
        assert_eq!(
            late.error_of(&run).unwrap_err(),
            "the reference has a row at 2.5 s, the run goes from 0 s to 2 s"
        );
    }

    #[test]
    fn a_window_keeps_its_ends() {
        let run = trace(&[(0.0, 0.0), (0.1 + 0.2, 1.0), (1.0, 2.0)]);
        let window = Window { from: Some(0.3), to: Some(0.3) };
        assert_eq!(run.within(window).unwrap().last(), 1.0);
        assert_eq!(run.within(Window::default()).unwrap(), run);
        let empty = Window { from: Some(0.4), to: Some(0.5) };
        assert_eq!(
            run.within(empty).unwrap_err(),
            "there are no rows from 0.4 s to 0.5 s: they go from 0 s to 1 s"
        );
    }

    #[test]
    fn times_ascend() {
        assert_eq!(Trace::new(vec![], vec![]).unwrap_err(), "there are no rows");
        assert_eq!(Trace::new(vec![0.0], vec![]).unwrap_err(), "there are 1 times and 0 values");
        assert_eq!(
            Trace::new(vec![0.0, 1.0, 1.0], vec![0.0; 3]).unwrap_err(),
            "time does not ascend at row 3: 1 after 1"
        );
        assert!(Trace::new(vec![0.0, f64::NAN], vec![0.0; 2]).is_err());
    }
}
