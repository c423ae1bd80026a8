//! Preconditioners.

mod amg;
mod block_incomplete_lu;
mod block_jacobi;
mod gauss_seidel;
mod identity;
mod incomplete_cholesky;
mod jacobi;

pub use amg::{Amg, AmgOptions, NullSpace};
pub use block_incomplete_lu::BlockIncompleteLu;
pub use block_jacobi::BlockJacobi;
pub use gauss_seidel::SymmetricGaussSeidel;
pub use identity::Identity;
pub use incomplete_cholesky::IncompleteCholesky;
pub use jacobi::Jacobi;
