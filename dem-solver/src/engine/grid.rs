//! Grains sorted into the cells of a grid by counting, their places column by column.

use super::periods::Periods;
use crate::grains::{AsRows, Grains, Place};

/// No more cells than this many per grain.
const CELLS_PER_GRAIN: usize = 4;

/// Numbers that lanes may read past the last grain.
const PADDING: usize = 8;

/// A grid of cells no narrower than a stated width; along periodic axes it spans the domain, else the grains.
#[derive(Clone, Debug)]
pub struct Grid {
    lower: [f64; 3],
    inverse_width: [f64; 3],
    counts: [usize; 3],
    periodic: [bool; 3],
    start: Vec<u32>,
    /// The grains, cell by cell.
    pub order: Vec<u32>,
    /// x, y, z and r in that order, padded.
    pub columns: [Vec<f64>; 4],
}

impl Grid {
    /// The grid of these rows with cells of at least this width \[m\].
    pub fn new(grains: &Grains, rows: &[u32], periods: &Periods, narrowest: f64) -> Self {
        let (mut lower, mut upper) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &row in rows {
            let centre = &grains.place[row as usize].centre;
            for axis in 0..3 {
                lower[axis] = lower[axis].min(centre[axis]);
                upper[axis] = upper[axis].max(centre[axis]);
            }
        }
        for axis in 0..3 {
            if let Some((low, length)) = periods.axis(axis) {
                (lower[axis], upper[axis]) = (low, low + length);
            }
        }
        let extent: [f64; 3] = std::array::from_fn(|axis| (upper[axis] - lower[axis]).max(0.0));
        // As a float: a grain far away must not make a grid that no memory holds.
        let most = (CELLS_PER_GRAIN * rows.len().max(16)) as f64;
        let count = |length: f64, width: f64| (length / width).floor().max(1.0);
        let mut width = if rows.is_empty() { f64::INFINITY } else { narrowest };
        while extent.iter().map(|&length| count(length, width)).product::<f64>() > most {
            width *= 1.25;
        }
        let counts = extent.map(|length| count(length, width) as usize);
        let inverse_width =
            std::array::from_fn(|axis| counts[axis] as f64 / extent[axis].max(f64::MIN_POSITIVE));
        let periodic = std::array::from_fn(|axis| periods.axis(axis).is_some());
        let mut grid = Self {
            lower,
            inverse_width,
            counts,
            periodic,
            start: vec![],
            order: vec![],
            columns: Default::default(),
        };
        grid.sort(grains, rows);
        grid
    }

    /// The grid of all rows.
    pub fn of_all(grains: &Grains, periods: &Periods, narrowest: f64) -> Self {
        let rows: Vec<u32> = (0..grains.len() as u32).collect();
        Self::new(grains, &rows, periods, narrowest)
    }

    fn sort(&mut self, grains: &Grains, rows: &[u32]) {
        let cell_of: Vec<u32> =
            rows.iter().map(|&row| self.cell(&grains.place[row as usize]) as u32).collect();
        self.start = vec![0; self.counts.iter().product::<usize>() + 1];
        for &cell in &cell_of {
            self.start[cell as usize + 1] += 1;
        }
        for k in 1..self.start.len() {
            self.start[k] += self.start[k - 1];
        }
        let mut next = self.start.clone();
        self.order = vec![0; rows.len()];
        for (&row, &cell) in rows.iter().zip(&cell_of) {
            let place = &mut next[cell as usize];
            self.order[*place as usize] = row;
            *place += 1;
        }
        let places = grains.place.as_rows();
        self.columns = std::array::from_fn(|c| {
            let sorted = self.order.iter().map(|&row| places[row as usize].0[c]);
            sorted.chain(std::iter::repeat_n(f64::NAN, PADDING)).collect()
        });
    }

    /// The cell of a grain.
    fn cell(&self, place: &Place) -> usize {
        self.index(std::array::from_fn(|axis| {
            let cell = ((place.centre[axis] - self.lower[axis]) * self.inverse_width[axis]).max(0.0) as usize;
            cell.min(self.counts[axis] - 1)
        }))
    }

    /// Visits the rows of all cells nearer to a grain's centre than `reach` \[m\].
    pub fn visit_around(&self, place: &Place, reach: f64, mut visit: impl FnMut(usize)) {
        let mut runs = Vec::new();
        self.around(place, reach, &mut runs);
        let rows = runs.iter().flat_map(|&(begin, end)| &self.order[begin as usize..end as usize]);
        rows.for_each(|&row| visit(row as usize));
    }

    /// The grains of all cells nearer to a grain's centre than `reach` \[m\], as ranges of [`Self::order`].
    pub fn around(&self, place: &Place, reach: f64, runs: &mut Vec<(u32, u32)>) {
        runs.clear();
        let [xs, ys, zs] = std::array::from_fn(|axis| self.reached(axis, place.centre[axis], reach));
        for x in xs {
            for y in ys.clone() {
                for z in zs.clone() {
                    let k = self.index([self.wrapped(0, x), self.wrapped(1, y), self.wrapped(2, z)]);
                    let (begin, end) = (self.start[k], self.start[k + 1]);
                    match runs.last_mut() {
                        Some(last) if last.1 == begin => last.1 = end,
                        _ if begin < end => runs.push((begin, end)),
                        _ => {}
                    }
                }
            }
        }
    }

    /// The cells along an axis that are nearer than `reach`; beyond the ends of a periodic one they are counted on.
    fn reached(&self, axis: usize, x: f64, reach: f64) -> std::ops::RangeInclusive<i64> {
        let last = self.counts[axis] as i64 - 1;
        let cell = |x: f64| ((x - self.lower[axis]) * self.inverse_width[axis]).floor() as i64;
        let (begin, end) = (cell(x - reach), cell(x + reach));
        if !self.periodic[axis] {
            begin.clamp(0, last)..=end.clamp(0, last)
        } else if end - begin >= last {
            0..=last
        } else {
            begin..=end
        }
    }

    fn wrapped(&self, axis: usize, cell: i64) -> usize {
        cell.rem_euclid(self.counts[axis] as i64) as usize
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (x * self.counts[1] + y) * self.counts[2] + z
    }
}
