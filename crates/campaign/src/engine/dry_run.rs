//! A dry run of building the linear system of a method: what it asks for, in the order in which it
//! is built.

use linear::{Budget, BuildError, ChannelRequest, MarginPlan, Request, ResponsePlan};
use sim::SimulatorPlan;

use super::limited;
use super::poles;
use super::rubbing;
use super::stepped::{self, stepped_by};
use super::system_plan::{Stepping, SystemPlan};

/// Asks for what building takes.
///
/// # Errors
/// Where the method cannot treat the string, responses would be too long, or it is more than is
/// left.
pub(super) fn ask(plan: &SystemPlan, budget: &Budget) -> Result<Stepping, BuildError> {
    if let Some((lateral, parameters)) = stepped_by(plan.setting, plan.method) {
        return stepped::ask(plan, lateral, &parameters, budget);
    }
    let request = plan.request_of_taps();
    let responses = ResponsePlan::new(&plan.setting.string, plan.method, &request)?;
    ask_for_responses(plan, (&request, &responses), budget)
}

/// The same of a system that is made of such responses.
///
/// # Errors
/// As [`ask`].
pub(super) fn ask_for_responses(
    plan: &SystemPlan,
    (request, responses): (&Request, &ResponsePlan),
    budget: &Budget,
) -> Result<Stepping, BuildError> {
    responses.ask(budget)?;
    let (sites, loads) = (request.sites.len(), loads(request));
    let (taps, bending_taps) = (responses.torsion_taps(), responses.bending_taps());
    let moves = |simulator: SimulatorPlan| {
        let bends = match bending_taps {
            0 => simulator,
            _ => {
                let lies = plan.setting.lying.is_some();
                simulator.bending_by(sites, bending_taps).lying(lies)
            }
        };
        match plan.setting.cutting {
            None => bends,
            Some(_) => bends.moving_along_by(responses.axial_taps()),
        }
    };
    let mut stepping = match &plan.setting.friction {
        Some(friction) => rubbing::ask(plan, friction, moves, budget)?,
        None => {
            let simulator = SimulatorPlan::by_responses(sites, loads, taps, plan.steps());
            let mut simulator = moves(simulator.by_method(plan.method));
            match plan.setting.drive_limit {
                None => simulator.ask(budget)?,
                Some(_) => simulator = limited::ask(plan, request, simulator, budget)?,
            }
            Stepping {
                simulator,
                recorded: sites,
                taps,
                follows_surface: false,
            }
        }
    };
    MarginPlan::in_torsion(loads, taps).ask(budget)?;
    if plan.setting.cutting.is_some() {
        MarginPlan::in_torsion(1, responses.axial_taps()).ask(budget)?;
    }
    if bending_taps > 0 {
        MarginPlan::in_bending(plan.method, sites, bending_taps).ask(budget)?;
    }
    stepping.simulator = poles::ask(plan, stepping.simulator, budget)?;
    Ok(stepping)
}

/// Torques that act.
fn loads(request: &Request) -> usize {
    let of_channel = |channel: &ChannelRequest| match channel {
        ChannelRequest::Torsion { torques } => torques.len(),
        _ => 0,
    };
    request.channels.iter().map(of_channel).sum()
}
