//! The well that the string lies in: its course, how the string presses on its wall, and what
//! pulls it along.

mod axial_force;
mod quasi_static_twist;
mod short_lengths;
mod side_force;
mod survey;

pub use axial_force::HangingString;
pub use quasi_static_twist::{QuasiStaticTwist, TooFine, least_pieces};
pub use side_force::{PressedBy, SideForce};
pub use survey::{Station, Survey, SurveyError};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.806_65;
