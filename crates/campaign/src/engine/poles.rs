//! Bending by the poles of a string, where its method has them.

use anyhow::Result;
use linear::{BendingPoles, Budget, BuildError, Method, PolePlan, Responses};
use sim::{Simulator, SimulatorPlan};

use super::stepped::observed;
use super::system_plan::SystemPlan;
use crate::plan::Setting;

/// The poles of a setting before they are built; `None` where it does not bend by poles.
fn plan<'a>(setting: &'a Setting, method: &Method) -> Result<Option<PolePlan<'a>>, BuildError> {
    let Some(lateral) = (setting.lateral.as_ref()).filter(|_| *method == Method::Poles) else {
        return Ok(None);
    };
    let bends = (&lateral.bending, lateral.support);
    let frequency = setting.sampling_frequency;
    let plan = PolePlan::new(&setting.string, bends, &setting.sites, frequency)?;
    Ok(Some(plan.seen_at(&setting.tools)))
}

/// Asks for what [`build`] takes; the simulator bends by poles, too.
///
/// # Errors
/// Where it cannot be built, or is more than is left.
pub(super) fn ask(
    system: &SystemPlan,
    simulator: SimulatorPlan,
    budget: &Budget,
) -> Result<SimulatorPlan, BuildError> {
    let Some(poles) = plan(system.setting, system.method)? else {
        return Ok(simulator);
    };
    poles.ask(budget)?;
    let sites = system.setting.sites.len();
    BendingPoles::ask_for_responses(
        (sites, observed(system.setting).len()),
        (system.longest_time, system.setting.sampling_frequency),
        budget,
    )?;
    let simulator = simulator.bending_by_poles(sites, &poles);
    Ok(simulator.lying(system.setting.lying.is_some()))
}

/// A simulator that bends by poles, where the method of its responses has them, and these, seen at the tools of
/// the setting, too; to the responses those are added that are read.
///
/// # Errors
/// Where there are none, or more memory is needed than is left.
pub(super) fn build(
    setting: &Setting,
    simulator: Simulator,
    responses: &mut Responses,
    budget: &Budget,
) -> Result<(Simulator, Option<BendingPoles>)> {
    let has_bending = responses.bending().is_some();
    let plan = plan(setting, &responses.method)?.filter(|_| !has_bending);
    let Some(plan) = plan else {
        return Ok((simulator, None));
    };
    let poles = plan.build(budget)?;
    let seen = poles.responses(&observed(setting), responses.longest_time)?;
    responses.channels.push(seen);
    let simulator = simulator.bending_by_poles(&poles, &setting.sites)?;
    Ok((simulator, Some(poles)))
}
