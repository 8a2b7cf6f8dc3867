//! Torsional responses as long as they last: built longer and longer until they have decayed, or
//! to the end of the simulation.

use super::decay::{NEGLIGIBLE_TAIL, cut_decayed_tail, first_length, left_at_end};
use super::length::{MOST_TAPS, needed_taps, too_many, transformable};
use super::request::Request;
use crate::budget::{Budget, Need, REAL, Reserved, What};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::estimates::{
    torsional_decay_rate, torsional_inertia, torsional_settling_time, undershoot_time,
};
use crate::filters::quadrature::{self, Sampling};
use crate::passivity::Ending;

/// What rounding leaves of a tap, at most, as a part of the sum of all: a response that has to
/// be built longer than it should last may be held up by that alone.
const ROUNDING: f64 = 1e-12;

/// What is left at the end of such a response is then rounding, and so is as much again before.
const OF_ROUNDING: f64 = 2.0;

/// Responses are built as long as they should last, though nothing looks so far, where that
/// is no more than this many times as long: the margin of a whole response needs no allowance for
/// its end.
const WORTH_WHILE: f64 = 2.2;

/// Time constants until a response counts as decayed, and has been quiet for a quarter of its
/// length: 18, and three more where two motions of one rate meet, t e^(−t), as at critical damping.
const DECAYED: f64 = 29.0;

/// How long responses are built, in taps, from round to round.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounds {
    /// Where they are looked at no further.
    looked_at: f64,
    first: Round,
    /// What goes on at its end is sampled in this way.
    goes_on: Sampling,
    /// The longest that they may become.
    longest: Round,
    /// Responses that are built side by side.
    channels: usize,
    /// Bytes on each thread while they are sampled.
    on_thread: f64,
}

/// A number of taps of each response, and how closely they are sampled.
#[derive(Debug, Clone, Copy)]
struct Round {
    taps: usize,
    sampling: Sampling,
}

/// Responses, how they end, and the memory that they are.
pub(super) struct Built<'a> {
    pub(super) taps: Vec<Vec<f64>>,
    pub(super) ending: Ending,
    pub(super) memory: Reserved<'a>,
}

impl Rounds {
    /// Of a number of responses, each of which asks for a number of bytes on a thread, that are
    /// sampled in a way where they go on. Some `ring` for ever, however a string is damped.
    ///
    /// # Errors
    /// Where they last longer than responses may be.
    pub(super) fn new(
        string: &Drillstring,
        request: &Request,
        (goes_on, ring): (Sampling, bool),
        (channels, on_thread): (usize, f64),
    ) -> Result<Self, BuildError> {
        let frequency = request.sampling_frequency;
        let looked_at = looked_at(string, request.longest_time, frequency);
        let decayed = first_length(string, frequency)? as f64;
        // What nothing damps does not decay.
        let decays = string.loss().damps_torsion() && decayed <= WORTH_WHILE * looked_at;
        let first = if decays { decayed } else { looked_at };
        let doubled_to = |length: f64| {
            let doublings = (length / first).log2().ceil().max(0.0);
            first * doublings.exp2()
        };
        let last = doubled_to(looked_at).min(looked_at.max(MOST_TAPS as f64));
        let (longest, is_whole) = if !string.loss().damps_torsion() || ring {
            (last, false)
        } else {
            let lasts = DECAYED * frequency / slowest_rate(string);
            let most = last.min(MOST_TAPS as f64);
            (doubled_to(lasts).min(most), decays && lasts <= most)
        };
        if first.max(longest) > MOST_TAPS as f64 {
            return Err(too_many(looked_at.max(longest)));
        }
        let round = |taps: f64, is_whole: bool| Round {
            taps: taps as usize,
            sampling: if is_whole { Sampling::Once } else { goes_on },
        };
        Ok(Self {
            looked_at,
            first: round(first, decays),
            goes_on,
            longest: round(longest, is_whole),
            channels,
            on_thread,
        })
    }

