//! A uniform grid of bins over static items (cells, faces, nodes), each listed in every bin its box touches.

use crate::element::simplex::{Vector, distance};

/// Items by bin; along axis 0 the bins, and so their items, follow each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Bins<const D: usize> {
    lower: Vector<D>,
    width: Vector<D>,
    per_width: Vector<D>,
    counts: [usize; D],
    offsets: Vec<u32>,
    items: Vec<u32>,
}

/// Smallest box around points: lower and upper corner.
pub fn bounds<'a, const D: usize>(points: impl IntoIterator<Item = &'a Vector<D>>) -> (Vector<D>, Vector<D>) {
    points.into_iter().fold(([f64::INFINITY; D], [f64::NEG_INFINITY; D]), |(lower, upper), x| {
        (std::array::from_fn(|k| lower[k].min(x[k])), std::array::from_fn(|k| upper[k].max(x[k])))
    })
}

impl<const D: usize> Bins<D> {
    /// Sorts `count` items with the given boxes into about `target` cubic bins over the box `lower`–`upper`.
    ///
    /// Within a bin items are in ascending order.
    pub fn new(
        (lower, upper): (Vector<D>, Vector<D>),
        target: usize,
        count: usize,
        item_box: impl Fn(usize) -> (Vector<D>, Vector<D>),
    ) -> Self {
        let extent: Vector<D> = std::array::from_fn(|k| upper[k] - lower[k]);
        let counts = counts(&extent, target.max(1));
        let width: Vector<D> = std::array::from_fn(|k| (extent[k] / counts[k] as f64).max(f64::MIN_POSITIVE));
        let per_width = width.map(|w| w.recip());
        let total = counts.iter().product::<usize>();
        let mut bins =
            Self { lower, width, per_width, counts, offsets: vec![0; total + 1], items: Vec::new() };
        for item in 0..count {
            let (low, high) = bins.range(&item_box(item));
            for_each_index(&low, &high, |index| bins.offsets[flat(&bins.counts, index) + 1] += 1);
        }
        for bin in 0..total {
            bins.offsets[bin + 1] += bins.offsets[bin];
        }
        bins.items = vec![0; bins.offsets[total] as usize];
        let mut next = bins.offsets.clone();
        for item in 0..count {
            let (low, high) = bins.range(&item_box(item));
            for_each_index(&low, &high, |index| {
                let slot = &mut next[flat(&bins.counts, index)];
                bins.items[*slot as usize] = item as u32;
                *slot += 1;
            });
        }
        bins
    }

    /// Number of bins along each axis.
    pub fn counts(&self) -> &[usize; D] {
        &self.counts
    }

    /// Edge lengths of a bin.
    pub fn width(&self) -> &Vector<D> {
        &self.width
    }

    /// Lower corner of the grid.
    pub fn lower(&self) -> &Vector<D> {
        &self.lower
    }

    /// All items, in the order of the bins.
    pub fn items(&self) -> &[u32] {
        &self.items
    }

    /// Index of the bin a coordinate would fall into if the grid went on for ever.
    pub fn unbounded_index(&self, axis: usize, coordinate: f64) -> i64 {
        // `floor` without the library call that it is on the oldest x86-64.
        let exact = (coordinate - self.lower[axis]) * self.per_width[axis];
        let truncated = exact as i64;
        truncated - i64::from(truncated as f64 > exact)
    }

    /// The bin of a point, the nearest one if it lies outside the grid.
    pub fn index(&self, x: &Vector<D>) -> [usize; D] {
        std::array::from_fn(|k| self.unbounded_index(k, x[k]).clamp(0, self.counts[k] as i64 - 1) as usize)
    }

    /// Items of a bin.
    pub fn bin(&self, index: &[usize; D]) -> &[u32] {
        let bin = flat(&self.counts, index);
        &self.items[self.offsets[bin] as usize..self.offsets[bin + 1] as usize]
    }

    /// Range in [`Self::items`] of the bins `first..=last` of the row of bins through `index` along axis 0.
    pub fn row(&self, index: &[usize; D], first: usize, last: usize) -> std::ops::Range<usize> {
        let start = flat(&self.counts, index) - index[0];
        self.offsets[start + first] as usize..self.offsets[start + last + 1] as usize
    }

