//! How the moving string is bent and stressed: found after a case, of the forces that it was stepped by.
//!
//! A string that lies in its hole has the moments that it has at rest, and those by which the forces of
//! its walls then differ; one that hangs has the latter alone. Tension is that at rest, and torque the
//! mean that bit and walls below a place take in the closing window.

use anyhow::Result;
use linear::elements::reconstruction::WholeString;
use linear::{Budget, BuildError, MomentPlan, Tube};
use sim::{BendingMoments, StressMeasures, StressedPlace, Trajectory};

use super::case::Case;
use super::case_error::CaseError;
use super::stepped::stepped_by;
use super::system_plan::SystemPlan;
use crate::plan::{LateralSettings, Setting};

/// Moments by forces, as a method has them.
#[derive(Debug)]
pub(super) enum Moments {
    /// By responses.
    Responses(BendingMoments),
    /// By stepping its elements once more.
    Elements,
}

/// The string of a method that steps its elements, and where it is stressed.
fn stepped_string<'a>(plan: &SystemPlan<'a>) -> Option<WholeString<'a>> {
    let (lateral, parameters) = stepped_by(plan.setting, plan.method)?;
    Some(WholeString {
        string: &plan.setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &plan.setting.sites,
        sampling_frequency: plan.setting.sampling_frequency,
        parameters,
    })
}

/// Asks for what moments take of a budget, where they are found, and returns the bytes of a case.
///
/// # Errors
/// Where they cannot be built, or are more than is left.
pub(super) fn ask(plan: &SystemPlan, budget: &Budget) -> Result<f64, BuildError> {
    let Some(lateral) = stressed(plan.setting) else {
        return Ok(0.0);
    };
    let (places, sites) = (&lateral.stressed, plan.setting.sites.len());
    if let Some(whole) = stepped_string(plan) {
        return Ok(whole.need_of_moments(places.len(), plan.steps()).peak);
    }
    let request = plan.request();
    let moments = MomentPlan::new(&plan.setting.string, plan.method, &request, places)?;
    let passing = budget.part();
    moments.ask(&passing)?;
    let count = (places.len(), sites);
    BendingMoments::ask(count, moments.taps(), budget)?;
    Ok(BendingMoments::bytes_of_motion(
        count,
        moments.taps(),
        plan.steps(),
    ))
}

/// The lateral part of a setting, where stress is measured.
fn stressed(setting: &Setting) -> Option<&LateralSettings> {
    let lateral = setting.lateral.as_ref();
    lateral.filter(|lateral| !lateral.stressed.is_empty())
}

impl Moments {
    /// Of a setting, where they are found.
    ///
    /// # Errors
    /// Where the method does not treat the string.
    pub(super) fn of(plan: &SystemPlan) -> Result<Option<Self>> {
        let Some(lateral) = stressed(plan.setting) else {
            return Ok(None);
        };
        if stepped_string(plan).is_some() {
            return Ok(Some(Self::Elements));
        }
        let request = plan.request();
        let (string, places) = (&plan.setting.string, &lateral.stressed);
        let responses = MomentPlan::new(string, plan.method, &request, places)?;
        let responses = responses.build(&Budget::unlimited())?;
        Ok(Some(Self::Responses(BendingMoments::new(responses)?)))
    }

