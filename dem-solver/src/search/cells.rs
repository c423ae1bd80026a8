//! Grains sorted into the cells of a uniform grid by counting.

use crate::domain::{Domain, Image};
use crate::grains::Place;
use crate::vector::Vector;

/// No more cells than this many per grain.
const CELLS_PER_GRAIN: usize = 4;

/// A grid of cells no narrower than a stated width, and the grains in each cell.
///
/// Along periodic axes the grid spans the domain, else the grains.
#[derive(Clone, Debug)]
pub struct Cells<const D: usize> {
    lower: Vector<D>,
    width: Vector<D>,
    counts: [usize; D],
    periodic: [bool; D],
    start: Vec<u32>,
    rows: Vec<u32>,
}

impl<const D: usize> Cells<D> {
    /// The grid with cells of at least this width \[m\].
    pub fn new(places: &[Place<D>], domain: &Domain<D>, narrowest: f64) -> Self {
        let around = places
            .iter()
            .map(|place| (place.centre, place.centre))
            .reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
            .unwrap_or((Vector::zeros(), Vector::zeros()));
        let end = |bounds: &Vector<D>, grains: &Vector<D>| {
            Vector::from_fn(|axis, _| if domain.periodic[axis] { bounds[axis] } else { grains[axis] })
        };
        let (lower, upper) = (end(&domain.lower, &around.0), end(&domain.upper, &around.1));
        let extent: Vector<D> = upper - lower;
        // As a float: a grain far away must not make a grid that no memory holds.
        let most = (CELLS_PER_GRAIN * places.len().max(16)) as f64;
        let number =
            |width: f64| -> f64 { extent.iter().map(|length| (length / width).floor().max(1.0)).product() };
        let mut narrowest = narrowest;
        while number(narrowest) > most {
            narrowest *= 1.25;
        }
        let counts: [usize; D] =
            std::array::from_fn(|axis| ((extent[axis] / narrowest).floor() as usize).max(1));
        let width = Vector::from_fn(|axis, _| (extent[axis] / counts[axis] as f64).max(f64::MIN_POSITIVE));
        let mut cells = Self { lower, width, counts, periodic: domain.periodic, start: vec![], rows: vec![] };
        cells.sort(places);
        cells
    }

    /// The grains, cell by cell.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// Visits all grains in the cell of this place and the cells around it, with the image each is seen in.
    pub fn visit_around(&self, centre: &Vector<D>, mut visit: impl FnMut(u32, Image)) {
        let home = self.coordinates(centre);
        for code in 0..3_usize.pow(D as u32) {
            let mut at = [0; D];
            let mut periods = [0; D];
            let mut outside = false;
            for axis in 0..D {
                let offset = (code / 3_usize.pow(axis as u32)) % 3;
                let count = self.counts[axis];
                let shifted = home[axis] + offset;
                (at[axis], periods[axis]) = match shifted {
                    0 => (count - 1, -1),
                    s if s == count + 1 => (0, 1),
                    s => (s - 1, 0),
                };
                outside |= periods[axis] != 0 && !self.periodic[axis];
            }
            if !outside {
                let cell = self.index(&at);
                let image = Image::new(periods);
                for &row in &self.rows[self.start[cell] as usize..self.start[cell + 1] as usize] {
                    visit(row, image);
                }
            }
        }
    }

    fn sort(&mut self, places: &[Place<D>]) {
        let cell: Vec<u32> =
            places.iter().map(|place| self.index(&self.coordinates(&place.centre)) as u32).collect();
        let cells: usize = self.counts.iter().product();
        self.start = vec![0; cells + 1];
        for &cell in &cell {
            self.start[cell as usize + 1] += 1;
        }
        for k in 0..cells {
            self.start[k + 1] += self.start[k];
        }
        let mut next = self.start.clone();
        self.rows = vec![0; places.len()];
        for (row, &cell) in cell.iter().enumerate() {
            self.rows[next[cell as usize] as usize] = row as u32;
            next[cell as usize] += 1;
        }
    }

    fn coordinates(&self, centre: &Vector<D>) -> [usize; D] {
        std::array::from_fn(|axis| {
            let cell = ((centre[axis] - self.lower[axis]) / self.width[axis]).max(0.0) as usize;
            cell.min(self.counts[axis] - 1)
        })
    }

    fn index(&self, at: &[usize; D]) -> usize {
        at.iter().zip(&self.counts).fold(0, |index, (a, n)| index * n + a)
    }
}
