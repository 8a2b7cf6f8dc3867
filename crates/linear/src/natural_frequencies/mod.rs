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
//! (with it: [`crate::modes`]). Along the axis it is held, or, of a string that hangs from a hoist, free
//! to move with the mass of that. In bending the surface is held as [`crate::SurfaceSupport`] says.
//! The bit is free, and so is the string where it may touch the borehole wall, unless places are
//! said to hold it.
//!
//! A uniform rod that is held at one end and free at the other has those of its odd quarter waves:
//!
//! ```
//! use linear::natural_frequencies::NaturalFrequencies;
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let modes = NaturalFrequencies::torsion(&string)?;
//! let quarter_wave = 0.25 * std::f64::consts::TAU * string.torsional_wave_speed() / 1000.0;
//! for (place, frequency) in modes.lowest(3)?.into_iter().enumerate() {
//!     let odd = (2 * place + 1) as f64;
//!     assert!((frequency / (odd * quarter_wave) - 1.0).abs() < 1e-9);
//! }
//! // The lowest swings as a quarter of a sine, most at the bit.
//! let shape = modes.shape(quarter_wave, 3)?;
//! assert!((shape.amplitudes[1] - 0.5f64.sqrt()).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bending;
mod frequencies;
mod rod;
mod shapes;

pub use frequencies::{NaturalFrequencies, held_lateral_frequencies_below};
pub use shapes::Shape;
