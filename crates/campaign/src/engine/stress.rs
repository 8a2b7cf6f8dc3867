//! How the moving string is bent and stressed: found after a case, of the forces that it was stepped by.
//!
//! A string that lies in its hole has the moments that it has at rest, and those by which the forces of
//! its walls then differ; one that hangs has the latter alone. Tension is that at rest, and torque the
//! mean that bit and walls below a place take in the closing window.

use sim::{StressMeasures, StressedPlace, Trajectory};

use super::along::{Along, closing_from, tubes_at};
use super::case::Case;
use super::case_error::CaseError;
use super::system_plan::SystemPlan;
use crate::plan::{LateralSettings, Setting};

/// What a motion did to the string over the closing window, where that is to be known.
///
/// # Errors
/// Where its moments cannot be found.
pub(super) fn measures(
    moments: &Along,
    (plan, lateral): (&SystemPlan, &LateralSettings),
    case: &Case,
    motion: &Trajectory,
) -> Result<StressMeasures, CaseError> {
    let (places, setting) = (&lateral.stressed, plan.setting);
    let (window, rate) = (case.scene.timing.closing_window, setting.sampling_frequency);
    let from = closing_from(motion, window, rate);
    let mut moments = moments.of(plan, places, motion, from)?;
    let resting = Resting {
        setting,
        compression: lateral.bending.compression,
        lying: case.lying(setting)?,
    };
    let turned = turned(motion, from, setting.sampling_frequency);
    let sites = setting.sites.distances_from_bit();
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
            tubes: tubes_at(setting, place),
            tension: resting.tension(place),
            torque: torque_below(motion, sites, place, from),
            moments,
            turned: nearest.map_or(&[], |site| &turned[site]),
        }
    });
    Ok(StressMeasures::of(stressed))
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
