//! What acts on the string where it is not linear (Section 4 of the paper): local laws,
//! each of which meets a load line and answers with a force and a new state.

pub mod bit;
mod bracket;
pub mod contact;
mod contact_residual;
mod contact_step;
pub mod cutting;
mod friction_curve;
mod in_step;
pub mod motor;
mod newton;
pub mod pipe;
pub mod rock;
pub mod table;
pub mod torque;
pub mod wall;
