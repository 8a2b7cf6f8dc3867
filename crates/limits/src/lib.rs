//! Lines that are known without a simulation: the one-slip estimate of stick-slip (Eq. 74), limits of
//! smooth rotation where the torque falls with the bit's speed, and of whirl by steady motions, each
//! from the exact waves of the string; and of a string that lies in its hole, from its static states.
//!
//! [`boundary`] gives the limit of a sweep, and `boundary.csv`; [`Curve`]s are what a map shows of
//! it. What is solved of the waves is the business of `linear` and `sim`.
//!
//! Eq. 74 along the weight on bit (`text` is that of a sweep file as in the example of `campaign`):
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
//! # kind = "grid"
//! # [design.axes]
//! # surface_speed_rpm = { values = [0.4, 60] }
//! # weight_on_bit_kn = { values = [50] }
//! # "#;
//! use campaign::Campaign;
//! use limits::{Boundary, exact_stick_slip_limit};
//!
//! let campaign = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()))?;
//! let sweep = &campaign.sweep;
//! let Boundary::StickSlip(points) = exact_stick_slip_limit(sweep, [20.0, 80.0])? else {
//!     return Err("it is of stick-slip".into());
//! };
//! // (T_s − T_d) Δ: the limit is proportional to the torque.
//! let per_torque = |at: usize| points[at].surface_speed_rpm / points[at].torque_dynamic_nm;
//! let last = points.len() - 1;
//! assert!(points[last].surface_speed_rpm > points[0].surface_speed_rpm);
//! assert!((per_torque(last) / per_torque(0) - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axes;
mod bit_resonances;
mod boundary;
mod curves;
mod envelope;
mod forward_contact;
mod growing_roots;
mod lying_limit;
mod many_sites_limit;
mod motor_stall;
mod sliding_together;
mod steady_drilling;
mod torsion_limit;
mod whirl_limit;

pub use bit_resonances::{BitResonance, bit_resonances};
pub use boundary::{
    Boundary, BoundaryError, boundary, boundary_csv, exact_stick_slip_limit, read_boundary,
    whirl_boundary,
};
pub use curves::Curve;
pub use envelope::Envelope;
pub use forward_contact::ForwardContact;
pub use growing_roots::{DrillingPoint, drilling_points};
pub use lying_limit::{LyingLimit, LyingPoint, swing_frequencies};
pub use many_sites_limit::{MOST_SITES, many_sites_limit};
pub use motor_stall::motor_stalls;
pub use torsion_limit::{StickSlipPoint, TorsionLimit};
pub use whirl_limit::{
    WhirlMotion, WhirlPoint, rolling_bound, rolling_envelope, rolling_whirls, whirl_from,
    whirl_limit,
};
