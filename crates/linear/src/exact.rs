//! How far discrete responses are from the exact ones, on smooth motions: the waves
//! inverted numerically, without any scheme in time.
//!
//! A step has no best discrete answer, for every scheme rounds its corner. The
//! surface and the torques rise along raised cosines instead, and forces act as the
//! unit impulses of a scene do.

use std::f64::consts::TAU;

use faer::c64;

use crate::drillstring::{Bending, Drillstring, Sites, SurfaceSupport};
use crate::estimates::torsional_travel_time;
use crate::response::{BendingResponses, TorsionResponses};
use crate::waves::inversion::time_response;
use crate::waves::lateral::BendingNetwork;
use crate::waves::network::TorsionNetwork;

/// Time compared in torsion, in travel times of a wave along the string.
const TRAVELS: f64 = 6.0;

/// Rise time in torsion, in travel times.
const RISE: f64 = 0.25;

/// Time compared in bending, in durations of the impulse.
const DURATIONS: f64 = 40.0;

/// The numerical inversion goes on for so many times what is compared, for it is the
/// worse the later.
const MARGIN: usize = 2;

/// Frequencies of the inversion reach this many times half the rate at which
/// motions are compared.
const OVERSAMPLING: usize = 64;

/// Times compared.
const TIMES: usize = 128;

/// Largest error of speeds in torsion, relative to the largest exact speed: of every
/// site, from the surface and from every torque.
pub fn torsion_error(string: &Drillstring, sites: &Sites, responses: &TorsionResponses) -> f64 {
    let travel = torsional_travel_time(string);
    let times = Times::new(TRAVELS * travel, responses.sampling_frequency);
    let rise = (RISE * travel).max(3.0 * times.step);
    let network = TorsionNetwork::new(string, sites);
    let input = |time: f64| {
        let phase = (time / rise).clamp(0.0, 1.0);
        phase - (TAU * phase).sin() / TAU
    };
    let of_input = |s: c64| pulse_transform(s, rise) / s;
    let mut worst = 0.0f64;
    for site in 0..sites.len() {
        let exact = times.exact(|s| network.admittance(s).from_surface[site] * of_input(s));
        worst = worst.max(times.error(&responses.from_surface[site], input, &exact));
        for (index, &torque) in responses.torque_inputs.iter().enumerate() {
            let exact =
                times.exact(|s| network.admittance(s).from_torque[(site, torque)] * of_input(s));
            worst = worst.max(times.error(&responses.from_torque[site][index], input, &exact));
        }
    }
    worst
}

/// Largest error of displacements after a unit impulse of a given duration (s),
/// relative to the largest exact one, at each site from each.
pub fn bending_error(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    sites: &Sites,
    duration: f64,
    responses: &BendingResponses,
) -> f64 {
    let times = Times::new(DURATIONS * duration, responses.sampling_frequency);
    let network = BendingNetwork::new(string, *bending, support, sites);
    let input = |time: f64| {
        let inside = (0.0..duration).contains(&time);
        f64::from(inside) * (1.0 - (TAU * time / duration).cos()) / duration
    };
    let pairs = (0..sites.len()).flat_map(|site| (0..sites.len()).map(move |input| (site, input)));
    pairs
        .map(|(site, force)| {
            let exact = times
                .exact(|s| network.receptance(s)[(site, force)] * pulse_transform(s, duration));
            times.error(&responses.from_force[site][force], input, &exact)
        })
        .fold(0.0, f64::max)
}

/// Laplace transform of the raised cosine (1 − cos 2πt/τ)/τ of unit area.
fn pulse_transform(s: c64, duration: f64) -> c64 {
    let rate = TAU / duration;
    (1.0 - (-s * duration).exp()) / duration * rate * rate / (s * (s * s + rate * rate))
}

/// Times at which motions are compared: samples of the taps, evenly spread.
struct Times {
    /// From time to time, s.
    step: f64,
    /// The same in samples.
    stride: usize,
    sampling_frequency: f64,
}

impl Times {
    fn new(span: f64, sampling_frequency: f64) -> Self {
        let samples = span * sampling_frequency;
        let stride = (samples / TIMES as f64).floor().max(1.0) as usize;
        Self {
            step: stride as f64 / sampling_frequency,
            stride,
            sampling_frequency,
        }
    }

    fn exact(&self, transform: impl Fn(c64) -> c64 + Sync) -> Vec<f64> {
        let mut values = time_response(transform, self.step, MARGIN * TIMES, OVERSAMPLING);
        values.truncate(TIMES);
        values
    }

    /// Largest difference of what the taps make of an input from the exact answer.
    fn error(&self, taps: &[f64], input: impl Fn(f64) -> f64, exact: &[f64]) -> f64 {
        let inputs: Vec<f64> = (0..TIMES * self.stride)
            .map(|index| input(index as f64 / self.sampling_frequency))
            .collect();
        let scale = exact
            .iter()
            .fold(0.0f64, |most, value| most.max(value.abs()));
        let differences = exact.iter().enumerate().map(|(index, exact)| {
            let now = index * self.stride;
            let sum: f64 = (taps.iter().take(now + 1).enumerate())
                .map(|(lag, tap)| tap * inputs[now - lag])
                .sum();
            (sum - exact).abs()
        });
        differences.fold(0.0, f64::max) / scale
    }
}
