//! The page that `sweep explore` writes: a case that is simulated anew as its sliders move, by
//! the engine in it.

mod controls;
mod document;
mod whirl;

pub use controls::controls;
pub use document::{Explored, methods_of_page, page};
pub use whirl::whirl_lines;