    /// The item of least `squared` distance to `x`, of equals the first, searched in growing shells of bins; none if there is
    /// no item. The items lie in the boxes they were sorted in by.
    pub fn nearest(&self, x: &Vector<D>, squared: impl Fn(u32) -> f64) -> Option<u32> {
        let home = self.index(x);
        let narrowest = self.width.iter().copied().fold(f64::INFINITY, f64::min);
        let clamped: Vector<D> = std::array::from_fn(|k| {
            x[k].clamp(self.lower[k], self.lower[k] + self.width[k] * self.counts[k] as f64)
        });
        let gap = distance(x, &clamped);
        let farthest = self.counts.iter().max().copied().unwrap_or(1);
        let mut best: Option<(f64, u32)> = None;
        for shell in 0..=farthest {
            // No item first met in this shell is nearer than this to the point of the grid nearest to x.
            let reach = (shell as f64 - 1.0).max(0.0) * narrowest;
            if best.is_some_and(|(found, _)| found < reach * reach + gap * gap) {
                break;
            }
            let low = std::array::from_fn(|k| home[k].saturating_sub(shell));
            let high = std::array::from_fn(|k| (home[k] + shell).min(self.counts[k] - 1));
            for_each_index(&low, &high, |index| {
                if (0..D).all(|k| index[k].abs_diff(home[k]) < shell) && shell > 0 {
                    return;
                }
                for &item in self.bin(index) {
                    let found = (squared(item), item);
                    if best.is_none_or(|best| found < best) {
                        best = Some(found);
                    }
                }
            });
        }
        best.map(|(_, item)| item)
    }

    fn range(&self, (lower, upper): &(Vector<D>, Vector<D>)) -> ([usize; D], [usize; D]) {
        (self.index(lower), self.index(upper))
    }
}

/// Bins per axis for cubes of equal size, about `target` in all, at least one per axis.
fn counts<const D: usize>(extent: &Vector<D>, target: usize) -> [usize; D] {
    let longest = extent.iter().copied().fold(0.0, f64::max);
    let mut width = longest;
    // Thin axes hold a single layer: their extent must not drive the width of the others.
    for _ in 0..D {
        let thick: Vec<f64> = extent.iter().copied().filter(|&e| e >= width && e > 0.0).collect();
        if !thick.is_empty() {
            width = (thick.iter().product::<f64>() / target as f64).powf(1.0 / thick.len() as f64);
        }
    }
    std::array::from_fn(|k| ((extent[k] / width) as usize).clamp(1, target))
}

fn flat<const D: usize>(counts: &[usize; D], index: &[usize; D]) -> usize {
    (0..D).rev().fold(0, |flat, k| flat * counts[k] + index[k])
}

/// Calls `visit` for every index of the box `low..=high`, axis 0 fastest.
pub fn for_each_index<const D: usize>(
    low: &[usize; D],
    high: &[usize; D],
    mut visit: impl FnMut(&[usize; D]),
) {
    let mut index = *low;
    loop {
        visit(&index);
        let Some(axis) = (0..D).find(|&k| index[k] < high[k]) else { return };
        index[axis] += 1;
        index[..axis].copy_from_slice(&low[..axis]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_listed_in_every_bin_its_box_touches() {
        let boxes = [([0.1, 0.1], [0.2, 0.9]), ([0.0, 0.0], [1.0, 1.0]), ([0.9, 0.9], [0.95, 0.95])];
        let bins = Bins::new(([0.0; 2], [1.0; 2]), 16, 3, |i| boxes[i]);
        assert_eq!(bins.counts(), &[4, 4]);
        assert_eq!(bins.bin(&[0, 2]), &[0, 1]);
        assert_eq!(bins.bin(&[3, 3]), &[1, 2]);
        assert_eq!(bins.bin(&[2, 1]), &[1]);
        assert_eq!(bins.row(&[2, 3], 0, 3).len(), 6);
    }

    #[test]
    fn a_point_outside_falls_into_the_nearest_bin_and_nan_into_the_first() {
        let bins = Bins::new(([0.0; 2], [1.0; 2]), 16, 0, |_| unreachable!());
        assert_eq!(bins.index(&[-5.0, 1e300]), [0, 3]);
        assert_eq!(bins.index(&[f64::NAN, 0.5]), [0, 2]);
    }

    #[test]
    fn a_thin_slab_gets_one_layer_of_bins() {
        let bins = Bins::new(([0.0; 3], [1.0, 1.0, 1e-9]), 100, 0, |_| unreachable!());
        assert_eq!(bins.counts(), &[10, 10, 1]);
    }
}
