//! The well that the string lies in: its course, how the string presses on its wall, and what
//! pulls it along.

mod axial_force;
mod short_lengths;
mod side_force;
mod survey;
mod winding_up;

pub use axial_force::HangingString;
pub use side_force::{PressedBy, SideForce};
pub use survey::{Station, Survey, SurveyError};
pub use winding_up::{TooFine, WindingUp, least_pieces};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.806_65;