    /// Taps of each response, at most.
    pub(super) fn taps(&self) -> usize {
        self.longest.taps
    }

    /// What the longest round takes.
    pub(super) fn need(&self) -> Need {
        self.need_of(self.longest)
    }

    fn need_of(&self, round: Round) -> Need {
        quadrature::buffers(round.taps, self.channels, round.sampling).need(self.on_thread)
    }

    /// Builds responses of growing length until they have decayed or are at least as long as
    /// they are looked at; those that go on then are sampled as they ask for.
    ///
    /// # Errors
    /// Where a round asks for more memory than is left, or they last longer than they may.
    pub(super) fn build<'a>(
        &self,
        budget: &'a Budget,
        mut build: impl FnMut(usize, Sampling) -> Vec<Vec<f64>>,
    ) -> Result<Built<'a>, BuildError> {
        let mut round = self.first;
        let mut rounding = 0.0;
        loop {
            let working = budget.begin(self.need_of(round), What::Responses)?;
            let mut taps = build(round.taps, round.sampling);
            let left = OF_ROUNDING * left_at_end(&taps);
            let negligible = NEGLIGIBLE_TAIL.max(left.min(rounding));
            let has_decayed = cut_decayed_tail(&mut taps, negligible);
            let is_enough = round.taps as f64 >= self.looked_at;
            if has_decayed || (is_enough && round.sampling == self.goes_on) {
                return Ok(Built {
                    ending: if has_decayed {
                        Ending::Whole
                    } else {
                        Ending::Cut
                    },
                    memory: working.kept(bytes_of(&taps)),
                    taps,
                });
            }
            if is_enough {
                // What goes on after all was folded back.
                round.sampling = self.goes_on;
                continue;
            }
            if round.taps == MOST_TAPS {
                return Err(too_many(self.looked_at));
            }
            round.taps = (2 * round.taps).min(MOST_TAPS);
            rounding = ROUNDING * round.taps as f64;
        }
    }
}

/// Bytes of responses.
pub(super) fn bytes_of(responses: &[Vec<f64>]) -> f64 {
    REAL * responses.iter().map(Vec::len).sum::<usize>() as f64
}

/// Taps beyond which no response is looked at: neither by a simulation, which may take so
/// long (s), nor for its undershoot.
fn looked_at(string: &Drillstring, longest_time: f64, sampling_frequency: f64) -> f64 {
    let time = longest_time.max(undershoot_time(string));
    let taps = needed_taps(time, sampling_frequency);
    if taps > MOST_TAPS as f64 {
        return taps;
    }
    transformable(taps as usize) as f64
}

/// No motion in torsion dies away more slowly than this, 1/s: vibration loses at least
/// what the damping takes of the heaviest tube, and what seeps has a time of its own.
fn slowest_rate(string: &Drillstring) -> f64 {
    let loss = string.loss();
    let heaviest = string
        .tubes()
        .map(|(_, tube)| tube.polar_moment())
        .fold(0.0, f64::max);
    let damped = if loss.has_memory() {
        // Mud holds back the slowest mode least; where it is not alike everywhere, one may be held
        // back less than the whole string is.
        LEAST_OF_MEAN * torsional_decay_rate(string)
    } else {
        string.torsional_damping() / (2.0 * string.material().density * heaviest)
    };
    // What a top drive holds of the inertia is not damped by the string.
    let inertia = torsional_inertia(string);
    let of_drive = string.top_drive().map_or(0.0, |drive| drive.inertia);
    let vibrates = damped * inertia / (inertia + of_drive);
    let seeps = 1.0 / torsional_settling_time(string);
    vibrates
        .min(seeps)
        .min(loss.slowest_memory(string.hole_radii()))
}

/// How much less than the whole string a mode is damped, at most.
const LEAST_OF_MEAN: f64 = 0.5;
