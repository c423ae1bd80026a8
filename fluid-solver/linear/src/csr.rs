//! Scalar sparse matrix.

use crate::parallel::{ROWS, for_each_chunk};
use crate::{Error, LinearOperator, Pattern};
use std::ops::Range;
use std::sync::Arc;

/// Sparse matrix in compressed rows: one value per entry of a shared pattern.
#[derive(Debug, Clone)]
pub struct Csr {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
}

impl Csr {
    /// Zero matrix on a pattern.
    pub fn zeros(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.entries()];
        Self { pattern, values }
    }

    /// Matrix with the given values, in the order of the slots of the pattern.
    ///
    /// # Errors
    /// Another number of values than the pattern has entries.
    pub fn new(pattern: Arc<Pattern>, values: Vec<f64>) -> Result<Self, Error> {
        if values.len() == pattern.entries() {
            Ok(Self { pattern, values })
        } else {
            Err(Error::ValueCount { values: values.len(), entries: pattern.entries() })
        }
    }

    /// The shared pattern.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.pattern.rows()
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.pattern.columns()
    }

    /// Values by slot.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Values by slot, for assembly with slots computed once.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Columns and values of a row.
    #[inline]
    pub fn row(&self, row: usize) -> (&[u32], &[f64]) {
        (self.pattern.row(row), &self.values[self.pattern.slots(row)])
    }

    /// The coefficient at a place; zero where the pattern has no entry.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        self.pattern.slot(row, column).map_or(0.0, |slot| self.values[slot])
    }

    /// Adds to a coefficient.
    ///
    /// # Panics
    /// If the pattern has no such entry: the matrix and the elements assembled into it belong to different meshes.
    #[inline]
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let slot = self.pattern.slot(row, column);
        self.values[slot.unwrap_or_else(|| panic!("no entry ({row}, {column}) in the pattern"))] += value;
    }

    /// y ← A x.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        self.product(x, y, |_, sum| sum);
    }

    /// y ← y + A x.
    pub fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        self.product(x, y, |y, sum| y + sum);
    }

    /// y ← y − A x.
    pub fn multiply_subtract(&self, x: &[f64], y: &mut [f64]) {
        self.product(x, y, |y, sum| y - sum);
    }

    /// yᵢ ← combine(yᵢ, Σⱼ Aᵢⱼ xⱼ).
    fn product(&self, x: &[f64], y: &mut [f64], combine: impl Fn(f64, f64) -> f64 + Sync + Send) {
        assert_eq!(x.len(), self.columns(), "vector to multiply");
        assert_eq!(y.len(), self.rows(), "product vector");
        for_each_chunk(y, |first, y| {
            for (i, y) in (first..).zip(y) {
                *y = combine(*y, sparse_dot(self.row(i), x));
            }
        });
    }

    /// The transpose, on a pattern of its own.
    pub fn transpose(&self) -> Self {
        let (pattern, source) = self.pattern.transpose();
        let values = source.iter().map(|&slot| self.values[slot as usize]).collect();
        Self { pattern: Arc::new(pattern), values }
    }

    /// The diagonal, with zeros where the pattern has none.
    pub fn diagonal(&self) -> Vec<f64> {
        (0..self.rows()).map(|i| self.get(i, i)).collect()
    }

    /// Confirms that every coefficient is finite.
    ///
    /// # Errors
    /// The first coefficient that is not.
    pub fn require_finite(&self) -> Result<(), Error> {
        // One addition per value finds the rare fault; only then is it worth looking where.
        if (self.values.iter().fold(0.0, |faults, value| faults + value * 0.0)) == 0.0 {
            return Ok(());
        }
        for row in 0..self.rows() {
            for (&column, &value) in self.pattern.row(row).iter().zip(self.row(row).1) {
                if !value.is_finite() {
                    return Err(Error::NonFinite { row, column: column as usize, value });
                }
            }
        }
        Ok(())
    }

    /// Values of the entries of `ROWS` rows at a time, with the rows they belong to.
    pub(crate) fn values_by_chunk_of_rows(&mut self) -> Vec<(Range<usize>, &mut [f64])> {
        let (rows, mut rest) = (self.rows(), self.values.as_mut_slice());
        let mut chunks = Vec::with_capacity(rows.div_ceil(ROWS));
        for first in (0..rows).step_by(ROWS) {
            let end = rows.min(first + ROWS);
            let entries = self.pattern.slots(end - 1).end - self.pattern.slots(first).start;
            let (chunk, after) = rest.split_at_mut(entries);
            chunks.push((first..end, chunk));
            rest = after;
        }
        chunks
    }
}

/// Σⱼ aⱼ xⱼ over the entries of a row, or of a part of it.
#[inline]
pub(crate) fn sparse_dot((columns, values): (&[u32], &[f64]), x: &[f64]) -> f64 {
    columns.iter().zip(values).map(|(&j, a)| a * x[j as usize]).sum()
}

impl LinearOperator for Csr {
    fn size(&self) -> usize {
        assert_eq!(self.rows(), self.columns(), "an operator is square");
        self.rows()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.multiply(x, y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// [1 2 0; 0 0 3]
    fn wide() -> Csr {
        let pattern = Pattern::from_rows(3, [&[0u32, 1][..], &[2]]).unwrap();
        Csr::new(Arc::new(pattern), vec![1.0, 2.0, 3.0]).unwrap()
    }

    #[test]
    fn products_agree_with_hand_computation() {
        let (x, mut y) = ([1.0, 10.0, 100.0], [f64::NAN; 2]);
        wide().multiply(&x, &mut y);
        assert_eq!(y, [21.0, 300.0]);
        wide().multiply_add(&x, &mut y);
        assert_eq!(y, [42.0, 600.0]);
        wide().multiply_subtract(&x, &mut y);
        assert_eq!(y, [21.0, 300.0]);
    }

    #[test]
    fn the_transpose_is_the_adjoint() {
        let (a, x, w) = (wide(), [0.3, -1.0, 7.0], [2.0, -5.0]);
        let (mut ax, mut atw) = ([0.0; 2], [0.0; 3]);
        a.multiply(&x, &mut ax);
        a.transpose().multiply(&w, &mut atw);
        assert_eq!(crate::vector::dot(&ax, &w), crate::vector::dot(&x, &atw));
    }

    #[test]
    fn assembly_by_place_and_by_slot_agree() {
        let mut a = wide();
        a.add(0, 1, 5.0);
        let slot = a.pattern().slot(1, 2).unwrap();
        a.values_mut()[slot] -= 1.0;
        assert_eq!((a.get(0, 1), a.get(1, 2), a.get(1, 0)), (7.0, 2.0, 0.0));
        assert_eq!(a.diagonal(), [1.0, 0.0]);
    }

    #[test]
    fn a_non_finite_coefficient_is_found_with_its_place() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut a = wide();
            a.values_mut()[2] = bad;
            assert!(matches!(a.require_finite(), Err(Error::NonFinite { row: 1, column: 2, .. })));
        }
        assert_eq!(wide().require_finite(), Ok(()));
        let huge = Csr::new(wide().pattern().clone(), vec![f64::MAX; 3]).unwrap();
        assert_eq!(huge.require_finite(), Ok(()));
    }

    #[test]
    fn values_must_be_as_many_as_entries() {
        let refused = Csr::new(wide().pattern().clone(), vec![0.0]);
        assert_eq!(refused.unwrap_err(), Error::ValueCount { values: 1, entries: 3 });
    }
}
