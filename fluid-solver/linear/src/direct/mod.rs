//! Direct factors.

mod cholesky;
mod lu;

pub use cholesky::SparseCholesky;
pub use lu::DenseLu;
