//! Gauss–Seidel sweeps for the velocity block A + d.

use super::incidence::ROWS;
use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use linear::BlockCsr;
use linear::dense::{self, Block};
use rayon::prelude::*;

/// One forward and one backward block Gauss–Seidel sweep, each chunk of rows on its own.
///
/// Constrained components stay zero.
#[derive(Debug, Default)]
pub struct VelocitySweep<const D: usize> {
    inverse: Vec<Block<D>>,
}

impl<const D: usize> VelocitySweep<D> {
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
        let diagonal = a.pattern().diagonal_slots()?;
        let mut constrained = constraints.nodes().iter().peekable();
        for (row, &slot) in diagonal.iter().enumerate() {
            let mut block = a.blocks()[slot as usize];
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
                let lower = inner_product(a, i, first..i, first, z);
                let right = std::array::from_fn(|k| r[i][k] - lower[k]);
                z[i - first] = dense::multiply(&self.inverse[i], &right);
            }
            for i in (first..last).rev() {
                // After the forward sweep r − L z = D z, so only U is needed here.
                let upper = inner_product(a, i, i + 1..last, first, z);
                let step = dense::multiply(&self.inverse[i], &upper);
                let z = &mut z[i - first];
                *z = std::array::from_fn(|k| z[k] - step[k]);
            }
        });
    }
}

/// Σ_j A_ij z_j over the columns j in a range, z beginning at column `first`.
fn inner_product<const D: usize>(
    a: &BlockCsr<D>,
    i: usize,
    range: std::ops::Range<usize>,
    first: usize,
    z: &[Vector<D>],
) -> Vector<D> {
    let (columns, blocks) = a.row(i);
    let mut sum = [0.0; D];
    for (&j, block) in columns.iter().zip(blocks) {
        if range.contains(&(j as usize)) {
            dense::multiply_add(block, &z[j as usize - first], &mut sum);
        }
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
