//! When the elements of a string are stepped instead of summing their taps.

use anyhow::Result;
use linear::method::FiniteElement;
use linear::{Budget, BuildError, ChannelResponses, MarginPlan, Method, Responses, SteppedPlan};
use sim::{Simulator, SimulatorPlan};

use super::system_plan::{Stepping, SystemPlan};
use crate::plan::{LateralSettings, Setting};

/// Taps between more sites than these take longer to build, to hold and to sum than their
/// elements take to step.
pub(super) const MOST_BY_TAPS: usize = 40;

/// What a method steps of a setting; `None` where taps are summed.
pub fn stepped_by<'a>(
    setting: &'a Setting,
    method: &Method,
) -> Option<(&'a LateralSettings, FiniteElement)> {
    let Method::FiniteElement(parameters) = method else {
        return None;
    };
    let lateral = setting.lateral.as_ref()?;
    // Sites that are found are other ones in every case, whose taps none would use again.
    let are_many = setting.sites.len() > MOST_BY_TAPS || lateral.finding.is_some();
    // A string that rubs is stepped in pieces, and bends by taps; a drive whose torque is limited acts on
    // taps.
    let is_by_taps = setting.friction.is_some() || setting.drive_limit.is_some();
    (are_many && !is_by_taps).then_some((lateral, *parameters))
}

/// The sites whose own responses are to be known: those of impulses, and the lowest.
pub fn observed(setting: &Setting) -> Vec<usize> {
    let lateral = setting.lateral.iter();
    let impulses = lateral.flat_map(|lateral| &lateral.impulses);
    let mut sites: Vec<usize> = impulses.map(|impulse| impulse.site).collect();
    sites.push(setting.sites.len() - 1);
    sites.sort_unstable();
    sites.dedup();
    sites
}

/// The mesh of a setting before it is divided.
fn plan<'a>(
    setting: &'a Setting,
    lateral: &'a LateralSettings,
    parameters: &'a FiniteElement,
) -> SteppedPlan<'a> {
    let bends = (&lateral.bending, lateral.support);
    let frequency = setting.sampling_frequency;
    SteppedPlan::new(
        &setting.string,
        bends,
        &setting.sites,
        parameters,
        frequency,
    )
}

/// Asks for what [`build`] takes, and the margins of its responses.
///
/// # Errors
/// Where it cannot be built, or is more than is left.
pub(super) fn ask(
    system: &SystemPlan,
    lateral: &LateralSettings,
    parameters: &FiniteElement,
    budget: &Budget,
) -> Result<Stepping, BuildError> {
    let (sites, loads) = (system.setting.sites.len(), observed(system.setting).len());
    let mesh = plan(system.setting, lateral, parameters);
    let passing = budget.part();
    let taps = mesh.ask(loads, system.longest_time, (&passing, budget))?;
    let simulator = SimulatorPlan::by_elements(&mesh, sites, taps, system.steps())
        .lying(system.setting.lying.is_some());
    simulator.ask(budget)?;
    drop(passing);
    MarginPlan::in_torsion(loads, taps).ask(budget)?;
    MarginPlan::in_bending_by_steps(loads, taps).ask(budget)?;
    Ok(Stepping {
        simulator,
        recorded: sites,
        taps,
        follows_surface: false,
    })
}

/// The mesh of a setting, ready to simulate with, and its responses.
///
/// # Errors
/// Where it cannot be built, or more memory is needed than is left.
pub fn build(
    setting: &Setting,
    lateral: &LateralSettings,
    parameters: &FiniteElement,
    longest_time: f64,
    budget: &Budget,
) -> Result<(Responses, Simulator)> {
    let plan = plan(setting, lateral, parameters);
    // The simulator has a copy of the mesh.
    let passing = budget.part();
    let mesh = plan.build(&passing)?;
    let responses = mesh.responses_within(&observed(setting), longest_time, budget)?;
    let (sites, taps) = (
        setting.sites.len(),
        responses.torsion().map_or(0, ChannelResponses::taps),
    );
    let steps = sim::plan::steps(longest_time, setting.sampling_frequency);
    SimulatorPlan::by_elements(&plan, sites, taps, steps).ask(budget)?;
    let simulator = Simulator::stepped(&mesh, &responses, &setting.profile)?;
    Ok((responses, simulator))
}
