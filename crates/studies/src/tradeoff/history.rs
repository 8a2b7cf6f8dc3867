//! Histories against the exact ones.

use std::time::Instant;

use anyhow::{Context, Result};
use linear::filters::radau;
use linear::waves::inversion::time_response;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{Complex64, RaisedCosine};

use campaign::engine::MethodSystem;
use campaign::plan::Setting;

/// The exact history is computed from frequencies up to half of this at least, Hz.
const BAND: f64 = 10_240.0;

/// What a history is the response to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// A step of the surface's speed, smoothed: a jump is in no method's band, and its
    /// largest error would never fall. The errors are parts of the step.
    SurfaceStep,
    /// An impulse on the bit. The errors are parts of the greatest displacement.
    BitImpulse,
}

/// The exact history of the bit, sampled at the highest frequency of a ladder, with
/// what it is the response to.
pub struct History {
    input: Input,
    window: RaisedCosine,
    setting: Setting,
    sampling_frequency: f64,
    values: Vec<f64>,
}

impl History {
    /// The history of `time` seconds after an input that rises, or lasts, as the window
    /// does.
    ///
    /// # Errors
    /// Where the setting has no such response.
    pub fn new(
        input: Input,
        window: RaisedCosine,
        setting: &Setting,
        sampling_frequency: f64,
        time: f64,
    ) -> Result<Self> {
        let response = exact_response(input, setting)?;
        let transform = |s| {
            let through_window = response(s) * window.transform(s);
            match input {
                Input::SurfaceStep => through_window / s,
                Input::BitImpulse => through_window,
            }
        };
        Ok(Self {
            input,
            window,
            setting: setting.clone(),
            sampling_frequency,
            values: sampled(transform, sampling_frequency, time),
        })
    }

    /// The greatest error of a system's history; `None` where that is not finite.
    pub fn error(&self, system: &MethodSystem) -> Option<f64> {
        let responses = &system.responses;
        let taps = match self.input {
            Input::SurfaceStep => &responses.torsion()?.from_surface[0],
            Input::BitImpulse => responses.bending()?.taps_between(0, 0)?,
        };
        let frequency = system.setting.sampling_frequency;
        let found = self.response(taps, frequency, 0.0);
        self.greatest_error(&found, frequency, 0)
    }

    /// The time that two-stage Radau quadrature takes to find its taps, s, and its
    /// error.
    ///
    /// # Errors
    /// Where the setting has no such response.
    pub fn by_radau(&self, frequency: f64) -> Result<(f64, Option<f64>)> {
        let response = exact_response(self.input, &self.setting)?;
        let count = thinned(&self.values, self.stride(frequency)).len();
        let start = Instant::now();
        let taps = radau::taps(frequency, count, &response);
        let build_seconds = start.elapsed().as_secs_f64();
        let mut found = vec![0.0; count];
        for (stage, place) in radau::STAGES.into_iter().enumerate() {
            let from_stage = self.response(&taps[2 + stage], frequency, place);
            for (value, more) in found.iter_mut().zip(from_stage) {
                *value += more;
            }
        }
        // The first step ends a step after the beginning.
        Ok((build_seconds, self.greatest_error(&found, frequency, 1)))
    }

    /// The response by some taps to the input, read `place` steps late.
    fn response(&self, taps: &[f64], frequency: f64, place: f64) -> Vec<f64> {
        let time = |step: usize| (step as f64 + place) / frequency;
        let count = thinned(&self.values, self.stride(frequency)).len();
        match self.input {
            Input::SurfaceStep => {
                smooth_step_response(taps, |step| self.window.integral(time(step)), count)
            }
            Input::BitImpulse => {
                let samples = (self.window.duration * frequency).ceil() as usize;
                let pulse: Vec<f64> = (0..=samples)
                    .map(|step| self.window.at(time(step)))
                    .collect();
                let steps = 0..count;
                steps
                    .map(|step| short_response(taps, &pulse, step))
                    .collect()
            }
        }
    }

