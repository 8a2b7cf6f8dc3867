//! How the surface turns, and what that makes of the sites.

use linear::budget::REAL;

use crate::convolution::{Convolution, Kernels};
use crate::ranges::{SceneError, not_negative};
use crate::recording::Recording;
use crate::sampling::Sampling;

/// The speed of the surface over time, in parts of that which a scene names; at rest before
/// t = 0.
///
/// ```
/// use sim::{Recording, SurfaceProfile};
///
/// assert_eq!(SurfaceProfile::default(), SurfaceProfile::Rise(0.0));
/// assert_eq!(SurfaceProfile::Rise(5.0).rise(), 5.0);
/// // In parts of the speed of a scene: from rest to all of it, and half of it from then on.
/// let recorded = Recording::new(vec![0.0, 5.0, 20.0, 25.0], vec![0.0, 1.0, 1.0, 0.5])?;
/// assert_eq!(SurfaceProfile::Recorded(recorded).rise(), 0.0);
/// # Ok::<(), sim::RecordingError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SurfaceProfile {
    /// It rises evenly to its speed in this time, s; at once where that is zero.
    Rise(f64),
    /// It was recorded.
    Recorded(Recording),
}

/// A recorded speed is known no finer than some hundredths of a revolution per minute: its
/// acceleration is taken over this time, s.
const ACCELERATED_OVER: f64 = 0.1;

impl Default for SurfaceProfile {
    fn default() -> Self {
        Self::Rise(0.0)
    }
}

impl SurfaceProfile {
    /// Time until it has reached its speed, s; `None` for a recorded speed.
    pub fn rise(&self) -> f64 {
        match self {
            Self::Rise(time) => *time,
            Self::Recorded(_) => 0.0,
        }
    }

    /// Checks that it is a speed over time.
    pub(crate) fn check(&self) -> Result<(), SceneError> {
        match self {
            Self::Rise(time) => not_negative("rise of the surface speed in s", *time),
            // Checked when it was made.
            Self::Recorded(_) => Ok(()),
        }
    }

    /// The speed at a time, s, in parts of that which a scene names.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Rise(rise) if time < *rise => (time / rise).max(0.0),
            Self::Rise(_) => 1.0,
            Self::Recorded(recording) => recording.at(time),
        }
    }

    /// How it grows at a time, 1/s.
    pub(crate) fn acceleration(&self, time: f64) -> f64 {
        let half = 0.5 * ACCELERATED_OVER;
        let [before, after] = [time - half, time + half].map(|time| self.at(time.max(0.0)));
        (after - before) / ACCELERATED_OVER
    }
}

/// Speed of a site in every step per unit of the final speed of the surface.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceResponse {
    /// The response to a step, or to what was recorded; to a rise, its sums before each step.
    values: Vec<f64>,
    /// Where it stays.
    last: f64,
    rise: Option<Rise>,
}

/// An even rise.
#[derive(Debug, Clone, Copy)]
struct Rise {
    /// How long it takes, steps.
    steps: f64,
    /// Where in a step the motion of the surface is taken.
    collocation_offset: f64,
}

impl SurfaceResponse {
    /// Bytes of a response of a number of taps.
    pub(crate) fn bytes(taps: usize) -> f64 {
        REAL * (taps + 1) as f64
    }

    /// From the taps of a site.
    pub(crate) fn new(taps: &[f64], profile: &SurfaceProfile, sampling: Sampling) -> Self {
        let rise = match profile {
            SurfaceProfile::Rise(rise) => *rise,
            SurfaceProfile::Recorded(recording) => {
                return Self::recorded(taps, recording, sampling);
            }
        };
        let mut step_response = running_sums(taps);
        let last = step_response.last().copied().unwrap_or(0.0);
        let steps = rise * sampling.frequency;
        let rise = (steps > 0.0).then_some(Rise {
            steps,
            collocation_offset: sampling.collocation_offset,
        });
        if rise.is_some() {
            step_response = std::iter::once(0.0)
                .chain(running_sums(&step_response))
                .collect();
        }
        Self {
            values: step_response,
            last,
            rise,
        }
    }

    /// To what was recorded, after which the surface turns on as it did at last.
    fn recorded(taps: &[f64], recording: &Recording, sampling: Sampling) -> Self {
        let recorded = (recording.end() * sampling.frequency).ceil() as usize + 1;
        let inputs = (0..recorded + taps.len()).map(|step| recording.at(sampling.time_of(step)));
        let values = convolved_with(taps, &inputs.collect::<Vec<_>>());
        Self {
            last: values.last().copied().unwrap_or(0.0),
            values,
            rise: None,
        }
    }

    /// The speed in a step.
    #[inline]
    pub(crate) fn at(&self, step: usize) -> f64 {
        match self.rise {
            // It does not change after its last.
            None => self.values[step.min(self.values.len() - 1)],
            Some(rise) => {
                let end = step as f64 + rise.collocation_offset;
                (self.sum_to(end) - self.sum_to(end - rise.steps)) / rise.steps
            }
        }
    }

