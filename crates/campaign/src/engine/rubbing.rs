//! A string that rubs along its well: torques act at all its nodes.

use anyhow::Result;
use linear::{
    Budget, BuildError, CascadePlan, ChannelRequest, Request, ResponsePlan, Responses,
    SurfaceTorquePlan,
};
use sim::{Simulator, SimulatorPlan, SurfaceTorque, System};

use super::limited;
use super::system_plan::{Stepping, SystemPlan};
use crate::plan::{Setting, StringFriction, is_in_pieces};

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

/// Asks for what [`build`] takes, of a simulator that `moves` otherwise than in torsion, too.
///
/// # Errors
/// Where the method cannot treat the string, or it is more than is left.
pub(super) fn ask(
    plan: &SystemPlan,
    friction: &StringFriction,
    moves: impl Fn(SimulatorPlan) -> SimulatorPlan,
    budget: &Budget,
) -> Result<Stepping, BuildError> {
    let (setting, method, time) = (plan.setting, plan.method, plan.longest_time);
    let (string, nodes) = (&setting.string, friction.nodes.len());
    // Goes once the simulator is there.
    let passing = budget.part();
    if is_in_pieces(method, setting.drive_limit) {
        let frequency = setting.sampling_frequency;
        let cascade = CascadePlan::new(string, method, &friction.nodes, frequency, time)?;
        cascade.ask(&passing)?;
        let taps = cascade.taps();
        let simulator = moves(SimulatorPlan::in_pieces(
            nodes,
            taps,
            string.loss().has_memory(),
            plan.steps(),
        ));
        simulator.ask(budget)?;
        return Ok(Stepping {
            simulator,
            recorded: nodes,
            taps,
            follows_surface: false,
        });
    }
    let request = request(setting, friction, time);
    let of_nodes = ResponsePlan::new(string, method, &request)?;
    of_nodes.ask(&passing)?;
    let taps = of_nodes.torsion_taps();
    let by_responses = SimulatorPlan::by_responses(nodes, nodes, taps, plan.steps());
    let simulator = moves(by_responses.by_method(method));
    if setting.drive_limit.is_some() {
        return Ok(Stepping {
            simulator: limited::ask(plan, &request, simulator, budget)?,
            recorded: nodes,
            taps,
            follows_surface: false,
        });
    }
    let of_surface = SurfaceTorquePlan::new(string, method, &request)?;
    of_surface.ask(&passing)?;
    SurfaceTorque::ask(nodes, of_surface.taps(), budget)?;
    simulator.ask(budget)?;
    Ok(Stepping {
        simulator,
        // Speeds, and the torques that turn the surface.
        recorded: 2 * nodes,
        taps,
        follows_surface: true,
    })
}

/// The simulator of such a string, which bends by `responses` where it has walls, and moves along its axis
/// by them where its bit cuts; and what turns its surface, where the simulator does not know.
///
/// # Errors
/// Where the method cannot treat the string, or more memory is needed than is left.
pub(super) fn build(
    setting: &Setting,
    friction: &StringFriction,
    longest_time: f64,
    responses: &Responses,
    budget: &Budget,
) -> Result<(Simulator, Option<SurfaceTorque>)> {
    let (string, method) = (&setting.string, &responses.method);
    let (profile, inertia) = (&setting.profile, setting.rotor_inertia);
    let (frequency, nodes) = (setting.sampling_frequency, friction.nodes.len());
    let steps = sim::plan::steps(longest_time, frequency);
    let moves = |plan: SimulatorPlan| {
        let bends = match responses.bending() {
            None => plan,
            Some(bending) => plan.bending_by(bending.loads.len(), bending.taps()),
        };
        match responses.axial() {
            None => bends,
            Some(axial) => bends.moving_along_by(axial.taps()),
        }
    };
    let passing = budget.part();
    let (system, surface) = if is_in_pieces(method, setting.drive_limit) {
        let plan = CascadePlan::new(string, method, &friction.nodes, frequency, longest_time)?;
        let cascade = plan.build(&passing)?;
        let taps = cascade.longest_response();
        let has_memory = cascade.loss_has_memory;
        moves(SimulatorPlan::in_pieces(nodes, taps, has_memory, steps)).ask(budget)?;
        (System::in_pieces(&cascade, profile, inertia)?, None)
    } else {
        let request = request(setting, friction, longest_time);
        let of_nodes = ResponsePlan::new(string, method, &request)?.build(&passing)?;
        let plan = moves(SimulatorPlan::of_responses(&of_nodes));
        let system = System::started(&of_nodes, profile)?;
        match setting.drive_limit {
            Some(limit) => {
                let drive = (setting, limit);
                (
                    limited::below(system, drive, &of_nodes, (plan, budget))?,
                    None,
                )
            }
            None => {
                let taps = SurfaceTorquePlan::new(string, method, &request)?.build(&passing)?;
                SurfaceTorque::ask(nodes, taps.len(), budget)?;
                let surface = SurfaceTorque::new(&of_nodes, &taps, profile, inertia)?
                    .answering_late(setting.drive_delay());
                plan.ask(budget)?;
                (system, Some(surface))
            }
        }
    };
    let system = match responses.bending() {
        None => system,
        Some(_) => system.bending_by(responses)?,
    };
    let system = match &setting.cutting {
        None => system,
        Some(cutting) => system.moving_along(responses, &cutting.profile)?,
    };
    let simulator = Simulator::of(system).following_torque(friction.follows_torque);
    Ok((simulator, surface))
}
