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

mod beam_column;
pub mod buckling;
pub mod climb;
mod swing;
mod touchdown;
mod trigonometry;

pub use beam_column::{BeamColumn, BentSpan};
pub use swing::{LyingPipe, with_amplitude};
pub use touchdown::{Touchdown, touchdown};
