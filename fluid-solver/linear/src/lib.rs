//! Sparse linear algebra: CSR, Krylov solvers, preconditioners, multigrid, direct factors; knows no elements.
