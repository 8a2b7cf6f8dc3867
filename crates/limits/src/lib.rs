//! Limits that are known without a simulation: of stick-slip by Eq. 74, of smooth rotation where the
//! torque falls with the bit's speed, and of whirl by steady motions, each from the exact waves of
//! the string.
//!
//! [`boundary`] gives the limit of a sweep, and `boundary.csv`; [`Curve`]s are what a map shows of
//! it. What is solved of the waves is the business of `linear` and `sim`.

mod boundary;
mod curves;
mod envelope;
mod forward_contact;
mod many_sites_limit;
mod sliding_together;
mod whirl_limit;

pub use boundary::{
    Boundary, BoundaryError, StickSlipPoint, TorsionLimit, boundary, boundary_csv,
    exact_stick_slip_limit, read_boundary, whirl_boundary,
};
pub use curves::Curve;
pub use envelope::Envelope;
pub use forward_contact::ForwardContact;
pub use many_sites_limit::{MOST_SITES, many_sites_limit};
pub use whirl_limit::{
    WhirlMotion, WhirlPoint, rolling_bound, rolling_envelope, rolling_whirls, whirl_from,
    whirl_limit,
};
