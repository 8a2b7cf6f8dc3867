//! The drag of mud on a tube, however it is evaluated.

use num_complex::Complex64;

use crate::loss::Fit;

/// The drag of mud on a tube over frequency.
pub(crate) trait Drag {
    /// Where a frequency is, found once for all tubes.
    type Place;

    /// The place of the Laplace variable s, rad/s.
    fn place(s: Complex64) -> Self::Place;

    /// Force per length and speed there.
    fn at(&self, place: &Self::Place) -> Complex64;
}

impl Drag for Fit {
    type Place = Complex64;

    fn place(s: Complex64) -> Complex64 {
        s
    }

    fn at(&self, s: &Complex64) -> Complex64 {
        Fit::at(self, *s)
    }
}
