//! Studies: one question asked of every method, answered by a table and a chart.

pub mod stability;
