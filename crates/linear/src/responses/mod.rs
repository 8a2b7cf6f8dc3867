//! From a drillstring to its responses by any method, no longer than the response lasts
//! or the simulation needs.

pub(crate) mod bending;
mod channels;
pub(crate) mod decay;
mod earlier;
pub(crate) mod length;
mod margin;
mod request;
pub(crate) mod torsion;
pub(crate) mod trains;
mod wanted;

pub use channels::{ChannelResponses, Responses};
pub use earlier::Earlier;
pub use request::{ChannelRequest, Request};
pub use torsion::surface_torque;
pub use trains::ImpulseTrains;

use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::Method;
use crate::parallel;

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
    responses_of(string, method, request, None, None)
}

/// The same, with the trains of impulses of such a request that held responses in torsion
/// are made of: those at many sampling frequencies then cost little more than those at one.
///
/// # Errors
/// As [`responses()`], and where the trains are those of another string or request.
pub fn responses_with(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    trains: &ImpulseTrains,
) -> Result<Responses, BuildError> {
    responses_of(string, method, request, Some(trains), None)
}

/// As [`responses()`], to the bit. Channels in which the string moves as an earlier one are
/// taken over: with another torsional damping or top drive it bends as before.
///
/// # Errors
/// As [`responses()`].
pub fn responses_after(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    earlier: Earlier,
) -> Result<Responses, BuildError> {
    responses_of(string, method, request, None, Some(earlier))
}

fn responses_of(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    trains: Option<&ImpulseTrains>,
    earlier: Option<Earlier>,
) -> Result<Responses, BuildError> {
    request.check(string)?;
    let build = |channel: usize| {
        let wanted = &request.channels[channel];
        let known = earlier.and_then(|earlier| earlier.channel(string, method, request, wanted));
        match (known, wanted) {
            (Some(known), _) => Ok(known.clone()),
            (None, ChannelRequest::Torsion { torques }) => {
                torsion::responses(string, method, request, torques, trains)
            }
            (None, ChannelRequest::Bending { bending, support }) => {
                bending::responses(string, method, request, bending, *support)
            }
        }
    };
    let channels: Vec<Result<ChannelResponses, BuildError>> =
        parallel::map(request.channels.len(), 1, build);
    Ok(Responses {
        string: string.id(),
        method: *method,
        sites: request.sites.clone(),
        sampling_frequency: request.sampling_frequency,
        longest_time: request.longest_time,
        channels: channels.into_iter().collect::<Result<_, _>>()?,
    })
}
