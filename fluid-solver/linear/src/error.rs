//! What a matrix may be refused for.

use crate::Verdict;

/// Why a pattern, a factor or a preconditioner could not be made, or a solution not accepted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A column index is outside the matrix.
    #[error(
        "row {row} of the pattern: column {column} is outside 0..{columns}; number the nodes from 0 without gaps"
    )]
    ColumnOutside {
        /// Row of the pattern.
        row: usize,
        /// Column found.
        column: u32,
        /// Number of columns of the matrix.
        columns: usize,
    },
    /// A node of an element is outside the node range.
    #[error("element {element}: node {node} is outside 0..{nodes}; number the nodes from 0 without gaps")]
    NodeOutside {
        /// Position of the element in the list.
        element: usize,
        /// Node found.
        node: u32,
        /// Number of nodes.
        nodes: usize,
    },
    /// The columns of a row are not strictly increasing.
    #[error(
        "row {row} of the pattern: columns must increase strictly, found {after} after {before}; sort and deduplicate"
    )]
    ColumnsUnsorted {
        /// Row of the pattern.
        row: usize,
        /// Column found first.
        before: u32,
        /// Column that follows it.
        after: u32,
    },
    /// More rows, columns or entries than 32-bit indices can count.
    #[error(
        "the pattern needs {count} rows, columns or entries; at most {} fit in 32-bit indices: use a coarser mesh",
        u32::MAX
    )]
    TooLarge {
        /// Number needed.
        count: usize,
    },
    /// The number of values is not the number of entries of the pattern.
    #[error("{values} values for a pattern with {entries} entries; give one value per entry")]
    ValueCount {
        /// Number of values given.
        values: usize,
        /// Number of entries of the pattern.
        entries: usize,
    },
    /// A square matrix is needed.
    #[error("the matrix has {rows} rows and {columns} columns; a square one is needed")]
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// New values came with another pattern than the set-up was made for.
    #[error(
        "the pattern of the matrix changed ({rows} rows, {entries} entries) since the set-up; make a new set-up"
    )]
    PatternChanged {
        /// Rows of the matrix given.
        rows: usize,
        /// Entries of the matrix given.
        entries: usize,
    },
    /// A coefficient is NaN or infinite.
    #[error(
        "matrix row {row}, column {column}: the coefficient is {value}; it must be finite: look for an element of zero measure or a non-finite field at this node"
    )]
    NonFinite {
        /// Row of the coefficient.
        row: usize,
        /// Column of the coefficient.
        column: usize,
        /// Its value.
        value: f64,
    },
    /// A diagonal coefficient (or block) is missing, zero or singular.
    #[error(
        "matrix row {row}: the diagonal is zero, singular or missing; it must be invertible: does this unknown belong to an element, or should it be constrained?"
    )]
    SingularDiagonal {
        /// Row (block row in a block matrix).
        row: usize,
    },
    /// A diagonal coefficient is not positive where a positive definite matrix is needed.
    #[error(
        "matrix row {row}: the diagonal is {value}; it must be positive in a positive definite matrix: does this unknown belong to an element, and is the sign of the operator right?"
    )]
    DiagonalNotPositive {
        /// Row of the coefficient.
        row: usize,
        /// Its value.
        value: f64,
    },
    /// A Cholesky factor does not exist.
    #[error(
        "Cholesky met a pivot that is not positive: the matrix ({rows} rows) is singular or indefinite; constrain the pressure level, or use a method for indefinite systems"
    )]
    NotPositiveDefinite {
        /// Number of rows.
        rows: usize,
    },
    /// An LU factor does not exist.
    #[error(
        "LU met a zero pivot in column {column} of {columns}: the matrix is singular; constrain its null space"
    )]
    Singular {
        /// Column of elimination without a pivot.
        column: usize,
        /// Number of columns.
        columns: usize,
    },
    /// The factor does not fit in memory or in 32-bit indices.
    #[error(
        "the Cholesky factor of the matrix ({rows} rows, {entries} entries) does not fit; use conjugate gradients with multigrid"
    )]
    FactorTooLarge {
        /// Number of rows.
        rows: usize,
        /// Number of entries.
        entries: usize,
    },
    /// An iterative solution is not accepted.
    #[error("linear solve stopped after {iterations} iterations at residual {residual_norm:e}: {verdict}")]
    NotConverged {
        /// Iterations done.
        iterations: usize,
        /// Norm of the residual reached.
        residual_norm: f64,
        /// Reason of the stop.
        verdict: Verdict,
    },
}
