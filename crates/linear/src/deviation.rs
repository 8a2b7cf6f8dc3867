//! How far discrete responses are from the exact ones, on smooth motions: the waves
//! inverted numerically, without any scheme in time.
//!
//! A step has no best discrete answer, for every scheme rounds its corner. The
//! surface and the torques rise along raised cosines instead, and forces act as the
//! unit impulses of a scene do.

use num_complex::Complex64;

use crate::channel::Channel;
use crate::drillstring::{Bending, Drillstring, SurfaceSupport};
use crate::error::{BuildError, ResponseError};
use crate::estimates::{largest_undershoot, torsional_period, torsional_travel_time};
use crate::filters::quadrature::series;
use crate::pulse::RaisedCosine;
use crate::responses::length::{MOST_TAPS, too_many};
use crate::responses::{ChannelResponses, Responses};
use crate::sites::Sites;
use crate::waves::inversion::time_response;
use crate::waves::lateral::BendingNetwork;
use crate::waves::lattice::Lattice;
use crate::waves::network::TorsionNetwork;

/// Time compared in torsion, in travel times of a wave along the string.
const TRAVELS: f64 = 6.0;

/// Rise time in torsion, in travel times.
const RISE: f64 = 0.25;

/// Time compared in bending, in durations of the impulse.
const DURATIONS: f64 = 40.0;

/// Frequencies of the inversion reach this many times half the rate at which
/// motions are compared.
const OVERSAMPLING: usize = 64;

/// Times compared.
const TIMES: usize = 128;

/// Periods of the slowest vibration in which an undershoot is looked for.
const PERIODS: f64 = 1.5;

/// Δ of Eq. 75 as it is, rad/s per N m: the largest undershoot of the bit's speed after a
/// unit step of torque there, by waves on a lattice, whose fronts are sharp. Filters and
/// elements let fronts overshoot, however short their steps, or smear them. The bit swings
/// back furthest within one and a half periods of its slowest vibration; where damping puts
/// it off, by less than a hundredth of what it moves at once.
///
/// # Errors
/// Where the lattice of so strongly damped a string would not fit in memory.
pub fn exact_undershoot(string: &Drillstring) -> Result<f64, BuildError> {
    let lattice = Lattice::new(string, &Sites::bit())?;
    let impulses = (PERIODS * torsional_period(string) / lattice.step).ceil();
    if impulses > MOST_TAPS as f64 {
        return Err(too_many(impulses));
    }
    let train = series(
        impulses as usize,
        1,
        &|zeta: Complex64, response: &mut [Complex64]| {
            response[0] = lattice.admittance(zeta).from_torque[(0, 0)];
        },
    );
    Ok(largest_undershoot(&train[0]))
}

/// Largest error of speeds in torsion, relative to the largest exact speed: of every
/// site, from the surface and from every torque.
///
/// # Errors
/// Where the responses are not the string's, or not in torsion.
pub fn torsion_error(string: &Drillstring, responses: &Responses) -> Result<f64, BuildError> {
    let torsion = channel_of(string, responses, Channel::Torsion)?;
    let sites = &responses.sites;
    let travel = torsional_travel_time(string);
    let times = Times::new(TRAVELS * travel, responses.sampling_frequency);
    let rise = (RISE * travel).max(3.0 * times.step);
    let network = TorsionNetwork::new(string, sites)?;
    let rise = RaisedCosine { duration: rise };
    let input = |time: f64| rise.integral(time);
    let of_input = |s: Complex64| rise.transform(s) / s;
    let mut worst = 0.0f64;
    for site in 0..sites.len() {
        let exact = times.exact(|s| network.admittance(s).from_surface[site] * of_input(s));
        worst = worst.max(times.error(&torsion.from_surface[site], input, &exact));
        for (index, &torque) in torsion.loads.iter().enumerate() {
            let exact =
                times.exact(|s| network.admittance(s).from_torque[(site, torque)] * of_input(s));
            worst = worst.max(times.error(&torsion.from_loads[site][index], input, &exact));
        }
    }
    Ok(worst)
}

/// Largest error of displacements after a unit impulse of a given duration (s),
/// relative to the largest exact one, at each site from each.
///
/// # Errors
/// Where the responses are not the string's, or not in bending.
pub fn bending_error(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    duration: f64,
    responses: &Responses,
) -> Result<f64, BuildError> {
    let found = channel_of(string, responses, Channel::Bending)?;
    let sites = &responses.sites;
    if !(duration.is_finite() && duration > 0.0) {
        return Err(BuildError::Parameter {
            name: "duration",
            value: duration,
            expected: "a positive number of seconds",
        });
    }
    let times = Times::new(DURATIONS * duration, responses.sampling_frequency);
    let network = BendingNetwork::new(string, *bending, support, sites)?;
    let pulse = RaisedCosine { duration };
    let input = |time: f64| pulse.at(time);
    let pairs = (0..sites.len()).flat_map(|site| (0..sites.len()).map(move |input| (site, input)));
    let errors = pairs
        .map(|(site, force)| {
            let exact = times.exact(|s| network.receptance(s)[(site, force)] * pulse.transform(s));
            times.error(&found.from_loads[site][force], input, &exact)
        })
        .fold(0.0, f64::max);
    Ok(errors)
}

/// The responses of a channel, if they are those of this string.
fn channel_of<'a>(
    string: &Drillstring,
    responses: &'a Responses,
    channel: Channel,
) -> Result<&'a ChannelResponses, ResponseError> {
    responses.check()?;
    if responses.string != string.id() {
        return Err(ResponseError::OtherString);
    }
    (responses.channel(channel)).ok_or(ResponseError::NoChannel { channel })
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

    fn exact(&self, transform: impl Fn(Complex64) -> Complex64 + Sync) -> Vec<f64> {
        time_response(transform, self.step, TIMES, OVERSAMPLING)
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
