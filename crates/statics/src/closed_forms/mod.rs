//! Closed forms of single spans and of a straight string on the low side of its hole: what the
//! string of [`crate::LyingString`] is compared with, and limits that need no simulation. Each says
//! whether it is necessary or sufficient for what it is a limit of.
//!
//! | what | where |
//! |---|---|
//! | a span under a load and an axial force | [`BeamColumn`] |
//! | where a string lies down above its bit | [`touchdown`] |
//! | how it swings about the low side | [`LyingPipe`] |
//! | how it climbs, and when it whirls | [`climb`] |
//! | when it buckles on the low side | [`buckling`] |
//!
//! ```
//! use statics::closed_forms::{buckling, touchdown};
//!
//! // Collars of EI 17 MN m² in a hole that leaves 54 mm, 1.6 kN/m across it, 100 kN on the bit.
//! let (rigidity, clearance, load, weight_on_bit) = (17e6, 0.054, 1600.0, 100e3);
//! let down = touchdown(rigidity, clearance, load, weight_on_bit);
//! assert!((10.0..12.0).contains(&down.length));
//! assert!(weight_on_bit < 0.1 * buckling::of_lying_string(rigidity, load, clearance));
//! ```

mod beam_column;
pub mod buckling;
pub mod climb;
mod swing;
mod touchdown;
mod trigonometry;

pub use beam_column::{BeamColumn, BentSpan};
pub use swing::{LyingPipe, with_amplitude};
pub use touchdown::{Touchdown, touchdown};
