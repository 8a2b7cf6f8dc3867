//! How a bit vibrates at the end of a case whose torque falls with speed: at which frequency, how
//! far, and how hard that shakes its rim.

use std::f64::consts::TAU;

use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::to_rpm;
use linear::fft;
use sim::Trajectory;

/// Standard gravity, m/s².
const GRAVITY: f64 = 9.80665;

/// The part of a case that is measured.
const END: f64 = 0.25;

/// Steps of it, at least.
const LEAST_STEPS: usize = 64;

/// A bit that swings by less than this part of its mean speed turns evenly.
const EVEN: f64 = 1e-3;

/// The vibration of a bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vibration {
    /// Of the largest line of its spectrum, Hz.
    pub frequency: f64,
    /// Half of the way from its least to its greatest speed, rad/s.
    pub amplitude: f64,
    /// The greatest acceleration of its rotation, rad/s².
    pub acceleration: f64,
}

impl Vibration {
    /// Of speeds (rad/s) at a sampling frequency (Hz); none where they are too few or even.
    fn of(speeds: &[f64], sampling: f64) -> Option<Self> {
        let steps = speeds.len();
        if steps < LEAST_STEPS || speeds.iter().any(|speed| !speed.is_finite()) {
            return None;
        }
        let mean = speeds.iter().sum::<f64>() / steps as f64;
        let ends = speeds.iter().fold([mean; 2], |[least, most], &speed| {
            [least.min(speed), most.max(speed)]
        });
        let amplitude = 0.5 * (ends[1] - ends[0]);
        let changes = speeds.windows(2).map(|two| (two[1] - two[0]).abs());
        let acceleration = sampling * changes.fold(0.0, f64::max);
        (amplitude > EVEN * mean.abs()).then(|| Self {
            frequency: largest_line(speeds, mean) * sampling,
            amplitude,
            acceleration,
        })
    }

    /// Of the bit at the end of a case; none of one whose torque jumps to what it is in slip, for
    /// its acceleration then has no greatest.
    pub fn at_the_end(sweep: &Sweep, motion: &Trajectory) -> Option<Self> {
        sweep.bit.as_ref()?;
        let falls = |axis| {
            sweep
                .conditions
                .value(axis)
                .is_some_and(|speed| speed > 0.0)
        };
        let decay = Axis::TorqueDecay;
        if !falls(decay) && !sweep.design.axes().contains(&decay) {
            return None;
        }
        let speeds = motion.speeds.last()?;
        let from = ((1.0 - END) * speeds.len() as f64) as usize;
        Self::of(&speeds[from..], motion.sampling_frequency()?)
    }

    /// In words, of a bit of a radius, m.
    pub fn in_words(&self, radius: f64) -> String {
        let g = self.acceleration * radius / GRAVITY;
        format!(
            "the bit vibrates at {:.2} Hz by {:.1} rpm to either side, with {:.2} g at its rim at most",
            self.frequency,
            to_rpm(self.amplitude),
            g
        )
    }
}

/// The frequency of the largest line, in parts of the sampling frequency: with a Hann window, and as
/// many zeros as values.
fn largest_line(values: &[f64], mean: f64) -> f64 {
    let length = 2 * values.len();
    let transform = fft::forward(length);
    let mut input = transform.make_input_vec();
    for (step, (input, value)) in input.iter_mut().zip(values).enumerate() {
        let window = 0.5 - 0.5 * (TAU * step as f64 / values.len() as f64).cos();
        *input = (value - mean) * window;
    }
    let mut lines = transform.make_output_vec();
    // Lengths are those of the plan.
    if transform.process(&mut input, &mut lines).is_err() {
        return 0.0;
    }
    let sizes = lines.iter().map(|line| line.norm_sqr()).enumerate();
    let largest = sizes.max_by(|one, other| one.1.total_cmp(&other.1));
    largest.map_or(0.0, |(line, _)| line as f64 / length as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_has_its_frequency_its_size_and_its_acceleration() {
        let sampling = 2000.0;
        let speeds = |size: f64| -> Vec<f64> {
            let swing = |step: usize| (TAU * 107.0 * step as f64 / sampling).sin();
            (0..4000).map(|step| 10.0 + size * swing(step)).collect()
        };
        let found = Vibration::of(&speeds(2.0), sampling).unwrap();
        assert!((found.frequency - 107.0).abs() < 0.5 * sampling / 4000.0);
        assert!((found.amplitude - 2.0).abs() < 0.01);
        // Between two steps a sine changes a little less than it does at most.
        let most = TAU * 107.0 * 2.0;
        assert!((0.98..=1.0).contains(&(found.acceleration / most)));
        assert_eq!(Vibration::of(&speeds(0.005), sampling), None);
        assert_eq!(Vibration::of(&speeds(2.0)[..20], sampling), None);
        assert_eq!(Vibration::of(&[f64::NAN; 100], sampling), None);
    }
}
