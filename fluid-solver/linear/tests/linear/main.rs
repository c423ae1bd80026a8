//! Claims about the solvers, on model problems of flow.

mod amg;
mod breakdown;
mod direct;
mod incomplete_cholesky;
mod matrices;
mod nonsymmetric;
mod saddle_point;
mod threads;
