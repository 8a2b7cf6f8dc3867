//! Products of matrices, and norms.
//!
//! ```
//! use numerics::{Mat, products};
//!
//! let matrix = Mat::from_fn(2, 2, |row, column| [[0.0, -1.0], [1.0, 0.0]][row][column]);
//! let vector = Mat::from_fn(2, 1, |row, _| [3.0, 4.0][row]);
//! let turned = products::product(&matrix, &vector);
//! assert_eq!([turned[(0, 0)], turned[(1, 0)]], [-4.0, 3.0]);
//! assert_eq!(products::norm(&turned), 5.0);
//! ```

use faer::{ColRef, Mat, MatRef};
use realfft::num_complex::Complex64;

/// Of two matrices.
pub fn product(left: &Mat<f64>, right: &Mat<f64>) -> Mat<f64> {
    left * right
}

/// The same of complex numbers.
pub fn product_complex(
    left: MatRef<'_, Complex64>,
    right: MatRef<'_, Complex64>,
) -> Mat<Complex64> {
    left * right
}

/// Of two vectors.
pub fn dot(one: ColRef<'_, f64>, other: ColRef<'_, f64>) -> f64 {
    one.transpose() * other
}

/// The root of the sum of the squares of all entries.
pub fn norm(matrix: &Mat<f64>) -> f64 {
    matrix.norm_l2()
}
