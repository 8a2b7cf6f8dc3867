//! How far discrete responses are from the exact ones, on smooth motions: the waves
//! inverted numerically, without any scheme in time.
//!
//! A step has no best discrete answer, for every scheme rounds its corner. The
//! surface and the torques rise along raised cosines instead, and forces act as the
//! unit impulses of a scene do.
//!
//! ```
//! use linear::deviation::{ExactMotions, exact_undershoot};
//! use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 500.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.02)?;
//! assert!(exact_undershoot(&string)? > 0.0);
//! let request = |sampling_frequency: f64| Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency,
//!     longest_time: 10.0,
//! };
//! let error = |method: Method, frequency: f64| -> Result<f64, linear::BuildError> {
//!     let responses = linear::responses(&string, &method, &request(frequency))?;
//!     ExactMotions::in_torsion(&string, &Sites::bit(), frequency)?.error_of(&responses)
//! };
//! // Sampled more finely a method is nearer; one without dispersion is nearer still.
//! let coarse = error(Method::Quadrature, 100.0)?;
//! let errors = [error(Method::Held, 100.0)?, error(Method::Quadrature, 400.0)?, coarse];
//! assert!(errors[0] < 0.5 * coarse && errors[1] < coarse, "{errors:?}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use num_complex::Complex64;

use crate::assembly::lanes::Lanes;
use crate::assembly::working_bytes;
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::Need;
use crate::channel::Channel;
use crate::drillstring::{Drillstring, StringId};
use crate::error::{BuildError, ResponseError};
use crate::estimates::{
    largest_undershoot, torsional_decay_rate, torsional_period, torsional_travel_time,
    torsional_wave_survives_to, undershoot_time,
};
use crate::filters::quadrature::{Sampling, buffers, series};
use crate::pulse::RaisedCosine;
use crate::responses::length::{MOST_TAPS, too_many, transformable};
use crate::responses::{ChannelResponses, Responses};
use crate::sites::Sites;
use crate::waves::inversion::time_responses;
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

/// Δ of Eq. 75 as it is, rad/s per N m: the largest undershoot of the bit's speed after a
/// unit step of torque there, by waves on a lattice, whose fronts are sharp. Filters and
/// elements let fronts overshoot, however short their steps, or smear them. It is looked for
/// within [`undershoot_time`], and up to twenty periods where only damping takes anything and so little that the
/// bit may swing back further later.
///
/// # Errors
/// Where the lattice of so strongly damped a string would not fit in memory.
pub fn exact_undershoot(string: &Drillstring) -> Result<f64, BuildError> {
    exact_undershoot_within(string, watched_time(string))
}

/// Δ of Eq. 75 as it is, rad/s per N m, within a time after the step of torque, s.
///
/// # Errors
/// Where the lattice of so strongly damped a string would not fit in memory.
pub fn exact_undershoot_within(string: &Drillstring, time: f64) -> Result<f64, BuildError> {
    let lattice = smearing_lattice(string, time)?;
    Ok(largest_undershoot(&train(&lattice, time)?))
}

/// Memory that [`exact_undershoot`] takes; none where it is refused.
pub fn undershoot_need(string: &Drillstring) -> Need {
    undershoot_need_within(string, watched_time(string))
}

/// Memory that [`exact_undershoot_within`] takes; none where it is refused.
pub fn undershoot_need_within(string: &Drillstring, time: f64) -> Need {
    smearing_lattice(string, time).map_or(Need::default(), |lattice| need(&lattice, time))
}

/// The time in which the bit swings back furthest, s, or twenty periods if only constants take anything, and
/// little.
fn watched_time(string: &Drillstring) -> f64 {
    let time = undershoot_time(string);
    if string.loss().has_memory() {
        return time;
    }
    let most = MOST_PERIODS * torsional_period(string);
    time.max((LITTLE_DECAY / torsional_decay_rate(string)).min(most))
}

/// The part of an exponent that decay takes within the time in which a string of little damping is watched.
const LITTLE_DECAY: f64 = 0.25;

/// Periods of the slowest vibration in which it is watched at most.
const MOST_PERIODS: f64 = 20.0;

/// Pieces of a lattice in the time over which loss that grows with frequency smears a front in a round trip;
/// in 32 Δ of pipes of 2 km with loss factors of 0.0005 to 0.005 is up to 0.8 % off, in 64 to 1e-5.
const PIECES_PER_FRONT: f64 = 64.0;

/// The most pieces, of all tubes, that are evaluated for it: some seconds.
const MOST_EVALUATED: f64 = 4e6;

