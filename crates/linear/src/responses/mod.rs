//! From a drillstring to its responses by any method, no longer than the response lasts
//! or the simulation needs.

mod bending;
mod channels;
mod decay;
mod earlier;
pub(crate) mod length;
mod margin;
mod plan;
mod request;
mod rounds;
mod slowest;
mod torsion;
mod trains;
mod wanted;

pub use channels::{ChannelResponses, Responses};
pub use earlier::Earlier;
pub use margin::MarginPlan;
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
