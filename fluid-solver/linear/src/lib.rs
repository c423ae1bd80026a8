//! Sparse linear algebra for partitioned flow solvers; knows no elements.
//!
//! | need | take |
//! |---|---|
//! | a matrix on the nodes of a mesh | [`Pattern::from_elements`], then [`Csr`] (scalar) or [`BlockCsr`] (vector) |
//! | a symmetric positive system, 2D or reused | [`SparseCholesky`] |
//! | the same, 3D and up to about 10⁵ unknowns | [`ConjugateGradient`] with [`IncompleteCholesky`] |
//! | the same, larger, or pure Neumann | [`ConjugateGradient`] with [`Amg`] |
//! | a velocity system with convection | [`BiCgStab`] or [`FlexibleGmres`] with [`BlockIncompleteLu`] |
//! | a saddle point, an operator that is never assembled | [`FlexibleGmres`] with your own [`LinearOperator`] and [`Preconditioner`] |
//!
//! Every result has the same bits for any number of threads: rows are summed each by itself, vectors by a tree whose
//! shape depends on their length only. Every vector length is checked by `assert!`: a mismatch is a defect of the
//! caller. Values are not trusted: see [`Error`] and [`Verdict`].

mod block_csr;
mod csr;
pub mod dense;
mod direct;
mod error;
mod krylov;
mod operator;
mod parallel;
mod pattern;
mod precondition;
pub mod vector;

pub use block_csr::BlockCsr;
pub use csr::Csr;
pub use direct::{DenseLu, SparseCholesky};
pub use error::Error;
pub use krylov::{BiCgStab, ConjugateGradient, FlexibleGmres, Outcome, Stopping, Verdict};
pub use operator::{LinearOperator, Preconditioner};
pub use pattern::Pattern;
pub use precondition::{
    Amg, AmgOptions, BlockIncompleteLu, BlockJacobi, Identity, IncompleteCholesky, Jacobi, NullSpace,
    SymmetricGaussSeidel,
};
