//! Answers that are known: by hand, or by putting them into the equations.

mod eigenvalues;
mod equations;
mod fft;
mod random;
mod sparse;
