//! The well that the string lies in: its course, and how the string presses on its wall.

mod side_force;
mod survey;

pub use side_force::{PressedBy, SideForce};
pub use survey::{Station, Survey, SurveyError};
