//! The cases of a sweep: which values their axes take.
//!
//! Of eight points of Sobol's sequence, each eighth of each axis has one:
//!
//! ```
//! # let text = r#"
//! # methods = ["quadrature"]
//! # [string]
//! # shear_modulus_gpa = 80
//! # density_kg_m3 = 7840
//! # torsional_damping_nms_rad_m = 10
//! # [[string.sections]]
//! # name = "pipe"
//! # repeat = 50
//! # parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
//! # [bit]
//! # rock = "sandstone"
//! # [design]
//! # kind = "monte-carlo"
//! # points = "sobol"
//! # cases = 8
//! # [design.axes]
//! # surface_speed_rpm = { from = 8, to = 88 }
//! # weight_on_bit_kn = { from = 10, to = 90 }
//! # "#;
//! use campaign::Campaign;
//!
//! // `text` has points = "sobol", surface_speed_rpm = { from = 8, to = 88 } and
//! // weight_on_bit_kn = { from = 10, to = 90 }.
//! let campaign = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()))?;
//! let design = &campaign.sweep.design;
//! for (axis, from) in [8.0, 10.0].into_iter().enumerate() {
//!     let values = (0..design.cases()).map(|case| design.values(case)[axis]);
//!     let mut eighths: Vec<usize> = values.map(|value| ((value - from) / 10.0) as usize).collect();
//!     eighths.sort_unstable();
//!     assert_eq!(eighths, [0, 1, 2, 3, 4, 5, 6, 7]);
//! }
//! # Ok::<(), campaign::sweep_file::SweepFileError>(())
//! ```

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
