//! Studies: one question asked of every method, answered by a table and a chart.

mod scenes;
pub mod stability;
pub mod tradeoff;
