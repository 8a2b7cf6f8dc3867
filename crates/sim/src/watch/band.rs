//! The band within which a sensor records an acceleration.
//!
//! A three-pole low-pass filter of Bessel's kind, whose answer to a shock does not overshoot, here with
//! half the power at a frequency f_b (s in units of 1.7557 rad of that):
//!
//! H(s) = 15/(s³ + 6 s² + 15 s + 15)
//!
//! The data sheet of the Analog Devices ADXL180 has this filter, with f_b of 100, 200, 400 or 800 Hz to
//! choose from, and the lowest is what is taken unless a tool says otherwise: whirl goes round less often
//! than that, and the usual sampling frequency holds it. Its steps are samples of its answer to impulses (by
//! its three poles), which are stable at any sampling frequency, made exact for what is constant.
//!
//! An acceleration is a difference of positions (of speeds), and too small by (sin x/x)² (by sin x/x),
//! x = π f/f_s. The next term of its series makes up for that: a − δ²a/12 (a − δ²a/24), one step late.

use serde::{Deserialize, Serialize};

/// The band of accelerations where no tool says otherwise, Hz: the lowest of the ADXL180 (Analog Devices,
/// data sheet).
pub const USUAL_BAND: f64 = 100.0;

/// Samples in a period of the highest band that a sampling frequency holds. In four samples a difference
/// is 5 % too small after its correction.
pub const SAMPLES_OF_BAND: f64 = 4.0;

/// Periods of a band after which nothing of the filter's start is left: its slowest pole falls by
/// e^−6.58 in each.
pub const PERIODS_TO_SETTLE: f64 = 5.0;

/// −3 dB of Bessel's filter of unit delay, rad/s.
const HALF_POWER: f64 = 1.755_672_368_681_21;
/// Its real pole −p, and the sum and the product of the other two: s³ + 6 s² + 15 s + 15 = (s + p)(s² + b s + c).
const POLE: f64 = 2.322_185_354_626_086;
const PAIR: [f64; 2] = [6.0 - POLE, 15.0 / POLE];

/// An acceleration within a band, over a window.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct InBand {
    /// The band, Hz: the one that was asked for, or the highest that the sampling frequency holds.
    pub band: f64,
    /// The greatest, m/s².
    pub peak: f64,
    /// Root mean square, m/s².
    pub rms: f64,
}

/// The sums of an acceleration over a window.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct AccelerationSums {
    pub(crate) peak_square: f64,
    sum_of_squares: f64,
    steps: usize,
    /// The last two squares, the latest first.
    last: [f64; 2],
}

impl AccelerationSums {
    /// Adds the square of an acceleration within a band, (m/s²)²: the greatest between steps is that of
    /// the parabola through three.
    #[inline]
    pub(crate) fn add_in_band(&mut self, square: f64) {
        let [middle, first] = self.last;
        if self.steps > 1 && middle > square.max(first) {
            let above = (square - first).powi(2) / (8.0 * (2.0 * middle - first - square));
            self.peak_square = self.peak_square.max(middle + above);
        }
        self.last = [square, middle];
        self.add(square);
    }

    /// Adds the square of an acceleration, (m/s²)².
    #[inline]
    pub(crate) fn add(&mut self, square: f64) {
        self.peak_square = self.peak_square.max(square);
        self.sum_of_squares += square;
        self.steps += 1;
    }

    /// The greatest and the root mean square, m/s²; `None` before the first step.
    pub(crate) fn measures(&self) -> Option<[f64; 2]> {
        let mean_square = self.sum_of_squares / self.steps as f64;
        (self.steps > 0).then(|| [self.peak_square, mean_square].map(f64::sqrt))
    }

    /// The same of an acceleration within the band of a filter.
    pub(crate) fn within(&self, filter: &LowPass) -> Option<InBand> {
        self.measures().map(|[peak, rms]| InBand {
            band: filter.band,
            peak,
            rms,
        })
    }
}

/// The highest band that a sampling frequency holds, Hz.
pub fn highest_band(sampling_frequency: f64) -> f64 {
    sampling_frequency / SAMPLES_OF_BAND
}

/// Steps before a window from which on a filter has to see an acceleration.
pub fn steps_to_settle(band: f64, sampling_frequency: f64) -> usize {
    let band = band.min(highest_band(sampling_frequency));
    (PERIODS_TO_SETTLE * sampling_frequency / band).ceil() as usize
}

/// What an acceleration is a difference of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DifferenceOf {
    /// Three positions.
    Positions,
    /// Two speeds.
    Speeds,
}

/// The filter of a band: a sum of a decay and of a swing that decays, of every acceleration so far.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LowPass {
    /// The band that it has, Hz.
    band: f64,
    /// What is left of the decay after a step.
    decay: f64,
    /// The same of the swing, by real and imaginary part.
    swing: [f64; 2],
    /// What the output has of decay, and of both parts of the swing.
    parts: [f64; 3],
}

/// What a filter remembers of one component of an acceleration.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Filtered {
    /// The last two accelerations, the latest first, m/s².
    inputs: [f64; 2],
    decay: f64,
    swing: [f64; 2],
}

