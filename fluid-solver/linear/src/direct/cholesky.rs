//! Sparse Cholesky factor with a symbolic part that is kept.

use crate::{Csr, Error, Pattern};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use std::sync::Arc;

/// Π A Πᵀ = L Lᵀ of a symmetric positive definite matrix, Π the approximate minimum degree order.
///
/// Only the lower triangle of A is read. The order and the pattern of L are found once per pattern; new values cost a
/// numeric factorisation. Source: Davis, *Direct Methods for Sparse Linear Systems*, 2006; Amestoy, Davis and Duff,
/// *SIAM J. Matrix Anal. Appl.* 17 (1996) 886.
pub struct SparseCholesky {
    pattern: Arc<Pattern>,
    symbolic: SymbolicCholesky<u32>,
    factor: Vec<f64>,
    memory: MemBuffer,
}

impl SparseCholesky {
    /// Analyses and factors a matrix.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, not positive definite, or a factor that does not fit.
    pub fn new(a: &Csr) -> Result<Self, Error> {
        let mut cholesky = Self::analyse(a.pattern())?;
        cholesky.refresh(a)?;
        Ok(cholesky)
    }

    /// The symbolic part: order and pattern of L; to be refreshed before use.
    pub(crate) fn analyse(pattern: &Arc<Pattern>) -> Result<Self, Error> {
        pattern.require_square()?;
        let too_large = || Error::FactorTooLarge { rows: pattern.rows(), entries: pattern.entries() };
        let order = SymmetricOrdering::Amd;
        let symbolic = factorize_symbolic_cholesky(
            symbolic_view(pattern),
            TRIANGLE,
            order,
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| too_large())?;
        let request = symbolic
            .factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default())
            .or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        let memory = MemBuffer::try_new(request).map_err(|_| too_large())?;
        let factor = vec![0.0; symbolic.len_val()];
        Ok(Self { pattern: pattern.clone(), symbolic, factor, memory })
    }

    /// Factors new values on the same pattern; after an error the factor must not be used before a refresh succeeds.
    ///
    /// # Errors
    /// Another pattern, a coefficient not finite, not positive definite.
    pub fn refresh(&mut self, a: &Csr) -> Result<(), Error> {
        a.pattern().require_same(&self.pattern)?;
        a.require_finite()?;
        let matrix = SparseColMatRef::new(symbolic_view(&self.pattern), a.values());
        let rows = a.rows();
        self.symbolic
            .factorize_numeric_llt(
                &mut self.factor,
                matrix,
                TRIANGLE,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut self.memory),
                Default::default(),
            )
            .map(|_| ())
            .map_err(|_| Error::NotPositiveDefinite { rows })
    }

    /// x ← A⁻¹ x.
    pub fn solve_in_place(&mut self, x: &mut [f64]) {
        assert_eq!(x.len(), self.pattern.rows(), "right-hand side");
        let x = MatMut::from_column_major_slice_mut(x, self.pattern.rows(), 1);
        let factor = LltRef::new(&self.symbolic, &self.factor);
        factor.solve_in_place_with_conj(Conj::No, x, Par::Seq, MemStack::new(&mut self.memory));
    }

    /// Number of values in the factor.
    pub fn entries(&self) -> usize {
        self.factor.len()
    }
}

/// Rows of the symmetric matrix read as columns: its lower triangle is the upper one of the columns.
const TRIANGLE: Side = Side::Upper;

fn symbolic_view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    SymbolicSparseColMatRef::new_checked(
        pattern.columns(),
        pattern.rows(),
        pattern.row_starts(),
        None,
        pattern.column_indices(),
    )
}