/// A lattice fine enough for what loss makes of fronts, as long as its pieces through a time (s) are not too
/// many.
fn smearing_lattice(string: &Drillstring, time: f64) -> Result<Lattice, BuildError> {
    let longest_piece = match string.loss().has_memory() {
        true => {
            let affordable = time * string.tubes().count() as f64 / MOST_EVALUATED;
            affordable.max(front_time(string) / PIECES_PER_FRONT)
        }
        false => f64::INFINITY,
    };
    Ok(Lattice::of_pieces(string, &Sites::bit(), longest_piece)?)
}

/// The time over which loss that grows with frequency smears a front in a round trip, s.
fn front_time(string: &Drillstring) -> f64 {
    let left_one_way = (-0.5_f64).exp();
    1.0 / (std::f64::consts::TAU * torsional_wave_survives_to(string, left_one_way))
}

/// Speeds of the bit after a unit impulse of torque there, one after each travel time of a piece
/// of the lattice, until the largest undershoot is behind; and that time, s.
pub(crate) fn train_at_bit(string: &Drillstring) -> Result<(f64, Vec<f64>), BuildError> {
    let lattice = Lattice::new(string, &Sites::bit())?;
    let train = train(&lattice, undershoot_time(string))?;
    Ok((lattice.step, train))
}

/// Memory that [`train_at_bit`] takes; none where it is refused.
pub(crate) fn train_need(string: &Drillstring) -> Need {
    let lattice = Lattice::new(string, &Sites::bit());
    lattice.map_or(Need::default(), |it| need(&it, undershoot_time(string)))
}

/// Speeds of the bit after a unit impulse of torque there through a time, s.
fn train(lattice: &Lattice, time: f64) -> Result<Vec<f64>, BuildError> {
    let impulses = impulses(lattice, time)?;
    let mut trains = series(
        transformable(impulses),
        1,
        Sampling::Wide,
        &|zeta: Lanes, response: &mut [Lanes]| {
            response[0] = lattice.admittance(zeta).from_torque[(0, 0)];
        },
    );
    let mut train = trains.swap_remove(0);
    train.truncate(impulses);
    Ok(train)
}

fn need(lattice: &Lattice, time: f64) -> Need {
    impulses(lattice, time).map_or(Need::default(), |impulses| {
        let buffers = buffers(transformable(impulses), 1, Sampling::Wide);
        Need::passing(buffers.need(working_bytes::<Lanes>(1, 1)).peak)
    })
}

/// Impulses on a lattice through a time, s.
fn impulses(lattice: &Lattice, time: f64) -> Result<usize, BuildError> {
    let impulses = (time / lattice.step).ceil();
    if impulses > MOST_TAPS as f64 {
        return Err(too_many(impulses));
    }
    Ok(impulses as usize)
}

/// How the sites of a string truly move, in one channel, at times that the responses at one
/// sampling frequency tell of.
#[derive(Debug, Clone)]
pub struct ExactMotions {
    string: StringId,
    sites: Sites,
    channel: Channel,
    times: Times,
    /// What comes in, at every sample.
    input: Vec<f64>,
    /// Speeds of every site, from the surface; none in bending.
    from_surface: Vec<Vec<f64>>,
    /// Speeds, or displacements in bending, of every site from a load at every one, row by
    /// row.
    from_loads: Vec<Vec<f64>>,
}

impl ExactMotions {
    /// In torsion, speeds: the speed of the surface and torques rise along a raised cosine.
    ///
    /// # Errors
    /// Where the sites are not places of this string.
    pub fn in_torsion(
        string: &Drillstring,
        sites: &Sites,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        Self::of_waves(
            (string, string.id()),
            sites,
            sampling_frequency,
            Channel::Torsion,
        )
    }

    /// Along the axis the same, of a string as a rod that stretches ([`crate::Axial::rod`]).
    ///
    /// # Errors
    /// Where the sites are not places of this string.
    pub fn along_axis(
        string: &Drillstring,
        rod: &Drillstring,
        sites: &Sites,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        Self::of_waves(
            (rod, string.id()),
            sites,
            sampling_frequency,
            Channel::Axial,
        )
    }

