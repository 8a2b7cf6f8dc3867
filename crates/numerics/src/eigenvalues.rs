//! Eigenvalues of full matrices.
//!
//! ```
//! use numerics::{Mat, eigenvalues};
//!
//! // A mass on a spring, and a dashpot: ω = 5, and damped at the rate 3.
//! let matrix = Mat::from_fn(2, 2, |row, column| [[0.0, 1.0], [-25.0, -6.0]][row][column]);
//! let found = eigenvalues::general(&matrix)?;
//! assert_eq!(found.len(), 2);
//! assert!(found.iter().all(|it| (it.re + 3.0).abs() < 1e-14));
//! assert!(found.iter().all(|it| (it.im.abs() - 4.0).abs() < 1e-14));
//! # Ok::<(), numerics::NumericsError>(())
//! ```

use faer::linalg::solvers::{EvdError, Llt, LltError};
use faer::{Mat, Side};
use realfft::num_complex::Complex64;

use crate::error::NumericsError;

impl From<EvdError> for NumericsError {
    fn from(EvdError::NoConvergence: EvdError) -> Self {
        Self::NoConvergence
    }
}

impl From<LltError> for NumericsError {
    fn from(LltError::NonPositivePivot { index }: LltError) -> Self {
        Self::NotPositiveDefinite { row: index }
    }
}

/// Eigenvalues of a square matrix with their vectors, in no order: the columns of a matrix, those of two
/// that are conjugate next to one another.
///
/// # Errors
/// Where they are not found.
pub fn general_with_vectors(
    matrix: &Mat<f64>,
) -> Result<(Vec<Complex64>, Mat<Complex64>), NumericsError> {
    let found = matrix.eigen()?;
    let values = found.S().column_vector().iter().copied();
    Ok((values.collect(), found.U().to_owned()))
}

/// Eigenvalues of a symmetric matrix, of which the lower triangle is read, rising, with their vectors: the
/// columns of an orthogonal matrix.
///
/// # Errors
/// Where they are not found.
pub fn of_symmetric_with_vectors(matrix: &Mat<f64>) -> Result<(Vec<f64>, Mat<f64>), NumericsError> {
    let found = matrix.self_adjoint_eigen(Side::Lower)?;
    let values = found.S().column_vector().iter().copied();
    Ok((values.collect(), found.U().to_owned()))
}

/// Of a square matrix, in no order.
///
/// # Errors
/// Where they are not found.
pub fn general(matrix: &Mat<f64>) -> Result<Vec<Complex64>, NumericsError> {
    Ok(matrix.eigenvalues()?)
}

/// Of a Hermitian matrix, of which the lower triangle is read, rising.
///
/// # Errors
/// Where they are not found.
pub fn of_hermitian(matrix: &Mat<Complex64>) -> Result<Vec<f64>, NumericsError> {
    Ok(matrix.self_adjoint_eigenvalues(Side::Lower)?)
}

/// The same with their vectors: the columns of a unitary matrix.
///
/// # Errors
/// Where they are not found.
pub fn with_vectors(
    hermitian: &Mat<Complex64>,
) -> Result<(Vec<f64>, Mat<Complex64>), NumericsError> {
    let found = hermitian.self_adjoint_eigen(Side::Lower)?;
    let values = found.S().column_vector().iter().map(|value| value.re);
    Ok((values.collect(), found.U().to_owned()))
}

/// Whether all are positive, of a Hermitian matrix of which the lower triangle is read.
pub fn are_positive(hermitian: &Mat<Complex64>) -> bool {
    hermitian.llt(Side::Lower).is_ok()
}

/// Whether all are positive, of a symmetric matrix whose lower triangle is given row by row: its Cholesky
/// factor takes the place of it, as far as there is one. Of small matrices, of which there are tens of
/// thousands, an allocation for each would take longer than the factor.
pub fn are_positive_of_symmetric(lower: &mut [f64]) -> bool {
    let mut done = 0;
    let mut size = 0;
    while done + size < lower.len() {
        let (above, row) = lower.split_at_mut(done);
        let mut begin = 0;
        for column in 0..size {
            let of_column = &above[begin..=begin + column];
            let dot: f64 = (of_column[..column].iter().zip(&*row))
                .map(|(a, b)| a * b)
                .sum();
            row[column] = (row[column] - dot) / of_column[column];
            begin += column + 1;
        }
        let squares: f64 = row[..size].iter().map(|entry| entry * entry).sum();
        let pivot = row[size] - squares;
        if pivot <= 0.0 || pivot.is_nan() {
            return false;
        }
        row[size] = pivot.sqrt();
        size += 1;
        done += size;
    }
    true
}

/// The λ of Ax = λBx, rising; A and B are symmetric, B is positive definite.
///
/// # Errors
/// Where B is not positive definite, or they are not found.
pub fn of_pencil(a: &Mat<f64>, b: &Mat<f64>) -> Result<Vec<f64>, NumericsError> {
    let decomposed = b.llt(Side::Lower)?;
    Ok(reduced(a, &decomposed).self_adjoint_eigenvalues(Side::Lower)?)
}

/// The same with their x, for which xᵀBx is one: the columns of a matrix.
///
/// # Errors
/// As [`of_pencil`].
pub fn of_pencil_with_vectors(
    a: &Mat<f64>,
    b: &Mat<f64>,
) -> Result<(Vec<f64>, Mat<f64>), NumericsError> {
    let decomposed = b.llt(Side::Lower)?;
    let (values, mut vectors) = of_symmetric_with_vectors(&reduced(a, &decomposed))?;
    let upper = decomposed.L().transpose();
    upper.solve_upper_triangular_in_place(&mut vectors);
    Ok((values, vectors))
}

/// L⁻¹AL⁻ᵀ with B = LLᵀ, whose eigenvalues are those of the pencil.
fn reduced(a: &Mat<f64>, decomposed: &Llt<f64>) -> Mat<f64> {
    let mut reduced = a.clone();
    decomposed.L().solve_lower_triangular_in_place(&mut reduced);
    let mut reduced = reduced.transpose().to_owned();
    decomposed.L().solve_lower_triangular_in_place(&mut reduced);
    reduced
}
