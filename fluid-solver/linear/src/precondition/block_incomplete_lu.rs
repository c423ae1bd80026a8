//! Incomplete LU factor without fill, for velocity matrices.

use crate::block_csr::block_dot;
use crate::dense::{self, Block};
use crate::{BlockCsr, Error, Pattern, Preconditioner};
use std::ops::Range;
use std::sync::Arc;

/// M = L U on the pattern of A, with B×B blocks as entries and identities on the diagonal of L: block ILU(0).
///
/// A need not be symmetric. Unlike Gauss–Seidel sweeps, whose price per application is the same, it holds where central
/// convection makes the diagonal weak. Where a pivot block is nearly singular the factor is that of A + α diag(A),
/// α = 10⁻³, 2·10⁻³, 4·10⁻³, …
///
/// Source: Saad, *Iterative Methods for Sparse Linear Systems*, 2nd ed. 2003, algorithm 10.4.
#[derive(Debug, Clone)]
pub struct BlockIncompleteLu<const B: usize> {
    pattern: Arc<Pattern>,
    diagonal: Vec<u32>,
    /// L strictly below the diagonal, inverted pivots on it, U above.
    factors: Vec<Block<B>>,
    shift: f64,
}

impl<const B: usize> BlockIncompleteLu<B> {
    /// Factors an assembled matrix.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal block that is singular or missing.
    pub fn new(a: &BlockCsr<B>) -> Result<Self, Error> {
        let pattern = a.pattern().clone();
        let diagonal = pattern.diagonal_slots()?;
        let mut factor = Self { pattern, diagonal, factors: a.blocks().to_vec(), shift: 0.0 };
        factor.refresh(a)?;
        Ok(factor)
    }

    /// Factors new values on the same pattern.
    ///
    /// # Errors
    /// As [`Self::new`], and another pattern.
    pub fn refresh(&mut self, a: &BlockCsr<B>) -> Result<(), Error> {
        a.pattern().require_same(&self.pattern)?;
        a.require_finite()?;
        for (row, &slot) in self.diagonal.iter().enumerate() {
            dense::inverse(&a.blocks()[slot as usize]).ok_or(Error::SingularDiagonal { row })?;
        }
        self.shift = 0.0;
        while let Err(row) = self.factor(a) {
            self.shift = if self.shift == 0.0 { 1e-3 } else { 2.0 * self.shift };
            if self.shift > 1e3 {
                return Err(Error::SingularDiagonal { row });
            }
        }
        Ok(())
    }

    /// The α that was needed.
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Row by row: L_ik = A_ik U_kk⁻¹, then row i loses L_ik times row k of U; fails with the row of a bad pivot.
    fn factor(&mut self, a: &BlockCsr<B>) -> Result<(), usize> {
        self.factors.copy_from_slice(a.blocks());
        for i in 0..self.pattern.rows() {
            let (slots, columns) = (self.pattern.slots(i), self.pattern.row(i));
            let (done, rest) = self.factors.split_at_mut(slots.start);
            let row = &mut rest[..slots.len()];
            let diagonal = self.diagonal[i] as usize - slots.start;
            let own = scale(&row[diagonal]);
            for value in row[diagonal].as_flattened_mut() {
                *value *= 1.0 + self.shift;
            }
            for position in 0..diagonal {
                let k = columns[position] as usize;
                row[position] = dense::product(&row[position], &done[self.diagonal[k] as usize]);
                let (left, right) = row.split_at_mut(position + 1);
                let upper = self.diagonal[k] as usize + 1..self.pattern.slots(k).end;
                let upper = (&self.pattern.column_indices()[upper.clone()], &done[upper]);
                eliminate(&left[position], upper, &columns[position + 1..], right);
            }
            row[diagonal] =
                dense::inverse(&row[diagonal]).filter(|inverse| scale(inverse) * own < 1e8).ok_or(i)?;
        }
        Ok(())
    }

    fn partial_dot(&self, slots: Range<usize>, x: &[[f64; B]]) -> [f64; B] {
        block_dot((&self.pattern.column_indices()[slots.clone()], &self.factors[slots]), x)
    }
}

