//! Exact responses between places, as a matrix.

use std::ops::Index;

use faer::Mat;
use num_complex::Complex64;

/// Responses at one frequency, by output and input, `[(output, input)]`.
#[derive(Debug, Clone)]
pub struct ResponseMatrix(pub(super) Mat<Complex64>);

impl ResponseMatrix {
    /// Number of outputs, which is that of inputs.
    pub fn size(&self) -> usize {
        self.0.nrows()
    }
}

impl Index<(usize, usize)> for ResponseMatrix {
    type Output = Complex64;

    fn index(&self, place: (usize, usize)) -> &Complex64 {
        &self.0[place]
    }
}
