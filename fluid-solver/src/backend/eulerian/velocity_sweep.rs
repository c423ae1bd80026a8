//! Gauss–Seidel sweeps for the velocity block A + d.

use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use linear::dense::{self, Block};
use linear::{BlockCsr, Pattern};
use rayon::prelude::*;
use std::ops::Range;

/// Rows of a chunk: the longer, the fewer iterations.
const ROWS: usize = 1024;

/// One forward and one backward block Gauss–Seidel sweep, each chunk of rows on its own.
///
/// Constrained components stay zero.
pub struct VelocitySweep<const D: usize> {
    rows: Vec<RowSlots>,
    inverse: Vec<Block<D>>,
}

/// Slots of a row whose columns are in the row's own chunk.
struct RowSlots {
    first: u32,
    diagonal: u32,
    end: u32,
}

impl RowSlots {
    fn lower(&self) -> Range<usize> {
        self.first as usize..self.diagonal as usize
    }

    fn upper(&self) -> Range<usize> {
        self.diagonal as usize + 1..self.end as usize
    }
}

impl<const D: usize> VelocitySweep<D> {
    /// To be refreshed before use.
    pub fn new(pattern: &Pattern) -> Self {
        let rows = (0..pattern.rows()).map(|row| {
            let chunk = row / ROWS * ROWS;
            let slot = |bound: usize| {
                let before = pattern.row(row).partition_point(|&column| (column as usize) < bound);
                (pattern.slots(row).start + before) as u32
            };
            RowSlots { first: slot(chunk), diagonal: slot(row), end: slot(chunk + ROWS) }
        });
        Self { rows: rows.collect(), inverse: Vec::new() }
    }

    /// Inverts the diagonal blocks P(A_ii + d_i)P on the free directions.
    ///
    /// # Errors
    /// A diagonal block that is singular or not finite.
    pub fn refresh(
        &mut self,
        a: &BlockCsr<D>,
        drag: &[f64],
        constraints: &Constraints<D>,
    ) -> Result<(), linear::Error> {
        self.inverse.clear();
        let mut constrained = constraints.nodes().iter().peekable();
        for (row, slots) in self.rows.iter().enumerate() {
            let mut block = a.blocks()[slots.diagonal as usize];
            for (k, line) in block.iter_mut().enumerate() {
                line[k] += drag[row];
            }
            let free = constrained.next_if(|node| node.node as usize == row).map(|node| &node.free);
            let inverse = match free {
                None => dense::inverse(&block),
                Some(free) => restricted_inverse(&block, free),
            };
            self.inverse.push(inverse.ok_or(linear::Error::SingularDiagonal { row })?);
        }
        Ok(())
    }

    /// z ← approximate (A + d)⁻¹ r.
    pub fn apply(&self, a: &BlockCsr<D>, r: &[Vector<D>], z: &mut [Vector<D>]) {
        z.par_chunks_mut(ROWS).enumerate().for_each(|(chunk, z)| {
            let first = chunk * ROWS;
            let last = first + z.len();
            for i in first..last {
                let lower = inner_product(a, self.rows[i].lower(), first, z);
                let right = std::array::from_fn(|k| r[i][k] - lower[k]);
                z[i - first] = dense::multiply(&self.inverse[i], &right);
            }
            for i in (first..last).rev() {
                // After the forward sweep r − L z = D z, so only U is needed here.
                let upper = inner_product(a, self.rows[i].upper(), first, z);
                let step = dense::multiply(&self.inverse[i], &upper);
                let z = &mut z[i - first];
                *z = std::array::from_fn(|k| z[k] - step[k]);
            }
        });
    }
}

/// Σ_j A_ij z_j over a range of slots, z beginning at column `first`.
fn inner_product<const D: usize>(
    a: &BlockCsr<D>,
    slots: Range<usize>,
    first: usize,
    z: &[Vector<D>],
) -> Vector<D> {
    let mut sum = [0.0; D];
    for (&j, block) in a.pattern().columns_at(slots.clone()).iter().zip(&a.blocks()[slots]) {
        dense::multiply_add(block, &z[j as usize - first], &mut sum);
    }
    sum
}

/// P (P B P + I − P)⁻¹ P.
fn restricted_inverse<const D: usize>(block: &Block<D>, free: &Block<D>) -> Option<Block<D>> {
    let size = block.as_flattened().iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let inner = product(&product(free, block), free);
    let whole: Block<D> = std::array::from_fn(|k| {
        std::array::from_fn(|l| {
            let identity = if k == l { 1.0 } else { 0.0 };
            inner[k][l] + size * (identity - free[k][l])
        })
    });
    Some(product(&product(free, &dense::inverse(&whole)?), free))
}

fn product<const D: usize>(a: &Block<D>, b: &Block<D>) -> Block<D> {
    std::array::from_fn(|k| std::array::from_fn(|l| (0..D).map(|m| a[k][m] * b[m][l]).sum()))
}
