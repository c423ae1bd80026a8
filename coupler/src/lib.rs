//! The coupler: launches the solvers, orders the staggered iterations, evaluates the interaction laws, keeps the ledger.