    /// The greatest difference from the exact history, from its sample `first` on.
    fn greatest_error(&self, found: &[f64], frequency: f64, first: usize) -> Option<f64> {
        let exact = thinned(&self.values, self.stride(frequency)).skip(first);
        let differences = found.iter().zip(exact).map(|(one, other)| one - other);
        let scale = match self.input {
            Input::SurfaceStep => 1.0,
            Input::BitImpulse => greatest(self.values.iter().copied()),
        };
        Some(greatest(differences) / scale).filter(|error| error.is_finite())
    }

    /// Samples from one to the next at a frequency that divides the highest.
    fn stride(&self, frequency: f64) -> usize {
        ((self.sampling_frequency / frequency).round() as usize).max(1)
    }
}

/// The exact response of the bit at s (rad/s).
fn exact_response(
    input: Input,
    setting: &Setting,
) -> Result<Box<dyn Fn(Complex64) -> Complex64 + Sync + '_>> {
    Ok(match input {
        Input::SurfaceStep => {
            let network = TorsionNetwork::new(&setting.string, &setting.sites)?;
            Box::new(move |s| network.admittance(s).from_surface[0])
        }
        Input::BitImpulse => {
            let lateral = setting.lateral.as_ref();
            let lateral = lateral.context("the scene has no lateral motion")?;
            let (bending, support) = (lateral.bending, lateral.support);
            let network = BendingNetwork::new(&setting.string, bending, support, &setting.sites)?;
            Box::new(move |s| network.receptance(s)[(0, 0)])
        }
    })
}

/// The history of `time` seconds with a Laplace transform.
fn sampled(
    transform: impl Fn(Complex64) -> Complex64 + Sync,
    sampling_frequency: f64,
    time: f64,
) -> Vec<f64> {
    let count = (time * sampling_frequency).round() as usize + 1;
    let oversampling = (BAND / sampling_frequency).ceil() as usize;
    time_response(transform, 1.0 / sampling_frequency, count, oversampling)
}

fn thinned(values: &[f64], stride: usize) -> impl ExactSizeIterator<Item = f64> {
    values.iter().step_by(stride).copied()
}

/// The greatest size; what is not a number is no small error.
fn greatest(values: impl Iterator<Item = f64>) -> f64 {
    let sizes = values.map(|value| {
        if value.is_nan() {
            f64::INFINITY
        } else {
            value.abs()
        }
    });
    sizes.fold(0.0, f64::max)
}

/// The response to an input that rises smoothly to 1 and stays there: that to a
/// step from the start, less what the input is short of it.
fn smooth_step_response(taps: &[f64], input: impl Fn(usize) -> f64, count: usize) -> Vec<f64> {
    let missing = (0..count).map(|step| 1.0 - input(step));
    let missing: Vec<f64> = missing.take_while(|part| *part > 0.0).collect();
    let mut step_response = 0.0;
    (0..count)
        .map(|step| {
            step_response += taps.get(step).copied().unwrap_or(0.0);
            step_response - short_response(taps, &missing, step)
        })
        .collect()
}

/// The response at a step to an input that lasts a few steps only.
fn short_response(taps: &[f64], input: &[f64], step: usize) -> f64 {
    let reach = input.len().min(step + 1);
    let parts = (0..reach).map(|lag| input[lag] * taps.get(step - lag).copied().unwrap_or(0.0));
    parts.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_step_is_answered_as_by_the_whole_sum() {
        let taps: Vec<f64> = (0..40).map(|n| 0.9f64.powi(n)).collect();
        let input = |step: usize| (step as f64 / 7.0).min(1.0);
        let found = smooth_step_response(&taps, input, 60);
        for (step, found) in found.iter().enumerate() {
            let lags = 0..=step;
            let whole: f64 = lags
                .map(|lag| taps.get(lag).unwrap_or(&0.0) * input(step - lag))
                .sum();
            assert!((found - whole).abs() < 1e-12, "{step}");
        }
    }

    #[test]
    fn an_exact_history_is_thinned_to_lower_frequencies() {
        let exact = sampled(|s| (s + 1.0).powi(-3), 100.0, 1.0);
        assert_eq!((exact.len(), thinned(&exact, 4).len()), (101, 26));
        let last = thinned(&exact, 4).last().unwrap();
        assert!((last - 0.5 * (-1.0f64).exp()).abs() < 1e-8);
    }
}
