//! A uniform grid of the facets' boxes.

use crate::vector::Vector;

/// No more bins than this many per facet.
const BINS_PER_FACET: f64 = 4.0;

/// For each bin of a grid, the facets whose box meets it.
#[derive(Clone, Debug, PartialEq)]
pub struct Bins<const D: usize> {
    lower: Vector<D>,
    upper: Vector<D>,
    width: Vector<D>,
    counts: [usize; D],
    start: Vec<u32>,
    facets: Vec<u32>,
}

impl<const D: usize> Bins<D> {
    /// The grid of the facets in these boxes; nothing if there are none.
    pub fn new(boxes: &[(Vector<D>, Vector<D>)]) -> Option<Self> {
        let (lower, upper) = boxes.iter().copied().reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))?;
        let extent: Vector<D> = upper - lower;
        let mean = boxes.iter().map(|(low, high)| (high - low).max()).sum::<f64>() / boxes.len() as f64;
        // Bins as wide as the mean facet, wider if that makes too many of them.
        let number =
            |width: f64| -> f64 { extent.iter().map(|length| (length / width).ceil().max(1.0)).product() };
        let mut width = mean;
        while number(width) > (BINS_PER_FACET * boxes.len() as f64).max(1.0) && width < extent.max() {
            width *= 1.25;
        }
        let counts: [usize; D] = std::array::from_fn(|axis| ((extent[axis] / width).ceil() as usize).max(1));
        let widths = Vector::from_fn(|axis, _| (extent[axis] / counts[axis] as f64).max(f64::MIN_POSITIVE));
        let mut bins = Self { lower, upper, width: widths, counts, start: vec![], facets: vec![] };
        let mut entries = Vec::new();
        for (facet, (low, high)) in boxes.iter().enumerate() {
            bins.each(low, high, |bin| entries.push((bin as u32, facet as u32)));
        }
        entries.sort_unstable();
        let total: usize = counts.iter().product();
        bins.start =
            (0..=total).map(|bin| entries.partition_point(|entry| (entry.0 as usize) < bin) as u32).collect();
        bins.facets = entries.into_iter().map(|entry| entry.1).collect();
        Some(bins)
    }

    /// Corners of the grid.
    pub fn bounds(&self) -> (Vector<D>, Vector<D>) {
        (self.lower, self.upper)
    }

    /// Visits the facets of all bins that meet the box of half width `reach` around `centre`, some more than once.
    pub fn visit(&self, centre: &Vector<D>, reach: f64, visit: impl FnMut(u32)) {
        self.visit_box(&centre.add_scalar(-reach), &centre.add_scalar(reach), visit);
    }

    /// Visits the facets of all bins that meet a box, some more than once.
    pub fn visit_box(&self, low: &Vector<D>, high: &Vector<D>, mut visit: impl FnMut(u32)) {
        if (0..D).any(|axis| high[axis] < self.lower[axis] || low[axis] > self.upper[axis]) {
            return;
        }
        self.each(low, high, |bin| {
            self.facets[self.start[bin] as usize..self.start[bin + 1] as usize]
                .iter()
                .for_each(|&facet| visit(facet));
        });
    }

    fn each(&self, low: &Vector<D>, high: &Vector<D>, mut visit: impl FnMut(usize)) {
        let bin = |x: f64, axis: usize| {
            (((x - self.lower[axis]) / self.width[axis]).floor().max(0.0) as usize).min(self.counts[axis] - 1)
        };
        let first: [usize; D] = std::array::from_fn(|axis| bin(low[axis], axis));
        let last: [usize; D] = std::array::from_fn(|axis| bin(high[axis], axis));
        let mut at = first;
        loop {
            visit(at.iter().zip(&self.counts).fold(0, |index, (a, n)| index * n + a));
            let Some(axis) = (0..D).rev().find(|&axis| at[axis] < last[axis]) else { return };
            at[axis] += 1;
            at[axis + 1..].copy_from_slice(&first[axis + 1..]);
        }
    }
}
