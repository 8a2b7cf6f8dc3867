//! What acts on the string where it is not linear (Section 4 of the paper).

pub mod bit;
mod newton;
mod press;
pub mod rock;
pub mod wall;
