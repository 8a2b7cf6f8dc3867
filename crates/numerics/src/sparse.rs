//! Sparse matrices, and equations with those that are positive definite.
//!
//! ```
//! use numerics::sparse::{Cholesky, Entry, SparseMatrix};
//!
//! // Two masses with springs between them and on either side.
//! let entries = [(0, 0, 2.0), (1, 0, -1.0), (0, 1, -1.0), (1, 1, 2.0)];
//! let entries = entries.map(|(row, column, value)| Entry::new(row, column, value));
//! let stiffness = SparseMatrix::new(2, &entries)?;
//! let mut place = [0.0, 3.0];
//! Cholesky::new(&stiffness)?.solve(&mut place);
//! assert!((place[0] - 1.0).abs() < 1e-15 && (place[1] - 2.0).abs() < 1e-15);
//! # Ok::<(), numerics::NumericsError>(())
//! ```

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::LltError;
use faer::sparse::linalg::matmul::sparse_dense_matmul;
use faer::sparse::linalg::solvers::Llt;
use faer::sparse::{CreationError, SparseColMat, Triplet};
use faer::{Accum, MatMut, MatRef, Par, Side};

use crate::error::NumericsError;

/// An entry of a sparse matrix: row, column, value; equal places are summed.
pub type Entry = Triplet<usize, usize, f64>;

impl From<CreationError> for NumericsError {
    fn from(error: CreationError) -> Self {
        match error {
            CreationError::OutOfBounds { row, col } => Self::Outside { row, column: col },
            CreationError::Generic(_) => Self::OutOfMemory,
        }
    }
}

impl From<LltError> for NumericsError {
    fn from(error: LltError) -> Self {
        match error {
            LltError::Numeric(error) => error.into(),
            LltError::Generic(_) => Self::OutOfMemory,
        }
    }
}

/// A square matrix of which most entries are zero.
#[derive(Debug, Clone)]
pub struct SparseMatrix(SparseColMat<usize, f64>);

impl SparseMatrix {
    /// The sum of entries.
    ///
    /// # Errors
    /// Where an entry is outside, or memory does not suffice.
    pub fn new(size: usize, entries: &[Entry]) -> Result<Self, NumericsError> {
        Ok(Self(SparseColMat::try_new_from_triplets(
            size, size, entries,
        )?))
    }

    /// Row, column and value of what it has, column by column.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let entries = self.0.triplet_iter();
        entries.map(|entry| (entry.row, entry.col, *entry.val))
    }

    /// Adds its product with a vector, `scale` times.
    pub fn add_product(&self, scale: f64, vector: &[f64], sum: &mut [f64]) {
        let size = sum.len();
        sparse_dense_matmul(
            MatMut::from_column_major_slice_mut(sum, size, 1),
            Accum::Add,
            self.0.as_ref(),
            MatRef::from_column_major_slice(vector, size, 1),
            scale,
            Par::Seq,
        );
    }
}

/// A symmetric positive definite matrix, decomposed.
#[derive(Debug)]
pub struct Cholesky(Llt<usize, f64>);

impl Cholesky {
    /// Of a matrix of which the lower triangle is read.
    ///
    /// # Errors
    /// Where it is not positive definite, or memory does not suffice.
    pub fn new(matrix: &SparseMatrix) -> Result<Self, NumericsError> {
        Ok(Self(matrix.0.sp_cholesky(Side::Lower)?))
    }

    /// Puts what the matrix turns into a right side in its place.
    pub fn solve(&self, right: &mut [f64]) {
        let size = right.len();
        self.0
            .solve_in_place(MatMut::from_column_major_slice_mut(right, size, 1));
    }
}
