//! Exact responses between places, as a matrix.

use std::ops::Index;

use num_complex::Complex64;

use super::number::Number;

/// Responses at one frequency, or at several side by side, by output and input,
/// `[(output, input)]`.
#[derive(Debug, Clone, PartialEq)]
pub struct ResponseMatrix<T = Complex64> {
    size: usize,
    /// Row by row.
    entries: Vec<T>,
}

impl<T: Number> ResponseMatrix<T> {
    /// The matrix of this size that is the same in both directions (reciprocity), from what
    /// each of its columns has on and below the diagonal.
    pub(super) fn reciprocal<C: Iterator<Item = T>>(
        size: usize,
        column: impl Fn(usize) -> C,
    ) -> Self {
        let mut entries = vec![T::zero(); size * size];
        for from in 0..size {
            for (to, entry) in (from..size).zip(column(from)) {
                entries[to * size + from] = entry;
                entries[from * size + to] = entry;
            }
        }
        Self { size, entries }
    }

    /// Number of outputs, which is that of inputs.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Row by row.
    pub fn entries(&self) -> &[T] {
        &self.entries
    }
}

impl<T> Index<(usize, usize)> for ResponseMatrix<T> {
    type Output = T;

    fn index(&self, (output, input): (usize, usize)) -> &T {
        &self.entries[output * self.size + input]
    }
}
