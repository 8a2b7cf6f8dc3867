//! The limits of a traced design: from the labels of its cases to what is known of its
//! lattice (`layers`), and from there to its tables (`tables`).

mod layers;
mod tables;

pub use layers::{note_labels, nothing_known};
pub use tables::{TracedLimits, write_traced};
