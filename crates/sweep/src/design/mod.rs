//! The cases of a sweep: which values their axes take.

mod axes;
mod cases;
mod correlation;
mod distribution;
mod grid;
mod list;
mod monte_carlo;
mod trace;

pub use axes::MOST_CASES;
pub use cases::Design;
pub use list::List;
pub use trace::TraceDesign;