    /// Steps until it no longer changes.
    pub(crate) fn settles(&self) -> usize {
        let rise = self.rise.map_or(0.0, |rise| rise.steps);
        self.values.len() + rise.ceil() as usize
    }

    /// All steps until then.
    fn until_settled(&self) -> impl DoubleEndedIterator<Item = f64> + ExactSizeIterator {
        (0..self.settles()).map(|step| self.at(step))
    }

    /// Steps after which a wave from the surface arrives: the response is a part of its last value.
    pub(crate) fn arrives(&self, part: f64) -> usize {
        let least = part * self.last.abs();
        let mut speeds = self.until_settled();
        speeds.position(|speed| speed.abs() > least).unwrap_or(0)
    }

    /// Steps until it stays within a part of its last value.
    pub(crate) fn is_steady_from(&self, part: f64) -> usize {
        let is_off = |speed: f64| (speed - self.last).abs() > part * self.last.abs();
        let mut speeds = self.until_settled();
        speeds.rposition(is_off).map_or(0, |step| step + 1)
    }

    /// The response to a step, summed up to a time in steps.
    fn sum_to(&self, time: f64) -> f64 {
        if time <= 0.0 {
            return 0.0;
        }
        let whole = time as usize;
        match self.values.get(whole..whole + 2) {
            Some(ends) => ends[0] + (ends[1] - ends[0]) * time.fract(),
            None => {
                let end = self.values.len() - 1;
                self.values[end] + self.last * (time - end as f64)
            }
        }
    }
}

/// Σ A(k − n) E(n) for every input E(k), of one response.
pub(crate) fn convolved(kernels: &Kernels, inputs: &[f64]) -> Vec<f64> {
    let mut convolution = Convolution::new(kernels, 1, inputs.len());
    let sums = inputs.iter().map(|&input| {
        let mut past = [0.0];
        convolution.write_past(&mut past);
        convolution.add(&[input]);
        past[0] + kernels.instant(0, 0) * input
    });
    sums.collect()
}

/// The same of a response that is convolved but once.
pub(crate) fn convolved_with(taps: &[f64], inputs: &[f64]) -> Vec<f64> {
    convolved(&Kernels::of(&[vec![taps]]), inputs)
}

fn running_sums(values: &[f64]) -> Vec<f64> {
    let sums = values.iter().scan(0.0, |sum, value| {
        *sum += value;
        Some(*sum)
    });
    sums.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TAPS: [f64; 5] = [0.1, 0.4, -0.2, 0.5, 0.2];

    /// Against the sum of Eq. 17 over a speed that rises, wherever in a step that is taken.
    #[test]
    fn a_rise_is_answered_as_the_history_sum_does() {
        for (rise, collocation_offset) in [(3.0, 0.0), (4.0, 0.5), (7.0, 0.0), (2.0, 0.5)] {
            let sampling = Sampling::new(2.0, collocation_offset);
            let profile = SurfaceProfile::Rise(0.5 * rise);
            let response = SurfaceResponse::new(&TAPS, &profile, sampling);
            // The mean over a step that the rise ends within is not the speed in its middle.
            let speed = |step: usize| match collocation_offset {
                0.0 => (step as f64 / rise).min(1.0),
                _ => ((step as f64 + 0.5) / rise).min(1.0),
            };
            for step in 0..20 {
                let taps = TAPS.iter().take(step + 1).enumerate();
                let expected: f64 = taps.map(|(lag, tap)| tap * speed(step - lag)).sum();
                let found = response.at(step);
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{rise} {step}: {found} {expected}"
                );
            }
            assert!((response.at(response.settles()) - 1.0).abs() < 1e-12);
        }
    }

    /// A rise is one recording among others, and turns on after its end.
    #[test]
    fn a_recording_is_answered_as_the_history_sum_does() {
        for collocation_offset in [0.0, 0.5] {
            let sampling = Sampling::new(2.0, collocation_offset);
            let recording =
                Recording::new(vec![0.0, 1.0, 4.0, 5.0], vec![0.2, 0.9, -0.3, 0.5]).unwrap();
            let profile = SurfaceProfile::Recorded(recording.clone());
            let response = SurfaceResponse::new(&TAPS, &profile, sampling);
            for step in 0..40 {
                let taps = TAPS.iter().take(step + 1).enumerate();
                let speed = |step: usize| recording.at(sampling.time_of(step));
                let expected: f64 = taps.map(|(lag, tap)| tap * speed(step - lag)).sum();
                assert!((response.at(step) - expected).abs() < 1e-12);
            }
            assert!((response.last - 0.5).abs() < 1e-12);
        }
    }

    #[test]
    fn without_a_rise_it_is_the_response_to_a_step() {
        let response =
            SurfaceResponse::new(&TAPS, &SurfaceProfile::default(), Sampling::new(2.0, 0.5));
        let expected = [0.1, 0.5, 0.3, 0.8, 1.0, 1.0];
        for (step, expected) in expected.into_iter().enumerate() {
            assert!((response.at(step) - expected).abs() < 1e-15);
        }
        assert_eq!(response.settles(), 5);
    }
}
