//! The limits of a traced design: from the labels of its cases to its tables.

mod tables;

pub use tables::{TracedLimits, write_traced};
