//! The operating window: where, over weight on bit and surface speed, no limit is near.
//!
//! What a limit says of a stretch of the map is its `standing` there: by cases at the points of a
//! lattice or in ranges (`simulated`), or by an analytic curve (`analytic`). A `chart` puts the
//! limits over one another; `regions` are where all of them are clear, and `best` is the point
//! in them that a stated rule prefers. An `operating` window is all that of a sweep and results
//! folders of its string (`of_folders`, `lateral`).

mod analytic;
mod asked;
mod best;
mod chart;
mod error;
mod lateral;
mod of_folders;
mod operating;
mod regions;
mod simulated;
mod standing;

pub use asked::WindowAsked;
pub use best::{Best, Room};
pub use chart::{Chart, Drawn, Limit, WINDOW_COLUMNS};
pub use error::WindowError;
pub use operating::OperatingWindow;
pub use regions::Region;
pub use simulated::AXES;
pub use standing::Standing;
