//! From a drillstring to its responses by any method, no longer than the response lasts
//! or the simulation needs.
//!
//! A step of torque turns the bit at the speed 1/Z until its front comes back from the surface,
//! after 2L/c, and turns it the other way:
//!
//! ```
//! use linear::estimates::{torsional_impedance, torsional_travel_time};
//! use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let travel_time = torsional_travel_time(&string);
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: 100.0 / travel_time,
//!     longest_time: 4.0 * travel_time,
//! };
//! let responses = linear::responses(&string, &Method::Held, &request)?;
//! let taps = responses.at_bit().ok_or("a torque at the bit was asked for")?;
//! let speed_after = |steps: usize| -> f64 { taps[..=steps].iter().sum() };
//! let impedance = torsional_impedance(&string, &pipe);
//! assert!((speed_after(190) * impedance - 1.0).abs() < 1e-6);
//! assert!((speed_after(210) * impedance + 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bending;
mod channels;
mod decay;
mod drag_at_rest;
mod driven_surface;
mod earlier;
pub(crate) mod length;
mod margin;
mod of_poles;
mod place_quantity;
mod places;
mod plan;
mod request;
mod rounds;
mod slowest;
mod torsion;
mod trains;
mod wanted;

pub use channels::{ChannelResponses, Responses};
pub use driven_surface::{DrivenSurface, DrivenSurfacePlan, IntegralRule};
pub use earlier::Earlier;
pub use margin::MarginPlan;
pub use place_quantity::PlaceQuantity;
pub use places::{PlacePlan, PlaceResponses};
pub use plan::ResponsePlan;
pub use request::{ChannelRequest, Request};
pub use torsion::{SurfaceTorquePlan, surface_torque};
pub use trains::ImpulseTrains;

use crate::budget::Budget;
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::Method;

/// Builds the responses of a string by one method, its channels side by side, however much memory
/// that takes ([`ResponsePlan`] asks for it).
///
/// # Errors
/// Where a parameter is out of range, the method cannot treat the string, or the
/// responses would be too long.
pub fn responses(
    string: &Drillstring,
    method: &Method,
    request: &Request,
) -> Result<Responses, BuildError> {
    ResponsePlan::new(string, method, request)?.build(&Budget::unlimited())
}
