//! Linear equations with a full matrix, and least squares.
//!
//! ```
//! use numerics::{Col, Mat, equations};
//!
//! // Through (0, 1), (1, 3) and (2, 5) goes 1 + 2x.
//! let matrix = Mat::from_fn(3, 2, |row, power| (row as f64).powi(power as i32));
//! let right = Col::from_fn(3, |row| 1.0 + 2.0 * row as f64);
//! let line = equations::least_squares(&matrix, &right);
//! assert!((line[0] - 1.0).abs() < 1e-14 && (line[1] - 2.0).abs() < 1e-14);
//! ```

use faer::linalg::solvers::{PartialPivLu, Solve, SolveLstsq};
use faer::{Col, Mat};
use realfft::num_complex::Complex64;

/// A square matrix, decomposed by elimination with pivots, for several right sides.
#[derive(Debug, Clone)]
pub struct Elimination(PartialPivLu<f64>);

impl Elimination {
    /// Of a matrix. Where it is singular, or not finite, neither is what it solves.
    pub fn new(matrix: &Mat<f64>) -> Self {
        Self(matrix.partial_piv_lu())
    }

    /// What the matrix turns into each column of a right side.
    pub fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        self.0.solve(right)
    }
}

/// What a square matrix turns into each column of a right side; not finite where it is singular.
pub fn solve(matrix: &Mat<f64>, right: &Mat<f64>) -> Mat<f64> {
    Elimination::new(matrix).solve(right)
}

/// The same of complex numbers.
pub fn solve_complex(matrix: &Mat<Complex64>, right: &Mat<Complex64>) -> Mat<Complex64> {
    matrix.partial_piv_lu().solve(right)
}

/// What a matrix with at least as many rows as columns turns into the nearest to a right side.
pub fn least_squares(matrix: &Mat<f64>, right: &Col<f64>) -> Vec<f64> {
    let found = matrix.qr().solve_lstsq(right.as_mat());
    (0..matrix.ncols()).map(|row| found[(row, 0)]).collect()
}
