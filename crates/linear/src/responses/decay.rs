//! When torsional responses have decayed, and what is then cut off.

use super::length::{MOST_TAPS, too_many, transformable};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::estimates::{drive_settling_time, torsional_decay_rate, torsional_travel_time};

/// A response has decayed where what is left of it sums, in magnitude, to less than this
/// fraction of the whole. Rounding in the phase of thousands of radians along the string
/// leaves a floor a few times lower.
pub(super) const NEGLIGIBLE_TAIL: f64 = 1e-8;

/// What is cut off then, unless rounding holds a response up: taps that sum to less than this
/// fraction of the whole. A speed sees what is cut off thousands of times over, once for each
/// sample of the load's past.
const CUT_TAIL: f64 = 1e-10;

/// A response that decays exponentially takes a quarter longer until this. Beyond this multiple
/// only rounding or seepage remains, and it is cut here.
const LONGER: f64 = 1.3;

/// A tail counts as decayed only if this last part of what was computed is
/// negligible too, so that a quiet moment is not taken for the end.
const QUIET_PART: f64 = 0.25;

/// A first guess of the length, in round trips, where damping says nothing.
const FIRST_ROUND_TRIPS: f64 = 16.0;

/// The slowest vibration takes about this many times as long to decay as the mean of all.
const SLOWEST: f64 = 1.25;

/// The part of its sum that the last part of a response has, of the one in which that is most.
pub(super) fn left_at_end(responses: &[Vec<f64>]) -> f64 {
    let sum = |taps: &[f64]| taps.iter().map(|tap| tap.abs()).sum::<f64>();
    let parts = responses.iter().map(|taps| {
        let end = ((1.0 - QUIET_PART) * taps.len() as f64) as usize;
        sum(&taps[end..]) / sum(taps)
    });
    parts.fold(0.0, f64::max)
}

/// Cuts what is left of all responses where the last of them has decayed. Returns whether they
/// have; `negligible` is the part of its sum that a tail may have.
pub(super) fn cut_decayed_tail(responses: &mut [Vec<f64>], negligible: f64) -> bool {
    let length = responses.iter().map(Vec::len).max().unwrap_or(0);
    let end = last_end(responses, negligible);
    let decayed = (end as f64) <= (1.0 - QUIET_PART) * length as f64;
    if decayed {
        let end = if negligible > NEGLIGIBLE_TAIL {
            end
        } else {
            let most = (LONGER * end as f64).ceil() as usize;
            last_end(responses, CUT_TAIL).min(most)
        };
        for taps in responses {
            taps.truncate(end.max(1));
            taps.shrink_to_fit();
        }
    }
    decayed
}

/// The number of taps before the negligible tail of the response that lasts longest.
fn last_end(responses: &[Vec<f64>], negligible: f64) -> usize {
    let ends = responses
        .iter()
        .map(|taps| decayed_length(taps, negligible));
    ends.max().unwrap_or(0)
}

/// The number of taps before the negligible tail.
fn decayed_length(taps: &[f64], negligible: f64) -> usize {
    let total: f64 = taps.iter().map(|tap| tap.abs()).sum();
    let mut tail = 0.0;
    taps.iter()
        .rposition(|tap| {
            tail += tap.abs();
            tail > negligible * total
        })
        .map_or(0, |last| last + 1)
}

/// A guess of the taps a response lasts, from the decay rate of the whole
/// string and from what its drive takes.
///
/// # Errors
/// Where it lasts no finite time.
pub(super) fn first_length(
    string: &Drillstring,
    sampling_frequency: f64,
) -> Result<usize, BuildError> {
    let slowest = (SLOWEST / torsional_decay_rate(string)).max(drive_settling_time(string));
    let decay_time = -NEGLIGIBLE_TAIL.ln() * slowest / (1.0 - QUIET_PART);
    let default_time = FIRST_ROUND_TRIPS * 2.0 * torsional_travel_time(string);
    let time = if decay_time.is_finite() {
        decay_time.max(2.0 * torsional_travel_time(string))
    } else {
        default_time
    };
    let taps = (time * sampling_frequency).ceil();
    if !taps.is_finite() {
        return Err(too_many(taps));
    }
    Ok(transformable(taps.min(MOST_TAPS as f64) as usize))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Taps of a response that falls to a part 1e-16 of its first in `length`, with noise of the
    /// given amount.
    fn decaying(length: usize, noise: f64) -> Vec<f64> {
        let fall = |index: usize| 1e-16_f64.powf(index as f64 / length as f64);
        let sign = |index: usize| {
            if index % 2 == 0 { noise } else { -noise }
        };
        (0..length).map(|index| fall(index) + sign(index)).collect()
    }

    fn left_beyond(whole: &[f64], end: usize) -> f64 {
        let sum = |taps: &[f64]| taps.iter().map(|tap| tap.abs()).sum::<f64>();
        sum(&whole[end..]) / sum(whole)
    }

    #[test]
    fn a_decayed_response_keeps_all_but_its_last_ten_thousand_millionth() {
        let whole = decaying(4000, 0.0);
        let mut taps = vec![whole.clone(), whole[..100].to_vec()];
        assert!(cut_decayed_tail(&mut taps, NEGLIGIBLE_TAIL));
        let end = taps[0].len();
        assert!(left_beyond(&whole, end) <= CUT_TAIL);
        // And no tap more.
        assert!(left_beyond(&whole, end - 1) > CUT_TAIL);
        // The shorter one is not lengthened.
        assert_eq!(taps[1], whole[..100]);
    }

    #[test]
    fn rounding_does_not_keep_a_decayed_response() {
        // All of the noise is 4e-9 of the sum.
        let whole = decaying(4000, 1e-10);
        let mut taps = vec![whole.clone()];
        assert!(cut_decayed_tail(&mut taps, NEGLIGIBLE_TAIL));
        let decayed = decayed_length(&whole, NEGLIGIBLE_TAIL);
        assert!(taps[0].len() <= (LONGER * decayed as f64) as usize + 1);
        assert!(left_beyond(&whole, taps[0].len()) < NEGLIGIBLE_TAIL);
    }

    #[test]
    fn what_still_continues_is_not_cut() {
        let whole = decaying(4000, 0.0);
        let mut taps = vec![whole[..2000].to_vec()];
        assert!(!cut_decayed_tail(&mut taps, NEGLIGIBLE_TAIL));
        assert_eq!(taps[0], whole[..2000]);
    }
}