impl LowPass {
    /// The filter of a band (Hz), or of the highest that the sampling frequency (Hz) holds.
    pub(crate) fn new(band: f64, sampling_frequency: f64) -> Self {
        let band = band.min(highest_band(sampling_frequency));
        let step = std::f64::consts::TAU * band / (HALF_POWER * sampling_frequency);
        let falls = 0.5 * PAIR[0];
        let turns = (PAIR[1] - falls * falls).sqrt();
        let decay = (-POLE * step).exp();
        let (sin, cos) = (turns * step).sin_cos();
        let swing = [cos, sin].map(|part| (-falls * step).exp() * part);
        // Residues of 15/((s + p)(s² + b s + c)), in parts of the first.
        let residues = [1.0, -1.0, (POLE - falls) / turns];
        // What is constant leaves 1/(1 − decay) and 1/(1 − swing).
        let [real, imaginary] = [1.0 - swing[0], swing[1]];
        let square = real * real + imaginary * imaginary;
        let constant = [1.0 / (1.0 - decay), real / square, imaginary / square];
        let whole: f64 = residues.iter().zip(constant).map(|(a, b)| a * b).sum();
        Self {
            band,
            decay,
            swing,
            parts: residues.map(|residue| residue / whole),
        }
    }

    /// One component of an acceleration within the band, m/s², after the next step of it.
    #[inline]
    pub(crate) fn pass(&self, state: &mut Filtered, input: f64, of: DifferenceOf) -> f64 {
        let part = match of {
            DifferenceOf::Positions => 1.0 / 12.0,
            DifferenceOf::Speeds => 1.0 / 24.0,
        };
        let [last, first] = state.inputs;
        let corrected = last - part * (input - 2.0 * last + first);
        let ([cos, sin], [real, imaginary]) = (self.swing, state.swing);
        *state = Filtered {
            inputs: [input, last],
            decay: self.decay * state.decay + corrected,
            swing: [
                cos * real - sin * imaginary + corrected,
                sin * real + cos * imaginary,
            ],
        };
        let [of_decay, of_real, of_imaginary] = self.parts;
        of_decay * state.decay + of_real * state.swing[0] + of_imaginary * state.swing[1]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// |H| of Bessel's filter at a frequency, in parts of its band.
    fn exact(part: f64) -> f64 {
        let s = part * HALF_POWER;
        // 15/|(s j)³ + 6 (s j)² + 15 s j + 15|.
        15.0 / (15.0 - 6.0 * s * s).hypot(15.0 * s - s.powi(3))
    }

    /// The amplitude that a filter leaves of an oscillation of unit acceleration, seen as differences.
    fn left_of(frequency: f64, band: f64, sampling: f64, of: DifferenceOf) -> f64 {
        let filter = LowPass::new(band, sampling);
        let mut state = Filtered::default();
        let rate = TAU * frequency / sampling;
        let at = |step: usize| (rate * step as f64).sin();
        let settled = steps_to_settle(band, sampling) + 2;
        // A second more, in which are whole periods.
        let outputs = (2..settled + 2 + sampling as usize).map(|step| {
            // Of a unit of acceleration, per step².
            let difference = match of {
                DifferenceOf::Positions => {
                    (at(step) - 2.0 * at(step - 1) + at(step - 2)) / (rate * rate)
                }
                DifferenceOf::Speeds => (at(step) - at(step - 1)) / rate,
            };
            filter.pass(&mut state, difference, of)
        });
        let outputs: Vec<f64> = outputs.collect();
        let squares = outputs[settled..].iter().map(|output| output * output);
        (2.0 * squares.sum::<f64>() / (outputs.len() - settled) as f64).sqrt()
    }

    #[test]
    fn half_the_power_is_left_at_the_band() {
        assert!((exact(1.0) - 0.5f64.sqrt()).abs() < 1e-12, "{}", exact(1.0));
        let [linear, constant] = PAIR;
        // The three coefficients of the product of both.
        assert!((POLE + linear - 6.0).abs() < 1e-12);
        assert!((POLE * linear + constant - 15.0).abs() < 1e-12);
        assert!((POLE * constant - 15.0).abs() < 1e-12);
    }

    /// At any sampling frequency that holds the band by some.
    #[test]
    fn an_oscillation_has_the_amplitude_that_the_sensor_gives() {
        for of in [DifferenceOf::Positions, DifferenceOf::Speeds] {
            for (sampling, within) in [(640.0, 0.03), (1280.0, 2e-3), (5120.0, 2e-4)] {
                for frequency in [2.0, 20.0, 45.0, 70.0, 100.0] {
                    let found = left_of(frequency, 100.0, sampling, of);
                    let expected = exact(frequency / 100.0);
                    assert!(
                        (found / expected - 1.0).abs() < within,
                        "{of:?} {frequency} Hz at {sampling} Hz: {found} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_filter_is_stable_and_defined_at_any_sampling_frequency() {
        for sampling in [0.5, 10.0, 150.0, 399.0, 401.0, 1e6] {
            let filter = LowPass::new(100.0, sampling);
            assert!(filter.band <= sampling / SAMPLES_OF_BAND);
            let mut state = Filtered::default();
            let steps = steps_to_settle(100.0, sampling);
            let mut pass = |input| filter.pass(&mut state, input, DifferenceOf::Positions);
            // What is constant is left as it is, and what was there is forgotten.
            let mut output = 0.0;
            (0..steps + 3).for_each(|_| output = pass(1.0));
            assert!((output - 1.0).abs() < 1e-9, "{sampling}: {output}");
            (0..steps + 3).for_each(|_| output = pass(0.0));
            assert!(output.abs() < 1e-9, "{sampling}: {output}");
        }
    }
}
