//! A string below a drive whose torque is limited.

use anyhow::Result;
use linear::{Budget, BuildError, DrivenSurfacePlan, Request, Responses};
use sim::{LimitedDrive, SimulatorPlan, System};

use super::system_plan::SystemPlan;
use crate::plan::Setting;

/// Asks for what [`below`] takes, of a simulator that is planned but for the drive.
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

/// The same system below its drive, which gives no more than `limit` (N m), of `responses` in torsion; of a
/// simulator that is planned but for that.
///
/// # Errors
/// Where the method cannot treat the drive, or more memory is needed than is left.
pub(super) fn below(
    system: System,
    (setting, limit): (&Setting, f64),
    responses: &Responses,
    (simulator, budget): (SimulatorPlan, &Budget),
) -> Result<System> {
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
    simulator.below_limited(taps).ask(budget)?;
    let ports = responses
        .torsion()
        .map_or(&[][..], |torsion| torsion.loads.as_slice());
    let drive = LimitedDrive::new(&surface, ports, limit, &setting.profile)?;
    Ok(system.below_limited(drive)?)
}
