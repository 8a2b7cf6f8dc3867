//! From a drillstring to its responses by any method, no longer than the response lasts
//! or the simulation needs.

pub(crate) mod bending;
mod channels;
pub(crate) mod decay;
pub(crate) mod length;
mod margin;
mod request;
pub(crate) mod torsion;

pub use channels::{ChannelResponses, Responses};
pub use request::{ChannelRequest, Request};

use rayon::prelude::*;

use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::Method;

/// Builds the responses of a string by one method, its channels side by side.
///
/// # Errors
/// Where a parameter is out of range, the method cannot treat the string, or the
/// responses would not fit in memory.
pub fn responses(
    string: &Drillstring,
    method: &Method,
    request: &Request,
) -> Result<Responses, BuildError> {
    request.check(string)?;
    let build = |channel: &ChannelRequest| match channel {
        ChannelRequest::Torsion { torques } => torsion::responses(string, method, request, torques),
        ChannelRequest::Bending { bending, support } => {
            bending::responses(string, method, request, bending, *support)
        }
    };
    let channels: Vec<Result<ChannelResponses, BuildError>> =
        request.channels.par_iter().map(build).collect();
    Ok(Responses {
        string: string.id(),
        method: *method,
        sites: request.sites.clone(),
        sampling_frequency: request.sampling_frequency,
        longest_time: request.longest_time,
        channels: channels.into_iter().collect::<Result<_, _>>()?,
    })
}
