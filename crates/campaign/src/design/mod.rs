//! The cases of a sweep: which values their axes take.

mod axes;
mod cases;
mod correlation;
mod direction_numbers;
mod distribution;
mod grid;
mod list;
mod monte_carlo;
mod points;
mod random_axes;
mod sensitivity;
mod sobol;
mod trace;

pub use axes::MOST_CASES;
pub use cases::Design;
pub use list::List;
pub use sensitivity::{Member, cases_of_block};
pub use trace::TraceDesign;
