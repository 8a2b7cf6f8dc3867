//! Follows cases to the end of their time with the linear systems of a run.

use anyhow::{Context, Result};
use sim::{Outcome, Stopping, Trajectory};

use super::answer::answer;
use super::case::Case;
use super::longer::reached;
use super::run_options::RunOptions;
use super::simulation::Simulation;
use super::systems::{MethodSystem, Recipe};
use crate::plan::Sweep;
use crate::records::Record;
use crate::words::short;

/// The linear systems of one method.
pub struct FollowedMethod {
    /// What a run steps a case against.
    case: MethodSystem,
    /// The same with the places that are only watched: in the first they would change the
    /// mesh of finite elements, and so the case.
    watched: Option<MethodSystem>,
}

impl FollowedMethod {
    /// Of what a run steps a case against, for cases up to the longest.
    ///
    /// # Errors
    /// Where the method does not treat the places that are only watched, or the surface.
    pub fn new(sweep: &Sweep, mut case: MethodSystem, longest: f64) -> Result<Self> {
        // What the motor does is shown, asked for or not, unless it is known.
        let is_driven = case.setting.string.top_drive().is_some();
        if is_driven && !sweep.content.follows_surface() && !sweep.finds_surface_torque() {
            case.follow_surface()?;
        }
        let is_watched = sweep.setting.sites.len() > case.setting.sites.len();
        let watched = is_watched.then(|| {
            Recipe::alone(&sweep.setting, case.method, sweep.bit.is_some(), longest).build()
        });
        Ok(Self {
            watched: watched.transpose()?,
            case,
        })
    }

    /// What a run steps a case against.
    pub fn system(&self) -> &MethodSystem {
        &self.case
    }

    /// The row that a run has of a case by a `method`, given by its place in the sweep's
    /// list, and the motion where there is an answer. Pictures name it by its method alone
    /// if the case is the only one.
    ///
    /// # Errors
    /// Where the case, followed to its end, has no answer after all.
    pub fn simulate(
        &self,
        sweep: &Sweep,
        case: &Case,
        method: usize,
        options: RunOptions,
        is_alone: bool,
    ) -> Result<(Record, Option<Simulation>)> {
        let row = answer(&self.case, case, method, options, sweep);
        let Ok(answer) = row.outcome else {
            return Ok((row, None));
        };
        let (trajectory, followed) = self.follow(sweep, case, &row)?;
        let name_of_method = self.case.method.name();
        let simulation = Simulation {
            case: case.index,
            method: name_of_method,
            name: name(sweep, case, name_of_method, is_alone),
            trajectory,
            answer,
            site_from_bit_m: row.site_from_bit_m,
            wall_push: row.wall_push,
            followed,
        };
        Ok((row, Some(simulation)))
    }

    /// The motion of a case to the end of its time, or of that for which it was followed.
    fn follow(&self, sweep: &Sweep, case: &Case, row: &Record) -> Result<(Trajectory, Outcome)> {
        let (system, case) = reached(&self.case, case, sweep, row);
        let case = case.as_ref();
        let (mut motion, outcome) = whole(system, case)?;
        system.add_surface_torque(case, &mut motion);
        let driven = match &self.watched {
            None => None,
            // A drive whose torque is limited turns all places.
            Some(watched) if watched.setting.drive_limit.is_some() => {
                Some(whole(watched, case)?.0.speeds)
            }
            Some(watched) => watched.driven_speeds(case, &motion),
        };
        if let Some(mut speeds) = driven {
            // The bit, which is the last, has been simulated.
            speeds.pop();
            speeds.append(&mut motion.speeds);
            motion.speeds = speeds;
        }
        Ok((motion, outcome))
    }
}

/// The motion of a case by a system to the end of its time.
fn whole(system: &MethodSystem, case: &Case) -> Result<(Trajectory, Outcome)> {
    let mut motion = Trajectory::default();
    let simulated = system.simulate(case, Stopping::Full, Some(&mut motion));
    let outcome = simulated.with_context(|| {
        let method = system.method.name();
        format!("case {} by {method}, followed to its end", case.index)
    })?;
    Ok((motion, outcome))
}

/// The method, and what sets the case apart where there are several.
fn name(sweep: &Sweep, case: &Case, method: &str, is_alone: bool) -> String {
    if is_alone {
        return method.to_owned();
    }
    let axes = sweep.design.axes().iter().zip(&case.values);
    let units = sweep.content.units;
    let values = axes.map(|(axis, &value)| {
        let value = axis.unit(units).number(value);
        format!("{} = {}", axis.symbol(units), short(value))
    });
    format!("{}, {method}", values.collect::<Vec<_>>().join(", "))
}
