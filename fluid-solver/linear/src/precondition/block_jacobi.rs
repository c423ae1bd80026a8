//! Scaling by the diagonal blocks.

use crate::dense::{self, Block};
use crate::parallel::for_each_chunk;
use crate::{BlockCsr, Error, Preconditioner};

/// M = the block diagonal of A, one B×B block per node.
#[derive(Debug, Clone)]
pub struct BlockJacobi<const B: usize> {
    inverse: Vec<Block<B>>,
}

impl<const B: usize> BlockJacobi<B> {
    /// Preconditioner of an assembled matrix.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, a diagonal block that is singular or missing.
    pub fn new(a: &BlockCsr<B>) -> Result<Self, Error> {
        Ok(Self { inverse: a.inverse_diagonal()? })
    }
}

impl<const B: usize> Preconditioner for BlockJacobi<B> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let r = dense::by_node(r);
        assert_eq!(r.len(), self.inverse.len(), "residual");
        for_each_chunk(dense::by_node_mut(z), |first, z| {
            for (i, z) in (first..).zip(z) {
                *z = dense::multiply(&self.inverse[i], &r[i]);
            }
        });
    }
}
