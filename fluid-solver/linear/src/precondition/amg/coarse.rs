//! The level that is factored.

use super::NullSpace;
use crate::vector::remove_mean;
use crate::{Csr, Error, Pattern, SparseCholesky};

pub(super) struct Coarse {
    a: Csr,
    null_space: NullSpace,
    factor: SparseCholesky,
}

impl Coarse {
    pub(super) fn new(a: Csr, null_space: NullSpace) -> Result<Self, Error> {
        let factor = SparseCholesky::analyse(a.pattern())?;
        let values = a.values().to_vec();
        let mut coarse = Self { a, null_space, factor };
        coarse.refresh(&values)?;
        Ok(coarse)
    }

    /// Factors new values. Where rounding or a null space beyond the stated one leaves them singular, the diagonal is
    /// raised by a relative 10⁻¹², 10⁻¹⁰, … : a preconditioner may be inexact.
    pub(super) fn refresh(&mut self, values: &[f64]) -> Result<(), Error> {
        self.a.values_mut().copy_from_slice(values);
        self.a.require_finite()?;
        pin(&mut self.a, self.null_space)?;
        let mut result = self.factor.refresh(&self.a);
        for shift in [1e-12, 1e-10, 1e-8, 1e-6, 1e-4] {
            if result != Err(Error::NotPositiveDefinite { rows: self.a.rows() }) {
                break;
            }
            raise_diagonal(&mut self.a, shift)?;
            result = self.factor.refresh(&self.a);
        }
        result
    }

    pub(super) fn pattern(&self) -> &Pattern {
        self.a.pattern()
    }

    pub(super) fn solve(&mut self, b: &[f64], x: &mut [f64]) {
        x.copy_from_slice(b);
        self.factor.solve_in_place(x);
        if self.null_space == NullSpace::Constant {
            remove_mean(x);
        }
    }
}

/// Makes a matrix that maps constants to zero regular: (A + α e₀ e₀ᵀ) x = b has x₀ = 0 and A x = b where Σ b = 0, since
/// 1ᵀ A = 0 leaves α x₀ = Σ b. So the solution is exact for any α; the one taken is a₀₀.
fn pin(a: &mut Csr, null_space: NullSpace) -> Result<(), Error> {
    let diagonal = a.pattern().diagonal_slots()?;
    for (row, &slot) in diagonal.iter().enumerate() {
        let value = a.values()[slot as usize];
        if value <= 0.0 {
            return Err(Error::DiagonalNotPositive { row, value });
        }
    }
    if let (NullSpace::Constant, Some(&first)) = (null_space, diagonal.first()) {
        a.values_mut()[first as usize] *= 2.0;
    }
    Ok(())
}

fn raise_diagonal(a: &mut Csr, shift: f64) -> Result<(), Error> {
    for slot in a.pattern().diagonal_slots()? {
        a.values_mut()[slot as usize] *= 1.0 + shift;
    }
    Ok(())
}
