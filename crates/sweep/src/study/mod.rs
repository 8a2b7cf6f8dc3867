//! Studies of the methods themselves, on the paper's string.

mod scenes;
pub mod tradeoff;