/// Subtracts L times a row of U from the entries that the row of A shares with it.
fn eliminate<const B: usize>(l: &Block<B>, u: (&[u32], &[Block<B>]), columns: &[u32], row: &mut [Block<B>]) {
    let (mut p, mut q) = (0, 0);
    while p < columns.len() && q < u.0.len() {
        let (here, there) = (columns[p], u.0[q]);
        if here == there {
            let fill = dense::product(l, &u.1[q]);
            for (value, fill) in row[p].as_flattened_mut().iter_mut().zip(fill.as_flattened()) {
                *value -= fill;
            }
        }
        (p, q) = (p + usize::from(here <= there), q + usize::from(there <= here));
    }
}

fn scale<const B: usize>(block: &Block<B>) -> f64 {
    block.as_flattened().iter().fold(0.0, |max, value| max.max(value.abs()))
}

impl<const B: usize> Preconditioner for BlockIncompleteLu<B> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let (r, z) = (dense::by_node::<B>(r), dense::by_node_mut::<B>(z));
        assert_eq!(r.len(), self.pattern.rows(), "residual");
        for i in 0..r.len() {
            let lower = self.partial_dot(self.pattern.slots(i).start..self.diagonal[i] as usize, z);
            z[i] = std::array::from_fn(|c| r[i][c] - lower[c]);
        }
        for i in (0..r.len()).rev() {
            let upper = self.partial_dot(self.diagonal[i] as usize + 1..self.pattern.slots(i).end, z);
            let right = std::array::from_fn(|c| z[i][c] - upper[c]);
            z[i] = dense::multiply(&self.factors[self.diagonal[i] as usize], &right);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LinearOperator;

    fn block(seed: usize) -> Block<2> {
        let value = |k: usize| ((seed * 7 + k * 13) as f64).sin();
        [[3.0 + value(0), value(1)], [value(2), 4.0 + value(3)]]
    }

    /// A chain of n nodes has no fill.
    fn chain(n: usize) -> BlockCsr<2> {
        let edges = (1..n as u32).map(|i| [i - 1, i]);
        let mut a = BlockCsr::zeros(Arc::new(Pattern::from_elements(n, edges).unwrap()));
        for (k, b) in a.blocks_mut().iter_mut().enumerate() {
            *b = block(k).map(|row| row.map(|v| 0.3 * v));
        }
        (0..n).for_each(|i| a.add(i, i, &block(i)));
        a
    }

    #[test]
    fn on_a_chain_the_incomplete_factor_is_exact() {
        let a = chain(50);
        let exact: Vec<f64> = (0..100).map(|i| (i as f64 * 0.37).cos()).collect();
        let (mut b, mut x) = (vec![0.0; 100], vec![f64::NAN; 100]);
        a.apply(&exact, &mut b);
        let mut m = BlockIncompleteLu::new(&a).unwrap();
        m.apply(&b, &mut x);
        assert_eq!(m.shift(), 0.0);
        assert!(x.iter().zip(&exact).all(|(x, exact)| (x - exact).abs() < 1e-12));
    }

    #[test]
    fn a_vanishing_pivot_calls_for_a_shift_and_a_refresh_gives_the_bits_of_a_new_factor() {
        let identity = [[1.0, 0.0], [0.0, 1.0]];
        let mut a = BlockCsr::<2>::zeros(chain(2).pattern().clone());
        a.blocks_mut().fill(identity);
        let shifted = BlockIncompleteLu::new(&a).unwrap();
        assert!(shifted.shift() > 0.0);
        let mut refreshed = shifted;
        refreshed.refresh(&chain(2)).unwrap();
        assert_eq!(refreshed.factors, BlockIncompleteLu::new(&chain(2)).unwrap().factors);
        assert_eq!(refreshed.shift(), 0.0);
    }

    #[test]
    fn a_singular_diagonal_block_a_nan_and_another_pattern_are_refused() {
        let mut a = chain(4);
        let mut m = BlockIncompleteLu::new(&a).unwrap();
        assert!(matches!(m.refresh(&chain(5)), Err(Error::PatternChanged { rows: 5, entries: 13 })));
        let slot = a.pattern().slot(2, 2).unwrap();
        a.blocks_mut()[slot] = [[1.0, 2.0], [2.0, 4.0]];
        assert_eq!(m.refresh(&a), Err(Error::SingularDiagonal { row: 2 }));
        a.blocks_mut()[slot] = [[1.0, f64::NAN], [2.0, 4.0]];
        assert!(matches!(m.refresh(&a), Err(Error::NonFinite { row: 2, column: 2, .. })));
    }
}
