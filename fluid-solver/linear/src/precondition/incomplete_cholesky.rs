//! Incomplete Cholesky factor without fill.

use crate::{Csr, Error, Pattern, Preconditioner};
use std::sync::Arc;

/// M = L Lᵀ with L on the lower triangle of the pattern of A: IC(0).
///
/// Where a pivot is not positive the factor is that of A + α diag(A), α = 10⁻³, 2·10⁻³, 4·10⁻³, …
///
/// Source: Meijerink and van der Vorst, *Math. Comp.* 31 (1977) 148; shift: Manteuffel, *Math. Comp.* 34 (1980) 473.
#[derive(Debug, Clone)]
pub struct IncompleteCholesky {
    of: Arc<Pattern>,
    /// Strictly lower triangle.
    lower: Pattern,
    values: Vec<f64>,
    inverse_diagonal: Vec<f64>,
    shift: f64,
}

impl IncompleteCholesky {
    /// Factors a symmetric matrix; only its lower triangle is read.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal not positive, no positive pivots with any shift.
    pub fn new(a: &Csr) -> Result<Self, Error> {
        let of = a.pattern().clone();
        let diagonal = of.diagonal_slots()?;
        let row = |i: usize| &of.column_indices()[of.slots(i).start..diagonal[i] as usize];
        let lower = Pattern::from_rows(of.columns(), (0..of.rows()).map(row))?;
        let (values, inverse_diagonal) = (vec![0.0; lower.entries()], vec![0.0; of.rows()]);
        let mut factor = Self { of, lower, values, inverse_diagonal, shift: 0.0 };
        factor.refresh(a)?;
        Ok(factor)
    }

    /// Factors new values on the same pattern.
    ///
    /// # Errors
    /// As [`Self::new`], and another pattern.
    pub fn refresh(&mut self, a: &Csr) -> Result<(), Error> {
        a.pattern().require_same(&self.of)?;
        a.require_finite()?;
        for row in 0..a.rows() {
            let value = a.get(row, row);
            if value <= 0.0 {
                return Err(Error::DiagonalNotPositive { row, value });
            }
        }
        self.shift = 0.0;
        while !self.factor(a) {
            self.shift = if self.shift == 0.0 { 1e-3 } else { 2.0 * self.shift };
            if self.shift > 1e3 {
                return Err(Error::NotPositiveDefinite { rows: a.rows() });
            }
        }
        Ok(())
    }

    /// The α that was needed.
    pub fn shift(&self) -> f64 {
        self.shift
    }

    /// Row by row: l_ij = (a_ij − Σ_{k<j} l_ik l_jk) / l_jj, l_ii² = (1 + α) a_ii − Σ_k l_ik²; false at a pivot that is
    /// not clearly positive.
    fn factor(&mut self, a: &Csr) -> bool {
        for i in 0..a.rows() {
            let (columns, coefficients) = a.row(i);
            let slots = self.lower.slots(i);
            let (done, rest) = self.values.split_at_mut(slots.start);
            let row = &mut rest[..slots.len()];
            for position in 0..row.len() {
                let j = columns[position] as usize;
                let known = (&columns[..position], &row[..position]);
                let inner = common_dot(known, (self.lower.row(j), &done[self.lower.slots(j)]));
                row[position] = (coefficients[position] - inner) * self.inverse_diagonal[j];
            }
            let diagonal = coefficients[row.len()];
            let pivot = (1.0 + self.shift) * diagonal - row.iter().map(|l| l * l).sum::<f64>();
            if !(pivot > 1e-8 * diagonal && pivot.is_finite()) {
                return false;
            }
            self.inverse_diagonal[i] = 1.0 / pivot.sqrt();
        }
        true
    }
}

/// Σ over the columns that two sparse rows share.
fn common_dot((ja, a): (&[u32], &[f64]), (jb, b): (&[u32], &[f64])) -> f64 {
    let (mut p, mut q, mut sum) = (0, 0, 0.0);
    while p < ja.len() && q < jb.len() {
        if ja[p] == jb[q] {
            sum += a[p] * b[q];
        }
        (p, q) = (p + usize::from(ja[p] <= jb[q]), q + usize::from(jb[q] <= ja[p]));
    }
    sum
}

impl Preconditioner for IncompleteCholesky {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert_eq!(r.len(), self.inverse_diagonal.len(), "residual");
        for i in 0..r.len() {
            let row = (self.lower.row(i), &self.values[self.lower.slots(i)]);
            z[i] = (r[i] - crate::csr::sparse_dot(row, z)) * self.inverse_diagonal[i];
        }
        for i in (0..r.len()).rev() {
            z[i] *= self.inverse_diagonal[i];
            let z_i = z[i];
            for (&j, l) in self.lower.row(i).iter().zip(&self.values[self.lower.slots(i)]) {
                z[j as usize] -= l * z_i;
            }
        }
    }
}
