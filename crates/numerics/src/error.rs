//! What keeps a problem from having an answer.

use thiserror::Error;

/// Why a matrix has no decomposition, or is no matrix.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NumericsError {
    /// A matrix that has to be positive definite is not.
    #[error("the matrix is not positive definite: the pivot of row {row} is not positive")]
    NotPositiveDefinite {
        /// The row of the first pivot that is not positive, from 0, in the order of elimination.
        row: usize,
    },
    /// Eigenvalues are not found, as where an entry is not finite.
    #[error("the eigenvalues do not converge")]
    NoConvergence,
    /// An entry is not within its matrix.
    #[error("the matrix has no row {row} or no column {column}")]
    Outside {
        /// The row of the entry, from 0.
        row: usize,
        /// The column of the entry, from 0.
        column: usize,
    },
    /// A matrix takes more memory than there is.
    #[error("the matrix takes more memory than there is")]
    OutOfMemory,
}
