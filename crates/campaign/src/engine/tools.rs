//! What tools along the string feel: accelerations over the closing window at places that may be no sites,
//! found after a case.

use sim::{ShakenPlace, ShockMeasures, Trajectory};

use super::along::{Along, closing_from, tubes_at};
use super::case::Case;
use super::case_error::CaseError;
use super::system_plan::SystemPlan;
use crate::plan::LateralSettings;

/// Steps before the closing window that the first acceleration in it takes.
const STEPS_BEFORE: usize = 2;

/// What the tools of a setting felt; `site` is the number of the one that was shaken most.
///
/// # Errors
/// Where their displacements cannot be found.
pub(super) fn measures(
    displacements: &Along,
    (plan, lateral): (&SystemPlan, &LateralSettings),
    case: &Case,
    motion: &Trajectory,
) -> Result<Option<ShockMeasures>, CaseError> {
    let Some(threshold) = lateral.shocks else {
        return Ok(None);
    };
    let setting = plan.setting;
    let (window, rate) = (case.scene.timing.closing_window, setting.sampling_frequency);
    let from = closing_from(motion, window, rate).saturating_sub(STEPS_BEFORE);
    let positions = displacements.of(plan, &lateral.tools, motion, from)?;
    let sites = setting.sites.distances_from_bit();
    let shaken = lateral.tools.iter().zip(&positions);
    let shaken: Vec<ShakenPlace> = shaken
        .map(|(&place, positions)| ShakenPlace {
            radius: tubes_at(setting, place)
                .map(|tube| tube.outer_radius)
                .into_iter()
                .fold(0.0, f64::max),
            positions,
            speeds: speeds_at(place, sites, &motion.speeds, from),
        })
        .collect();
    Ok(ShockMeasures::of(&shaken, threshold, rate))
}

/// How fast the string turned at a place (m from the bit) in all steps from one on, rad/s: between two sites
/// (from the surface down) evenly from one to the other, beyond them as the nearest.
fn speeds_at(place: f64, sites: &[f64], speeds: &[Vec<f64>], from: usize) -> Vec<f64> {
    let below = sites.partition_point(|site| *site > place);
    let last = sites.len() - 1;
    let (upper, lower) = (below.saturating_sub(1), below.min(last));
    let part = match sites[upper] - sites[lower] {
        0.0 => 0.0,
        apart => ((sites[upper] - place) / apart).clamp(0.0, 1.0),
    };
    let pairs = speeds[upper][from..].iter().zip(&speeds[lower][from..]);
    pairs
        .map(|(upper, lower)| (1.0 - part) * upper + part * lower)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::speeds_at;

    #[test]
    fn between_two_sites_the_string_turns_evenly_from_one_to_the_other() {
        let sites = [30.0, 10.0, 0.0];
        let speeds: Vec<Vec<f64>> = [6.0, 2.0, 1.0].map(|speed| vec![speed; 3]).to_vec();
        for (place, speed) in [
            (40.0, 6.0),
            (30.0, 6.0),
            (15.0, 3.0),
            (10.0, 2.0),
            (4.0, 1.4),
            (0.0, 1.0),
        ] {
            let found = speeds_at(place, &sites, &speeds, 1);
            assert_eq!(found.len(), 2);
            assert!((found[0] - speed).abs() < 1e-12, "{place} m: {found:?}");
        }
        assert_eq!(speeds_at(7.0, &sites[2..], &speeds[2..], 0), [1.0; 3]);
    }
}