    /// Speeds of a string that obeys the equation of waves, known by its name.
    fn of_waves(
        (string, name): (&Drillstring, StringId),
        sites: &Sites,
        sampling_frequency: f64,
        channel: Channel,
    ) -> Result<Self, BuildError> {
        let travel = torsional_travel_time(string);
        let times = Times::new(TRAVELS * travel, sampling_frequency);
        let duration = (RISE * travel).max(3.0 * times.step);
        let (rise, count) = (RaisedCosine { duration }, sites.len());
        let network = TorsionNetwork::new(string, sites)?;
        let mut motions = times.exact(count * (1 + count), |s, motions| {
            let (admittance, input) = (network.admittance(s), rise.transform(s) / s);
            for (motion, speed) in motions.iter_mut().zip(&admittance.from_surface) {
                *motion = speed * input;
            }
            for (index, motion) in motions[count..].iter_mut().enumerate() {
                *motion = admittance.from_torque[(index / count, index % count)] * input;
            }
        });
        let from_loads = motions.split_off(count);
        Ok(Self {
            string: name,
            sites: sites.clone(),
            channel,
            input: times.samples(|time| rise.integral(time)),
            times,
            from_surface: motions,
            from_loads,
        })
    }

    /// In bending, displacements after a unit impulse of a given duration (s).
    ///
    /// # Errors
    /// Where the sites are not places of this string, or there is no such duration.
    pub fn in_bending(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
        sites: &Sites,
        duration: f64,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        if !(duration.is_finite() && duration > 0.0) {
            return Err(BuildError::Parameter {
                name: "duration",
                value: duration,
                expected: "a positive number of seconds",
            });
        }
        let times = Times::new(DURATIONS * duration, sampling_frequency);
        let (pulse, count) = (RaisedCosine { duration }, sites.len());
        let network = BendingNetwork::new(string, *bending, support, sites)?;
        let from_loads = times.exact(count * count, |s, motions| {
            let (receptance, input) = (network.receptance(s), pulse.transform(s));
            for (index, motion) in motions.iter_mut().enumerate() {
                *motion = receptance[(index / count, index % count)] * input;
            }
        });
        Ok(Self {
            string: string.id(),
            sites: sites.clone(),
            channel: Channel::Bending,
            input: times.samples(|time| pulse.at(time)),
            times,
            from_surface: Vec::new(),
            from_loads,
        })
    }

    /// Largest error of the motions that responses make of the same, relative to the largest
    /// exact one, at each site from each. Taps that are missing count as zero: where one step
    /// is longer than a 128th of the times compared, responses have to last 128 steps.
    ///
    /// # Errors
    /// Where the responses are not those of this string and these sites, sampled so.
    pub fn error_of(&self, responses: &Responses) -> Result<f64, BuildError> {
        let found = self.channel_of(responses)?;
        let from_surface = (found.from_surface.iter().zip(&self.from_surface))
            .map(|(taps, exact)| self.times.error(taps, &self.input, exact));
        let from_loads = (0..self.sites.len()).flat_map(|site| {
            (found.loads.iter().zip(&found.from_loads[site])).map(move |(load, taps)| {
                let exact = &self.from_loads[site * self.sites.len() + load];
                self.times.error(taps, &self.input, exact)
            })
        });
        Ok(from_surface.chain(from_loads).fold(0.0, f64::max))
    }

    /// The responses in its channel, if they are those of this string.
    fn channel_of<'a>(
        &self,
        responses: &'a Responses,
    ) -> Result<&'a ChannelResponses, ResponseError> {
        responses.check()?;
        if responses.string != self.string {
            return Err(ResponseError::OtherString);
        }
        if responses.sites != self.sites
            || responses.sampling_frequency != self.times.sampling_frequency
        {
            return Err(ResponseError::OtherSites);
        }
        let channel = self.channel;
        (responses.channel(channel)).ok_or(ResponseError::NoChannel { channel })
    }
}

/// Times at which motions are compared: samples of the taps, evenly spread.
#[derive(Debug, Clone)]
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

    /// A number of motions whose transforms are found together.
    fn exact(
        &self,
        motions: usize,
        transforms: impl Fn(Complex64, &mut [Complex64]) + Sync,
    ) -> Vec<Vec<f64>> {
        time_responses(transforms, motions, self.step, TIMES, OVERSAMPLING)
    }

    /// A function of time at every sample.
    fn samples(&self, function: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..TIMES * self.stride)
            .map(|index| function(index as f64 / self.sampling_frequency))
            .collect()
    }

    /// Largest difference of what the taps make of an input from the exact answer.
    fn error(&self, taps: &[f64], input: &[f64], exact: &[f64]) -> f64 {
        let scale = exact
            .iter()
            .fold(0.0f64, |most, value| most.max(value.abs()));
        let differences = exact.iter().enumerate().map(|(index, exact)| {
            let now = index * self.stride;
            let sum: f64 = (taps.iter().take(now + 1).enumerate())
                .map(|(lag, tap)| tap * input[now - lag])
                .sum();
            (sum - exact).abs()
        });
        differences.fold(0.0, f64::max) / scale
    }
}
