//! Scaling by the diagonal.

use crate::parallel::for_each_chunk;
use crate::{Csr, Error, Preconditioner};

/// M = diag(A).
#[derive(Debug, Clone)]
pub struct Jacobi {
    inverse: Vec<f64>,
}

impl Jacobi {
    /// Preconditioner of an assembled matrix.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal that is zero or missing.
    pub fn new(a: &Csr) -> Result<Self, Error> {
        a.pattern().require_square()?;
        a.require_finite()?;
        Self::from_diagonal(&a.diagonal())
    }

    /// Preconditioner of an operator known by its (lumped) diagonal only.
    ///
    /// # Errors
    /// An entry that is not finite or zero.
    pub fn from_diagonal(diagonal: &[f64]) -> Result<Self, Error> {
        let invert = |(row, &value): (usize, &f64)| match 1.0 / value {
            _ if !value.is_finite() => Err(Error::NonFinite { row, column: row, value }),
            inverse if inverse.is_finite() => Ok(inverse),
            _ => Err(Error::SingularDiagonal { row }),
        };
        Ok(Self { inverse: diagonal.iter().enumerate().map(invert).collect::<Result<_, _>>()? })
    }
}

impl Preconditioner for Jacobi {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        assert_eq!(r.len(), self.inverse.len(), "residual");
        for_each_chunk(z, |first, z| {
            for (i, z) in (first..).zip(z) {
                *z = self.inverse[i] * r[i];
            }
        });
    }
}
