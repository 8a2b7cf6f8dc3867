//! A string that rubs along its well: torques act at all its nodes.

use anyhow::Result;
use linear::{Cascade, ChannelRequest, Method, Request, Responses};
use sim::{Simulator, SurfaceTorque, System};

use crate::plan::{Setting, StringFriction};

/// Whether a method steps a string that rubs piece by piece, whose responses are short: where joining
/// pieces and making responses of them may change places. By others responses of the whole string
/// lead from each node to every other.
pub(super) fn is_in_pieces(method: &Method) -> bool {
    matches!(method, Method::Quadrature | Method::FiniteElement(_))
}

/// What responses of the whole string are built from, with torques at all nodes.
pub(super) fn request(setting: &Setting, friction: &StringFriction, longest_time: f64) -> Request {
    let sites = friction.nodes.clone();
    Request {
        channels: vec![ChannelRequest::Torsion {
            torques: (0..sites.len()).collect(),
        }],
        sites,
        sampling_frequency: setting.sampling_frequency,
        longest_time,
    }
}

/// The simulator of such a string, which bends by `responses` where it has walls; and what turns its
/// surface, where the simulator does not know.
///
/// # Errors
/// Where the method cannot treat the string.
pub(super) fn build(
    setting: &Setting,
    friction: &StringFriction,
    longest_time: f64,
    responses: &Responses,
) -> Result<(Simulator, Option<SurfaceTorque>)> {
    let (string, method) = (&setting.string, &responses.method);
    let (profile, inertia) = (&setting.profile, setting.rotor_inertia);
    let (system, surface) = if is_in_pieces(method) {
        let frequency = setting.sampling_frequency;
        let cascade = Cascade::new(string, method, &friction.nodes, frequency, longest_time)?;
        (System::in_pieces(&cascade, profile, inertia)?, None)
    } else {
        let request = request(setting, friction, longest_time);
        let of_nodes = linear::responses(string, method, &request)?;
        let taps = linear::surface_torque(string, method, &request)?;
        let surface = SurfaceTorque::new(&of_nodes, &taps, profile, inertia)?;
        (System::started(&of_nodes, profile)?, Some(surface))
    };
    let system = match &setting.lateral {
        None => system,
        Some(_) => system.bending_by(responses)?,
    };
    let simulator = Simulator::of(system).following_torque(friction.follows_torque);
    Ok((simulator, surface))
}
