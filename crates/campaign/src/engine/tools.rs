//! What tools along the string feel: accelerations over the closing window at places that may be no sites,
//! found after a case.

use anyhow::Result;
use linear::{Budget, BuildError, ChannelRequest, Request, ResponsePlan, Sites};
use sim::{RatesAtPlaces, ShakenPlace, ShockMeasures, Trajectory};

use super::along::{Along, closing_from, tubes_at};
use super::case::Case;
use super::case_error::CaseError;
use super::system_plan::SystemPlan;
use crate::plan::LateralSettings;

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
    let closing = closing_from(motion, window, rate);
    let from = closing.saturating_sub(ShockMeasures::steps_before(&setting.tool_bands, rate));
    let positions = displacements.of(plan, &setting.tools, motion, from)?;
    let sites = setting.sites.distances_from_bit();
    let tools = setting.tools.iter().zip(&setting.tool_bands);
    let shaken: Vec<ShakenPlace> = (tools.zip(&positions))
        .map(|((&place, &band), positions)| ShakenPlace {
            band,
            radius: tubes_at(setting, place)
                .map(|tube| tube.outer_radius)
                .into_iter()
                .fold(0.0, f64::max),
            positions,
            speeds: speeds_at(place, sites, &motion.speeds, from),
        })
        .collect();
    Ok(ShockMeasures::of(
        &shaken,
        threshold,
        (rate, closing - from),
    ))
}

/// What the rates of penetration at tools are built from, above a bit that cuts: their places and the bit,
/// and the string along its axis.
///
/// # Errors
/// Where a tool is not on the string.
fn along_axis(plan: &SystemPlan) -> Result<Option<Request>, BuildError> {
    let setting = plan.setting;
    let Some(cutting) = setting
        .cutting
        .as_ref()
        .filter(|_| !setting.tools.is_empty())
    else {
        return Ok(None);
    };
    let same_place = setting.string.same_place();
    let mut places = setting.tools.clone();
    if places.last().is_none_or(|lowest| *lowest > same_place) {
        places.push(0.0);
    }
    let bit = places.len() - 1;
    Ok(Some(Request {
        sites: Sites::new(&setting.string, &places)?,
        channels: vec![ChannelRequest::Axial {
            rod: Box::new(cutting.rod.clone()),
            forces: vec![bit],
        }],
        ..plan.request()
    }))
}

/// Asks for what rates at tools take of a budget, where there are any, and returns the bytes of a case.
///
/// # Errors
/// Where they cannot be built, or are more than is left.
pub(super) fn ask_along_axis(plan: &SystemPlan, budget: &Budget) -> Result<f64, BuildError> {
    let Some(request) = along_axis(plan)? else {
        return Ok(0.0);
    };
    let responses = ResponsePlan::new(&plan.setting.string, plan.method, &request)?;
    responses.ask(&budget.part())?;
    RatesAtPlaces::ask(request.sites.len(), responses.axial_taps(), budget)?;
    Ok(RatesAtPlaces::bytes_of_motion(plan.steps()))
}

/// Rates at the tools of a setting above a bit that cuts; `None` without either.
///
/// # Errors
/// Where the method does not treat the string.
pub(super) fn build_along_axis(plan: &SystemPlan) -> Result<Option<RatesAtPlaces>> {
    let (Some(request), Some(cutting)) = (along_axis(plan)?, &plan.setting.cutting) else {
        return Ok(None);
    };
    let responses = ResponsePlan::new(&plan.setting.string, plan.method, &request)?;
    let responses = responses.build(&Budget::unlimited())?;
    let tools = plan.setting.tools.len();
    Ok(Some(RatesAtPlaces::new(
        &responses,
        tools,
        &cutting.profile,
    )?))
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
