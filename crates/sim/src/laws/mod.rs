//! What acts on the string where it is not linear (Section 4 of the paper).

pub mod bit;
pub mod rock;
pub mod wall;
