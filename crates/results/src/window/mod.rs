//! The operating window: where, over weight on bit and surface speed, no limit is near.
//!
//! What a limit says of a stretch of the map is its `standing` there: by cases at the points of a
//! lattice or in ranges (`simulated`), or by an analytic curve (`analytic`). A `chart` puts the
//! limits over one another; `regions` are where all of them are clear, and `best` is the point
//! in them that a stated rule prefers; of a bit that cuts by its `rates` of penetration. An `operating` window is all that of a sweep and results
//! folders of its string (`of_folders`, `lateral`, `motor`, `swings`).
//!
//! Above 80 rpm and below 60 kN, each limit uncertain by 5:
//!
//! ```
//! use results::window::{Chart, Drawn, Limit, Standing};
//!
//! let edges = |from: f64, step: f64| (0..=20).map(|line| from + step * f64::from(line)).collect();
//! let edges = [edges(0.0, 5.0), edges(40.0, 6.0)];
//! let mut chart = Chart { edges, limits: Vec::new(), rates: Vec::new() };
//! let ends: Vec<_> = chart.cells().map(|cell| chart.ends(cell)).collect();
//! let limit = |name: &str, standing: &dyn Fn([[f64; 2]; 2]) -> Standing| Limit {
//!     name: name.to_owned(),
//!     description: String::new(),
//!     drawn: Drawn::Edge,
//!     standings: ends.iter().map(|ends| standing(*ends)).collect(),
//! };
//! chart.limits = vec![
//!     limit("stick-slip", &|[_, speeds]| Standing::above(speeds, 75.0, 85.0)),
//!     limit("buckling", &|[[low, high], _]| Standing::above([-high, -low], -65.0, -55.0)),
//! ];
//! // As much weight and speed as keeps 5 % of either axis from limits and ends.
//! let best = chart.best(0.05).ok_or("a part is safe")?;
//! assert!(best.is_as_asked);
//! assert_eq!(best.at, [47.5, 151.0]);
//! assert_eq!(best.room[0][1].limits, ["buckling"]);
//! assert_eq!(chart.safe_regions().len(), 1);
//! # Ok::<(), &str>(())
//! ```

mod analytic;
mod asked;
mod best;
mod by_axis;
mod chart;
mod error;
mod how_often_wrong;
mod lateral;
mod motor;
mod of_folders;
mod operating;
mod rates;
mod regions;
mod simulated;
mod standing;
mod swings;

pub use asked::WindowAsked;
pub use best::{Best, Room};
pub use by_axis::by_axis;
pub use chart::{Chart, Drawn, Limit, WINDOW_COLUMNS};
pub use error::WindowError;
pub use how_often_wrong::how_often_wrong;
pub use operating::OperatingWindow;
pub use regions::Region;
pub use simulated::AXES;
pub use standing::Standing;
