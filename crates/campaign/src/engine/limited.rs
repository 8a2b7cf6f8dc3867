//! A string below a drive whose torque is limited.

use anyhow::Result;
use linear::{Budget, BuildError, DrivenSurfacePlan, Request, Responses};
use sim::{LimitedDrive, Simulator, SimulatorPlan, System};

use super::system_plan::SystemPlan;
use crate::plan::Setting;

/// Asks for what [`build`] takes, of a simulator that is planned but for the drive.
///
/// # Errors
/// Where the method cannot treat the drive, or it is more than is left.
pub(super) fn ask(
    plan: &SystemPlan,
    request: &Request,
    simulator: SimulatorPlan,
    budget: &Budget,
) -> Result<SimulatorPlan, BuildError> {
    let surface = DrivenSurfacePlan::new(&plan.setting.string, plan.method, request)?;
    // Goes once the simulator is there.
    let passing = budget.part();
    surface.ask(&passing)?;
    let simulator = simulator.below_limited(surface.taps());
    simulator.ask(budget)?;
    Ok(simulator)
}

/// The simulator of such a string, whose drive gives no more than `limit`, N m.
///
/// # Errors
/// Where the method cannot treat the drive, or more memory is needed than is left.
pub(super) fn build(
    setting: &Setting,
    limit: f64,
    responses: &Responses,
    budget: &Budget,
) -> Result<Simulator> {
    let request = Request {
        sites: responses.sites.clone(),
        channels: Vec::new(),
        sampling_frequency: responses.sampling_frequency,
        longest_time: responses.longest_time,
    };
    let plan = DrivenSurfacePlan::new(&setting.string, &responses.method, &request)?;
    let passing = budget.part();
    let surface = plan.build(&passing)?;
    let taps = surface.speed_by_torque.len();
    (SimulatorPlan::of_responses(responses).below_limited(taps)).ask(budget)?;
    let drive = LimitedDrive::new(&surface, limit, &setting.profile)?;
    let system = System::started(responses, &setting.profile)?;
    Ok(Simulator::of(system.below_limited(drive)?))
}
