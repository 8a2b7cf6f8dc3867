//! Torsional responses by any method (Section 2.4 and 3): taps until the
//! response has decayed, or to the end of the simulation.

use faer::c64;
use rayon::prelude::*;

use super::{
    MOST_TAPS, all_finite, check_request, needed_taps, samples_of, too_many, transform_length,
};
use crate::drillstring::Drillstring;
use crate::elements::newmark::Weights;
use crate::elements::reduction::{CondensedString, StringState};
use crate::error::BuildError;
use crate::estimates::{torsional_decay_rate, torsional_settling_time, torsional_travel_time};
use crate::filters::quadrature::Formula;
use crate::filters::{direct, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::passivity::Ending;
use crate::response::{TorsionRequest, TorsionResponses};
use crate::waves::network::TorsionNetwork;

/// Taps after which a response sums, in magnitude, to less than this fraction
/// of the whole are cut off: what they would add to a speed is as small.
/// Rounding in the phase of thousands of radians along the string leaves a
/// floor a few times lower.
const NEGLIGIBLE_TAIL: f64 = 1e-8;

/// A tail counts as decayed only if this last part of what was computed is
/// negligible too, so that a quiet moment is not taken for the end.
const QUIET_PART: f64 = 0.25;

/// A digital filter lasts at least so many time constants of what seeps along the
/// string: its static stiffness is then right to a part in a thousand.
const SEEPING_TIMES: f64 = 8.0;

/// A first guess of the length, in round trips, where damping says nothing.
const FIRST_ROUND_TRIPS: f64 = 16.0;

/// Builds the torsional responses of a string by one method.
///
/// # Errors
/// Where a parameter is out of range, the method cannot treat the string, or
/// the responses would not fit in memory.
pub fn torsion_responses(
    string: &Drillstring,
    method: &Method,
    request: &TorsionRequest,
) -> Result<TorsionResponses, BuildError> {
    check_request(
        string,
        &request.sites,
        request.sampling_frequency,
        request.longest_time,
    )?;
    let sites = request.sites.len();
    if let Some(&site) = request.torque_inputs.iter().find(|&&site| site >= sites) {
        return Err(BuildError::NoSuchSite { site, sites });
    }
    let (channels, ending) = match method {
        Method::Quadrature => quadrature_taps(Formula::BackwardDifferences, string, request)?,
        Method::Trapezoidal => quadrature_taps(Formula::Trapezoidal, string, request)?,
        Method::Hilbert(transform) => {
            needs_damping(method, string)?;
            let samples = transform_samples(string, transform, request);
            let length = transform_length(samples, request.sampling_frequency)?;
            let response = wave_response(string, request)?;
            let taps = hilbert::taps(
                request.sampling_frequency,
                length,
                request.channels(),
                &response,
            );
            (taps, Ending::Whole)
        }
        Method::DirectIdft(transform) => {
            needs_damping(method, string)?;
            let samples = transform_samples(string, transform, request);
            let length = transform_length(samples, request.sampling_frequency)?;
            let response = wave_response(string, request)?;
            let taps = direct::taps(
                request.sampling_frequency,
                length,
                request.channels(),
                &response,
            );
            (taps, Ending::Whole)
        }
        Method::FiniteElement(parameters) => element_taps(string, parameters, request)?,
    };
    all_finite(&channels, method.name())?;
    Ok(TorsionResponses::from_channels(request, channels, ending))
}

fn quadrature_taps(
    formula: Formula,
    string: &Drillstring,
    request: &TorsionRequest,
) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
    let response = wave_response(string, request)?;
    until_decayed(string, request, |length| {
        quadrature::taps(
            formula,
            request.sampling_frequency,
            length,
            request.channels(),
            &response,
        )
    })
}

/// Builds responses of growing length until they have decayed or are as long
/// as the simulation; but never so short that the string has not rung down,
/// for the positive-real margin of a response cut off means nothing.
fn until_decayed(
    string: &Drillstring,
    request: &TorsionRequest,
    mut build: impl FnMut(usize) -> Vec<Vec<f64>>,
) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    let mut length = first_length(string, request)?;
    loop {
        let mut channels = build(length);
        if cut_decayed_tail(&mut channels) {
            return Ok((channels, Ending::Whole));
        }
        if length as f64 >= needed {
            return Ok((channels, Ending::Cut));
        }
        if length == MOST_TAPS {
            return Err(too_many(needed));
        }
        length = (2 * length).min(MOST_TAPS);
    }
}

/// The transform behind a filter is as long as the string's vibration lasts,
/// however short the simulation: what it cuts off is folded back (Section 2.4).
/// The taps have an algebraic tail, so that watching them decay would not tell
/// when to stop.
pub(crate) fn transform_samples(
    string: &Drillstring,
    transform: &Transform,
    request: &TorsionRequest,
) -> f64 {
    let sampling_frequency = request.sampling_frequency;
    let seeps = SEEPING_TIMES * torsional_settling_time(string) * sampling_frequency;
    let first = first_length(string, request).map_or(f64::INFINITY, |taps| taps as f64);
    samples_of(transform, 2.0 * seeps.max(first), sampling_frequency)
}

