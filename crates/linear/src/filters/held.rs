//! Responses to what is held over a step, as means over a step.
//!
//! A torque or force constant over each step does the work Σ F(n) Δt · v̄(n) with v̄ the
//! mean speed over the step. With g the speed after an impulse and R = ∬ g, the taps
//! from the one to the other are
//!
//! A(0) = R(Δt)/Δt, A(n) = [R((n + 1)Δt) − 2 R(nΔt) + R((n − 1)Δt)]/Δt,
//!
//! so that Σ F(n) (A ∗ F)(n) is the exact work, which no passive string gives back: they
//! are positive-real at any sampling frequency. (A response sampled at points in time is
//! not.) Where g is a train of impulses, R is piecewise straight, and each impulse is
//! shared between the two steps that it lies between.

use super::quadrature::{self, Sampling, series_made};
use super::{Buffers, ResponseAt, radau};
use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::passivity::Ending;

/// Steps of Radau IIA in one step of the taps.
pub(crate) const SUBSTEPS: usize = 4;

/// Of responses that continue: they are sampled at many times as many frequencies as those of other
/// methods.
pub(crate) const SAMPLING: Sampling = Sampling::Wide;

/// Buffers for a number of taps, each made of a train of impulses in shorter steps.
pub(crate) fn smooth_buffers(count: usize, channels: usize) -> Buffers {
    Buffers {
        taps: count,
        ..quadrature::buffers(fine(count), channels, SAMPLING)
    }
}

/// Shorter steps for a number of taps.
fn fine(count: usize) -> usize {
    SUBSTEPS * count + 1
}

/// The first `count` taps of every channel whose response at s (rad/s) has no fronts, by
/// convolution quadrature with Radau IIA in shorter steps: passive as that is.
pub(crate) fn smooth_taps(
    sampling_frequency: f64,
    count: usize,
    channels: usize,
    response: &ResponseAt<'_>,
) -> Vec<Vec<f64>> {
    let rate = SUBSTEPS as f64 * sampling_frequency;
    let spacing = (SUBSTEPS as f64).recip();
    series_made(
        fine(count),
        channels,
        SAMPLING,
        &|zeta: Lanes, values: &mut [Lanes]| {
            let [(one, weight), (other, other_weight)] = radau::held(zeta);
            let mut others = vec![Lanes::real(0.0); values.len()];
            response(one * rate, values);
            response(other * rate, &mut others);
            for (value, other) in values.iter_mut().zip(others) {
                *value = weight * *value + other_weight * other;
            }
        },
        &|train| shared(&train, spacing, count),
    )
}

/// Taps among which a train of impulses is shared, one every `spacing` steps.
pub(crate) fn most_taps_of(impulses: usize, spacing: f64) -> usize {
    (impulses as f64 * spacing).ceil() as usize
}

/// Taps that have their whole share of a train of impulses, one every `spacing` steps: where the train
/// continues beyond its last one, a tap that would get a part of the next is not that of a passive
/// string.
pub(crate) fn taps_of(impulses: usize, spacing: f64, ending: Ending) -> usize {
    match ending {
        Ending::Whole => most_taps_of(impulses, spacing),
        Ending::Cut | Ending::Ringing => (impulses as f64 * spacing) as usize,
    }
}

/// The first `count` taps of a response that is a train of impulses, one every `spacing`
/// steps, the first at time zero.
pub(crate) fn shared(train: &[f64], spacing: f64, count: usize) -> Vec<f64> {
    let mut taps = vec![0.0; count + 1];
    for (index, impulse) in train.iter().enumerate() {
        let place = index as f64 * spacing;
        let step = place as usize;
        if step >= count {
            break;
        }
        let part = place - step as f64;
        taps[step] += (1.0 - part) * impulse;
        taps[step + 1] += part * impulse;
    }
    taps.truncate(count);
    taps
}
