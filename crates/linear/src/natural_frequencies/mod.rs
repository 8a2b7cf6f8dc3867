//! Natural frequencies of a string without damping, and its mode shapes, by the exact waves of
//! its tubes (Sections 2.2 and 2.5 of the paper with s = iω).
//!
//! As many natural frequencies lie below ω as J = J₀ + s(K): J₀ of the pieces with all nodes
//! between them held, s(K) the negative eigenvalues of the dynamic stiffness of those nodes
//! (W. H. Wittrick and F. W. Williams, "A general algorithm for computing natural frequencies of
//! elastic structures", *Quarterly Journal of Mechanics and Applied Mathematics* 24, 1971,
//! 263–284). Bisection on that count finds all of them, however close two are.
//!
//! In torsion the surface is held at its speed; a top drive is left out, as its controller damps
//! (with it: [`crate::modes`]). In bending the surface is held as [`crate::SurfaceSupport`] says.
//! The bit is free, and so is the string where it may touch the borehole wall, unless places are
//! said to hold it.

mod bending;
mod frequencies;
mod shapes;
mod torsion;

pub use frequencies::{NaturalFrequencies, held_lateral_frequencies_below};
pub use shapes::Shape;
