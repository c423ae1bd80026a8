//! Gauss–Seidel sweeps: A = L + D + U with L and U strictly triangular.

use crate::csr::sparse_dot;
use crate::{Csr, Error, Preconditioner};

/// Where each row has its diagonal, and the inverse of it.
#[derive(Debug, Clone)]
pub(crate) struct Diagonal {
    slot: Vec<u32>,
    inverse: Vec<f64>,
}

impl Diagonal {
    /// Finds the diagonal; it must be positive, and every coefficient finite.
    pub(crate) fn new(a: &Csr) -> Result<Self, Error> {
        let slot = a.pattern().diagonal_slots()?;
        let mut diagonal = Self { inverse: vec![0.0; slot.len()], slot };
        diagonal.refresh(a)?;
        Ok(diagonal)
    }

    /// Takes new values on the same pattern.
    pub(crate) fn refresh(&mut self, a: &Csr) -> Result<(), Error> {
        a.require_finite()?;
        for (row, (inverse, &slot)) in self.inverse.iter_mut().zip(&self.slot).enumerate() {
            let value = a.values()[slot as usize];
            *inverse = 1.0 / value;
            if !(value > 0.0 && inverse.is_finite()) {
                return Err(Error::DiagonalNotPositive { row, value });
            }
        }
        Ok(())
    }

    pub(crate) fn inverse(&self) -> &[f64] {
        &self.inverse
    }

    fn lower_dot(&self, a: &Csr, i: usize, x: &[f64]) -> f64 {
        let slots = a.pattern().slots(i).start..self.slot[i] as usize;
        sparse_dot((&a.pattern().column_indices()[slots.clone()], &a.values()[slots]), x)
    }

    fn upper_dot(&self, a: &Csr, i: usize, x: &[f64]) -> f64 {
        let slots = self.slot[i] as usize + 1..a.pattern().slots(i).end;
        sparse_dot((&a.pattern().column_indices()[slots.clone()], &a.values()[slots]), x)
    }

    /// x ← (D + L)⁻¹ b: a forward sweep that starts from zero.
    pub(crate) fn forward_from_zero(&self, a: &Csr, b: &[f64], x: &mut [f64]) {
        for i in 0..b.len() {
            x[i] = self.inverse[i] * (b[i] - self.lower_dot(a, i, x));
        }
    }

    /// r ← b − A x where x comes from [`Self::forward_from_zero`]: there (D + L) x = b, so r = −U x.
    pub(crate) fn residual_after_forward(&self, a: &Csr, x: &[f64], r: &mut [f64]) {
        crate::parallel::for_each_chunk(r, |first, r| {
            for (i, r) in (first..).zip(r) {
                *r = -self.upper_dot(a, i, x);
            }
        });
    }

    /// x ← x + (D + U)⁻¹ (b − A x): a backward sweep.
    pub(crate) fn backward(&self, a: &Csr, b: &[f64], x: &mut [f64]) {
        for i in (0..b.len()).rev() {
            x[i] += self.inverse[i] * (b[i] - sparse_dot(a.row(i), x));
        }
    }

    /// The same where x comes from [`Self::forward_from_zero`]: there b − L x = D x.
    fn backward_after_forward(&self, a: &Csr, x: &mut [f64]) {
        for i in (0..x.len()).rev() {
            x[i] -= self.inverse[i] * self.upper_dot(a, i, x);
        }
    }
}

/// M = (D + L) D⁻¹ (D + U): one forward and one backward sweep, for the price of one product.
///
/// Source: Saad, *Iterative Methods for Sparse Linear Systems*, 2nd ed. 2003, §10.2.
#[derive(Debug, Clone)]
pub struct SymmetricGaussSeidel<'a> {
    a: &'a Csr,
    diagonal: Diagonal,
}

impl<'a> SymmetricGaussSeidel<'a> {
    /// Preconditioner of a matrix with positive diagonal.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal that is not positive or missing.
    pub fn new(a: &'a Csr) -> Result<Self, Error> {
        Ok(Self { a, diagonal: Diagonal::new(a)? })
    }
}

impl Preconditioner for SymmetricGaussSeidel<'_> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        self.diagonal.forward_from_zero(self.a, r, z);
        self.diagonal.backward_after_forward(self.a, z);
    }
}
