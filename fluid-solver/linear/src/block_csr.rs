//! Sparse matrix of small dense blocks.

use crate::dense::{self, Block};
use crate::parallel::for_each_chunk;
use crate::{Error, LinearOperator, Pattern};
use std::sync::Arc;

/// Sparse matrix with a dense R×C block per entry of a shared pattern.
///
/// R = C = D is a velocity matrix, R = D and C = 1 a gradient, R = 1 and C = D a divergence. Vectors are slices with
/// one array per node: `[[f64; C]]` in, `[[f64; R]]` out.
#[derive(Debug, Clone)]
pub struct BlockCsr<const R: usize, const C: usize = R> {
    pattern: Arc<Pattern>,
    blocks: Vec<Block<R, C>>,
}

impl<const R: usize, const C: usize> BlockCsr<R, C> {
    /// Zero matrix on a pattern of nodes.
    pub fn zeros(pattern: Arc<Pattern>) -> Self {
        let blocks = vec![[[0.0; C]; R]; pattern.entries()];
        Self { pattern, blocks }
    }

    /// The shared pattern of nodes.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Blocks by slot.
    pub fn blocks(&self) -> &[Block<R, C>] {
        &self.blocks
    }

    /// Blocks by slot, for assembly with slots computed once.
    pub fn blocks_mut(&mut self) -> &mut [Block<R, C>] {
        &mut self.blocks
    }

    /// Columns and blocks of a row.
    #[inline]
    pub fn row(&self, row: usize) -> (&[u32], &[Block<R, C>]) {
        (self.pattern.row(row), &self.blocks[self.pattern.slots(row)])
    }

    /// Adds to a block.
    ///
    /// # Panics
    /// If the pattern has no such entry: the matrix and the elements assembled into it belong to different meshes.
    #[inline]
    pub fn add(&mut self, row: usize, column: usize, block: &Block<R, C>) {
        let slot = self.pattern.slot(row, column);
        let target =
            &mut self.blocks[slot.unwrap_or_else(|| panic!("no entry ({row}, {column}) in the pattern"))];
        for (target, source) in target.as_flattened_mut().iter_mut().zip(block.as_flattened()) {
            *target += source;
        }
    }

    /// y ← A x.
    pub fn multiply(&self, x: &[[f64; C]], y: &mut [[f64; R]]) {
        self.product(x, y, |_, sum| sum);
    }

    /// y ← y + A x.
    pub fn multiply_add(&self, x: &[[f64; C]], y: &mut [[f64; R]]) {
        self.product(x, y, |y, sum| y + sum);
    }

    /// y ← y − A x.
    pub fn multiply_subtract(&self, x: &[[f64; C]], y: &mut [[f64; R]]) {
        self.product(x, y, |y, sum| y - sum);
    }

    /// yᵢ ← combine(yᵢ, Σⱼ Aᵢⱼ xⱼ), by component.
    fn product(&self, x: &[[f64; C]], y: &mut [[f64; R]], combine: impl Fn(f64, f64) -> f64 + Sync + Send) {
        assert_eq!(x.len(), self.pattern.columns(), "vector to multiply");
        assert_eq!(y.len(), self.pattern.rows(), "product vector");
        for_each_chunk(y, |first, y| {
            for (i, y) in (first..).zip(y) {
                let sum = block_dot(self.row(i), x);
                for (y, sum) in y.iter_mut().zip(sum) {
                    *y = combine(*y, sum);
                }
            }
        });
    }

    /// Confirms that every coefficient is finite.
    ///
    /// # Errors
    /// The first coefficient that is not; row and column count nodes.
    pub fn require_finite(&self) -> Result<(), Error> {
        for row in 0..self.pattern.rows() {
            let (columns, blocks) = self.row(row);
            for (&column, block) in columns.iter().zip(blocks) {
                if let Some(&value) = block.as_flattened().iter().find(|value| !value.is_finite()) {
                    return Err(Error::NonFinite { row, column: column as usize, value });
                }
            }
        }
        Ok(())
    }
}

