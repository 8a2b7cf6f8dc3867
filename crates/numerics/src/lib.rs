//! Fourier transforms, linear equations, eigenvalues and random numbers, for the crates above.
//!
//! The algorithms of rustfft, faer and chacha20 are generic: each crate that calls them compiles them again,
//! and so do its tests. What is needed of them is called here alone, by functions that are
//! not generic.
//!
//! | what | where | by |
//! |---|---|---|
//! | transforms of real sequences | [`fft`] | rustfft |
//! | linear equations, least squares | [`equations`] | LU and QR decomposition |
//! | sparse positive definite equations | [`sparse`] | sparse Cholesky decomposition |
//! | eigenvalues | [`eigenvalues`] | tridiagonal and Hessenberg form |
//! | products and norms | [`products`] | vector instructions |
//! | random numbers by seed and index | [`random`] | ChaCha8 |
//!
//! ```
//! use numerics::{Mat, equations};
//!
//! let matrix = Mat::from_fn(2, 2, |row, column| [[2.0, 1.0], [1.0, 3.0]][row][column]);
//! let right = Mat::from_fn(2, 1, |row, _| [4.0, 7.0][row]);
//! let found = equations::solve(&matrix, &right);
//! assert!((found[(0, 0)] - 1.0).abs() < 1e-15 && (found[(1, 0)] - 2.0).abs() < 1e-15);
//! ```

pub mod eigenvalues;
pub mod equations;
mod error;
pub mod fft;
pub mod products;
pub mod random;
pub mod sparse;

pub use error::NumericsError;
pub use faer::{Col, Mat};
pub use realfft::num_complex::Complex64;