    /// What a motion did to the string over the closing window.
    ///
    /// # Errors
    /// Where its moments cannot be found.
    pub(super) fn measures(
        &self,
        plan: &SystemPlan,
        case: &Case,
        motion: &Trajectory,
    ) -> Result<Option<StressMeasures>, CaseError> {
        let Some(lateral) = stressed(plan.setting) else {
            return Ok(None);
        };
        let places = &lateral.stressed;
        let window = case.scene.timing.closing_window * plan.setting.sampling_frequency;
        let from = (motion.times.len()).saturating_sub((window.round() as usize).max(1));
        let failed = |error: anyhow::Error| CaseError::Responses(error);
        let mut moments = match (self, stepped_string(plan)) {
            (Self::Responses(moments), _) => {
                let moments = moments.of(&motion.forces, from);
                moments.map_err(|error| failed(error.into()))?
            }
            (Self::Elements, None) => return Ok(None),
            (Self::Elements, Some(whole)) => {
                let free = plan.setting.sites.without_springs();
                let whole = WholeString {
                    sites: &free,
                    ..whole
                };
                let moments = whole.moments(&motion.forces, places, from);
                moments.map_err(|error| failed(error.into()))?
            }
        };
        let resting = Resting {
            setting: plan.setting,
            compression: lateral.bending.compression,
            lying: case.lying(plan.setting)?,
        };
        let turned = turned(motion, from, plan.setting.sampling_frequency);
        let sites = plan.setting.sites.distances_from_bit();
        for (place, moments) in places.iter().zip(&mut moments) {
            for (moments, resting) in moments.iter_mut().zip(resting.moment(*place)) {
                moments.iter_mut().for_each(|moment| *moment += resting);
            }
        }
        let stressed = places.iter().zip(&moments).map(|(&place, moments)| {
            let apart = |site: &usize| (sites[*site] - place).abs();
            let nearest = (0..sites.len()).min_by(|one, other| apart(one).total_cmp(&apart(other)));
            StressedPlace {
                from_bit: place,
                tubes: tubes_at(plan.setting, place),
                tension: resting.tension(place),
                torque: torque_below(motion, sites, place, from),
                moments,
                turned: nearest.map_or(&[], |site| &turned[site]),
            }
        });
        Ok(Some(StressMeasures::of(stressed)))
    }
}

/// The string as it is at rest.
struct Resting<'a> {
    setting: &'a Setting,
    /// N, tension where negative.
    compression: f64,
    lying: Option<statics::StaticState>,
}

impl Resting<'_> {
    /// Bending moment in both planes at a distance from the bit (m), N m.
    fn moment(&self, place: f64) -> [f64; 2] {
        (self.lying.as_ref()).map_or([0.0; 2], |state| state.at(place).moment)
    }

    /// Effective tension there, N.
    fn tension(&self, place: f64) -> f64 {
        if let Some(state) = &self.lying {
            return state.at(place).tension;
        }
        let string = &self.setting.string;
        let depth = string.length() - place;
        let mut reached = 0.0;
        let piece = string.axial_force().iter().find(|piece| {
            reached += piece.length;
            depth <= reached
        });
        piece.map_or(0.0, |piece| piece.tension) - self.compression
    }
}

/// The tubes that meet at a distance from the bit (m).
fn tubes_at(setting: &Setting, place: f64) -> [Tube; 2] {
    let sections = setting.string.sections();
    let parts = setting.string.parts_around(place);
    parts.map(|(section, part)| sections[section].parts[part])
}

/// By how much each site has turned in each step from one on, rad.
fn turned(motion: &Trajectory, from: usize, sampling_frequency: f64) -> Vec<Vec<f64>> {
    let of_site = |speeds: &Vec<f64>| {
        let mut angle = 0.0;
        let speeds = speeds[from..].iter();
        let angles = speeds.map(|speed| {
            angle += speed / sampling_frequency;
            angle
        });
        angles.collect()
    };
    motion.speeds.iter().map(of_site).collect()
}

/// The mean torque from one step on that the bit and the walls at sites (m from the bit) up to a place
/// take, N m.
fn torque_below(motion: &Trajectory, sites: &[f64], place: f64, from: usize) -> f64 {
    let mean = |torques: &[f64]| {
        let closing = torques.get(from..).unwrap_or_default();
        closing.iter().sum::<f64>() / closing.len().max(1) as f64
    };
    let walls = sites.iter().zip(&motion.wall_torques);
    let below = walls.filter(|(site, _)| **site <= place);
    let of_walls: f64 = below.map(|(_, torques)| mean(torques)).sum();
    mean(&motion.torque_on_string()) + of_walls
}
