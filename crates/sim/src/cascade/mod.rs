//! Torques at many places of a string that turns: friction along it, and the bit.
//!
//! The string is stepped piece by piece ([`linear::cascade`]): at every node the waves that
//! come out of the pieces beside it leave a load line, and a law meets it as the bit's does
//! (Eqs. 16 and 18). Nodes that feel one another within a step are solved in turn.

mod scene;
mod simulator;
mod solution;
mod stepper;
mod system;
mod waves;

pub use scene::{CascadeScene, NodeTorque};
pub use simulator::CascadeSimulator;