impl<const B: usize> BlockCsr<B, B> {
    /// Inverse of the diagonal block of each row.
    ///
    /// # Errors
    /// A coefficient that is not finite; a diagonal block that is missing or singular, with its row.
    pub fn inverse_diagonal(&self) -> Result<Vec<Block<B>>, Error> {
        self.require_finite()?;
        let slots = self.pattern.diagonal_slots()?;
        let inverse = |(row, &slot): (usize, &u32)| {
            dense::inverse(&self.blocks[slot as usize]).ok_or(Error::SingularDiagonal { row })
        };
        slots.iter().enumerate().map(inverse).collect()
    }
}

/// Σⱼ Aⱼ xⱼ over the entries of a row, or of a part of it.
#[inline]
pub(crate) fn block_dot<const R: usize, const C: usize>(
    (columns, blocks): (&[u32], &[Block<R, C>]),
    x: &[[f64; C]],
) -> [f64; R] {
    let mut sum = [0.0; R];
    for (&j, block) in columns.iter().zip(blocks) {
        dense::multiply_add(block, &x[j as usize], &mut sum);
    }
    sum
}

impl<const B: usize> LinearOperator for BlockCsr<B, B> {
    fn size(&self) -> usize {
        assert_eq!(self.pattern.rows(), self.pattern.columns(), "an operator is square");
        B * self.pattern.rows()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.multiply(dense::by_node(x), dense::by_node_mut(y));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gradient_and_its_transpose_are_adjoint() {
        let pattern = Arc::new(Pattern::from_elements(3, [[0, 1], [1, 2]]).unwrap());
        let mut gradient = BlockCsr::<2, 1>::zeros(pattern.clone());
        let mut divergence = BlockCsr::<1, 2>::zeros(pattern);
        for (i, j, value) in [(0, 1, [2.0, -1.0]), (1, 1, [0.5, 4.0]), (2, 1, [3.0, 3.0]), (1, 2, [1.0, 0.0])]
        {
            gradient.add(i, j, &value.map(|v| [v]));
            divergence.add(j, i, &[value]);
        }
        let (p, v) = ([[1.0], [-2.0], [3.0]], [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]);
        let (mut gp, mut dv) = ([[0.0; 2]; 3], [[0.0]; 3]);
        gradient.multiply(&p, &mut gp);
        divergence.multiply(&v, &mut dv);
        let dot = |a: &[f64], b: &[f64]| crate::vector::dot(a, b);
        assert_eq!(dot(gp.as_flattened(), v.as_flattened()), dot(p.as_flattened(), dv.as_flattened()));
    }

    #[test]
    fn flat_and_nodewise_products_agree() {
        let pattern = Arc::new(Pattern::from_elements(2, [[0, 1]]).unwrap());
        let mut a = BlockCsr::<2>::zeros(pattern);
        a.add(0, 0, &[[1.0, 2.0], [3.0, 4.0]]);
        a.add(0, 1, &[[0.0, 1.0], [1.0, 0.0]]);
        a.add(1, 1, &[[5.0, 0.0], [0.0, 5.0]]);
        let mut y = [f64::NAN; 4];
        a.apply(&[1.0, 1.0, 10.0, 20.0], &mut y);
        assert_eq!(y, [23.0, 17.0, 50.0, 100.0]);
        a.multiply_subtract(&[[1.0, 1.0], [10.0, 20.0]], dense::by_node_mut(&mut y));
        assert_eq!(y, [0.0; 4]);
        assert_eq!(a.size(), 4);
    }

    #[test]
    fn a_singular_diagonal_block_and_a_nan_are_reported_with_their_row() {
        let pattern = Arc::new(Pattern::from_elements(3, [[0, 1, 2]]).unwrap());
        let mut a = BlockCsr::<2>::zeros(pattern);
        a.add(0, 0, &[[1.0, 0.0], [0.0, 1.0]]);
        a.add(1, 1, &[[1.0, 2.0], [2.0, 4.0]]);
        assert_eq!(a.inverse_diagonal(), Err(Error::SingularDiagonal { row: 1 }));
        a.add(2, 1, &[[0.0, f64::NAN], [0.0, 0.0]]);
        assert!(matches!(a.inverse_diagonal(), Err(Error::NonFinite { row: 2, column: 1, .. })));
    }
}
