//! When the elements of a string are stepped instead of summing their taps.

use anyhow::Result;
use linear::method::FiniteElement;
use linear::{Method, Responses, SteppedString};
use sim::Simulator;

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
    // A string that rubs is stepped in pieces, and bends by taps.
    let is_in_pieces = setting.friction.is_some();
    (are_many && !is_in_pieces).then_some((lateral, *parameters))
}

/// The sites whose own responses are to be known: those of impulses, and the lowest.
pub fn looked_at(setting: &Setting) -> Vec<usize> {
    let lateral = setting.lateral.iter();
    let impulses = lateral.flat_map(|lateral| &lateral.impulses);
    let mut sites: Vec<usize> = impulses.map(|impulse| impulse.site).collect();
    sites.push(setting.sites.len() - 1);
    sites.sort_unstable();
    sites.dedup();
    sites
}

/// The mesh of a setting, ready to simulate with, and its responses.
///
/// # Errors
/// Where it cannot be built.
pub fn build(
    setting: &Setting,
    lateral: &LateralSettings,
    parameters: &FiniteElement,
    longest_time: f64,
) -> Result<(Responses, Simulator)> {
    let mesh = SteppedString::new(
        &setting.string,
        &lateral.bending,
        lateral.support,
        &setting.sites,
        parameters,
        setting.sampling_frequency,
    )?;
    let responses = mesh.responses(&looked_at(setting), longest_time)?;
    let simulator = Simulator::stepped(&mesh, &responses, &setting.profile)?;
    Ok((responses, simulator))
}
