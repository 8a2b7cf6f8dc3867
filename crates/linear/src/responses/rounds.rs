//! Torsional responses as long as they last: built longer and longer until they have decayed, or
//! to the end of the simulation.

use super::decay::{NEGLIGIBLE_TAIL, cut_decayed_tail, first_length, left_at_end};
use super::length::{MOST_TAPS, needed_taps, too_many, transformable};
use super::request::Request;
use crate::budget::{Budget, Need, REAL, Reserved, What};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::estimates::undershoot_time;
use crate::filters::Buffers;
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

/// Of a response that has lasted as long as its slowest motion may, rounding leaves this part of its
/// sum at most. A response in which more is left is one that is much smaller than what passes it
/// by, and is built for longer.
const MOST_OF_ROUNDING: f64 = 1e-6;

/// Time constants of the slowest motion until a response counts as decayed, and has been quiet for a
/// quarter of its length: 21.7 for two motions of one rate, (1 + x) e^(−x) = 1e-8, as at critical
/// damping and at the highest frequencies of Newmark's scheme. A single motion takes 18.4; random
/// strings 19.9 at most (`val_no_response_outlasts_its_plan`).
const DECAYED: f64 = 21.7 / 0.75;

/// How long responses are built, in taps, from round to round.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounds {
    /// The length beyond which they are not used.
    used: f64,
    /// Taps by which they have decayed, for any shape.
    lasts: f64,
    first: Round,
    /// How responses that continue beyond it are sampled.
    continuing: Sampling,
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
    /// sampled in a given way where they continue. Each of their motions loses at least `loss` in a
    /// step ([`super::slowest`]); `None` where some never decay.
    ///
    /// # Errors
    /// Where they last longer than responses may be.
    pub(super) fn new(
        string: &Drillstring,
        request: &Request,
        (continuing, loss): (Sampling, Option<f64>),
        (channels, on_thread): (usize, f64),
    ) -> Result<Self, BuildError> {
        let frequency = request.sampling_frequency;
        let used = used_taps(string, request.longest_time, frequency);
        let decayed = first_length(string, frequency)? as f64;
        // What nothing damps does not decay.
        let decays = string.loss().damps_torsion() && decayed <= WORTH_WHILE * used;
        let first = if decays { decayed } else { used };
        let doubled_to = |length: f64| {
            let doublings = (length / first).log2().ceil().max(0.0);
            first * doublings.exp2()
        };
        let last = doubled_to(used).min(used.max(MOST_TAPS as f64));
        let lasts = match loss {
            Some(loss) if loss > 0.0 => DECAYED / loss,
            _ => f64::INFINITY,
        };
        let longest = match loss {
            None => last,
            Some(_) => doubled_to(lasts).min(last).min(MOST_TAPS as f64),
        };
        if first.max(longest) > MOST_TAPS as f64 {
            return Err(too_many(used.max(longest)));
        }
        let round = |taps: f64, is_whole: bool| Round {
            taps: taps as usize,
            sampling: if is_whole { Sampling::Once } else { continuing },
        };
        Ok(Self {
            used,
            lasts,
            first: round(first, decays),
            continuing,
            longest: round(longest, decays && lasts <= longest),
            channels,
            on_thread,
        })
    }

    /// Rounds of as many responses side by side as take no more than a number of bytes together; of one, at
    /// least.
    pub(super) fn within(self, bytes: f64) -> Self {
        let most = (bytes / self.together() * self.channels as f64) as usize;
        Self {
            channels: most.clamp(1, self.channels),
            ..self
        }
    }

    /// Bytes of the longest round, as it is sampled and kept: what it takes on any number of threads.
    pub(super) fn together(&self) -> f64 {
        self.buffers(self.longest).together()
    }

    /// Taps of each response, at most.
    pub(super) fn taps(&self) -> usize {
        self.longest.taps
    }

    /// Responses that are built side by side.
    pub(super) fn channels(&self) -> usize {
        self.channels
    }

    /// What the longest round takes.
    pub(super) fn need(&self) -> Need {
        self.need_of(self.longest)
    }

    fn need_of(&self, round: Round) -> Need {
        self.buffers(round).need(self.on_thread)
    }

    fn buffers(&self, round: Round) -> Buffers {
        quadrature::buffers(round.taps, self.channels, round.sampling)
    }

    /// Builds responses of growing length until they have decayed or are at least as long as they
    /// are used; those that then continue are sampled as they ask for.
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
            if round.taps as f64 >= self.lasts {
                rounding = MOST_OF_ROUNDING;
            }
            let negligible = NEGLIGIBLE_TAIL.max(left.min(rounding));
            let has_decayed = cut_decayed_tail(&mut taps, negligible);
            let is_enough = round.taps as f64 >= self.used;
            if has_decayed || (is_enough && round.sampling == self.continuing) {
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
                // A response that continues after all was folded back.
                round.sampling = self.continuing;
                continue;
            }
            if round.taps == MOST_TAPS {
                return Err(too_many(self.used));
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

/// Taps beyond which no response is used: neither by a simulation, which may take this long (s),
/// nor for its undershoot.
fn used_taps(string: &Drillstring, longest_time: f64, sampling_frequency: f64) -> f64 {
    let time = longest_time.max(undershoot_time(string));
    let taps = needed_taps(time, sampling_frequency);
    if taps > MOST_TAPS as f64 {
        return taps;
    }
    transformable(taps as usize) as f64
}