/// Exact frequency responses of all channels.
fn wave_response<'a>(
    string: &'a Drillstring,
    request: &'a TorsionRequest,
) -> Result<impl Fn(c64, &mut [c64]) + Sync + 'a, BuildError> {
    let network = TorsionNetwork::new(string, &request.sites)?;
    Ok(move |s: c64, channels: &mut [c64]| {
        let admittance = network.admittance(s);
        let sites = request.sites.len();
        channels[..sites].copy_from_slice(&admittance.from_surface);
        let torques = (0..sites).flat_map(|site| {
            let admittance = &admittance.from_torque;
            (request.torque_inputs.iter()).map(move |&input| admittance[(site, input)])
        });
        for (channel, value) in channels[sites..].iter_mut().zip(torques) {
            *channel = value;
        }
    })
}

/// One unit input stepped in time, its effect at the sites written down.
struct UnitRun {
    /// `None`: the surface speed.
    input: Option<usize>,
    state: StringState,
    speeds: Vec<Vec<f64>>,
}

impl UnitRun {
    fn extend(&mut self, string: &CondensedString, length: usize) {
        for step in self.speeds[0].len()..length {
            let unit = if step == 0 { 1.0 } else { 0.0 };
            match self.input {
                None => string.step_free(&mut self.state, unit),
                Some(input) => {
                    string.step_free(&mut self.state, 0.0);
                    if step == 0 {
                        string.apply_torque(&mut self.state, input, unit);
                    }
                }
            }
            for (site, speeds) in self.speeds.iter_mut().enumerate() {
                speeds.push(string.speed(&self.state, site));
            }
        }
    }
}

fn element_taps(
    string: &Drillstring,
    parameters: &FiniteElement,
    request: &TorsionRequest,
) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
    let weights = Weights::new(parameters, request.sampling_frequency)?;
    let condensed = CondensedString::new(
        string,
        &request.sites,
        parameters.elements_per_cell,
        weights,
    )?;
    let sites = request.sites.len();
    let mut runs: Vec<UnitRun> = std::iter::once(None)
        .chain(request.torque_inputs.iter().copied().map(Some))
        .map(|input| UnitRun {
            input,
            state: condensed.rest(),
            speeds: vec![Vec::new(); sites],
        })
        .collect();
    until_decayed(string, request, |length| {
        runs.par_iter_mut()
            .for_each(|run| run.extend(&condensed, length));
        in_channel_order(&runs, sites)
    })
}

fn in_channel_order(runs: &[UnitRun], sites: usize) -> Vec<Vec<f64>> {
    let from_surface = runs[0].speeds.iter().cloned();
    let from_torques = (0..sites).flat_map(|site| {
        runs[1..]
            .iter()
            .map(move |run: &UnitRun| run.speeds[site].clone())
    });
    from_surface.chain(from_torques).collect()
}

/// Cuts all channels where the last of them has decayed. Returns whether they
/// have.
fn cut_decayed_tail(channels: &mut [Vec<f64>]) -> bool {
    let length = channels.iter().map(Vec::len).max().unwrap_or(0);
    let end = channels
        .iter()
        .map(|taps| decayed_length(taps))
        .max()
        .unwrap_or(0);
    let decayed = (end as f64) <= (1.0 - QUIET_PART) * length as f64;
    if decayed {
        for taps in channels {
            taps.truncate(end.max(1));
            taps.shrink_to_fit();
        }
    }
    decayed
}

/// The number of taps before the negligible tail.
fn decayed_length(taps: &[f64]) -> usize {
    let total: f64 = taps.iter().map(|tap| tap.abs()).sum();
    let mut tail = 0.0;
    taps.iter()
        .rposition(|tap| {
            tail += tap.abs();
            tail > NEGLIGIBLE_TAIL * total
        })
        .map_or(0, |last| last + 1)
}

/// A guess of the taps a response lasts, from the decay rate of the whole
/// string; a power of two for the transforms.
///
/// # Errors
/// Where it lasts no finite time.
pub(crate) fn first_length(
    string: &Drillstring,
    request: &TorsionRequest,
) -> Result<usize, BuildError> {
    let decay_time = -NEGLIGIBLE_TAIL.ln() / torsional_decay_rate(string) / (1.0 - QUIET_PART);
    let default_time = FIRST_ROUND_TRIPS * 2.0 * torsional_travel_time(string);
    let time = if decay_time.is_finite() {
        decay_time.max(2.0 * torsional_travel_time(string))
    } else {
        default_time
    };
    let taps = (time * request.sampling_frequency).ceil();
    if !taps.is_finite() {
        return Err(too_many(taps));
    }
    Ok((taps.min(MOST_TAPS as f64) as usize).next_power_of_two())
}

fn needs_damping(method: &Method, string: &Drillstring) -> Result<(), BuildError> {
    if string.torsional_damping() > 0.0 {
        Ok(())
    } else {
        Err(BuildError::NeedsDamping {
            method: method.name(),
        })
    }
}
