//! The operating window: where, over weight on bit and surface speed, no limit is near.
//!
//! What a limit says of a stretch of the map is its `standing` there: by cases at the points of a
//! lattice or in ranges (`simulated`), or by an analytic curve (`analytic`). A `chart` puts the
//! limits over one another; `regions` are where all of them are clear, and `best` is the point
//! in them that a stated rule prefers.

mod analytic;
mod best;
mod chart;
mod regions;
mod simulated;
mod standing;

pub use analytic::{Resonance, above_speed, below_curves, near_resonances};
pub use best::{Best, Room};
pub use chart::{Chart, Drawn, Limit, Source};
pub use regions::Region;
pub use simulated::{AXES, Simulated, simulated};
pub use standing::Standing;
