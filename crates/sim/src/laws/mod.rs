//! What acts on the string where it is not linear (Section 4 of the paper): local laws,
//! each of which meets a load line and answers with a force and a new state.

pub mod bit;
pub mod contact;
mod newton;
mod press;
pub mod rock;
pub mod torque;
pub mod wall;
