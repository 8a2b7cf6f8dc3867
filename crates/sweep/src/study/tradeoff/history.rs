//! Histories against the exact ones.

use linear::Complex64;
use linear::waves::inversion::time_response;

/// The exact history is computed from frequencies up to half of this at least, Hz.
const BAND: f64 = 10_240.0;

/// An exact history, sampled at the highest frequency of a ladder.
pub struct Exact {
    sampling_frequency: f64,
    values: Vec<f64>,
}

impl Exact {
    /// A history that nobody asked for.
    pub fn none() -> Self {
        Self {
            sampling_frequency: 1.0,
            values: Vec::new(),
        }
    }

    /// The history of `time` seconds with the given Laplace transform.
    pub fn new(
        sampling_frequency: f64,
        time: f64,
        transform: impl Fn(Complex64) -> Complex64 + Sync,
    ) -> Self {
        let count = (time * sampling_frequency).round() as usize + 1;
        let oversampling = (BAND / sampling_frequency).ceil() as usize;
        Self {
            sampling_frequency,
            values: time_response(transform, 1.0 / sampling_frequency, count, oversampling),
        }
    }

    /// How many samples it has at a frequency that divides its own.
    pub fn count(&self, frequency: f64) -> usize {
        self.values.len().div_ceil(self.stride(frequency))
    }

    /// Its samples at a frequency that divides its own, from sample `first` on.
    pub fn at(&self, frequency: f64, first: usize) -> impl Iterator<Item = f64> {
        let values = self.values.iter().step_by(self.stride(frequency));
        values.skip(first).copied()
    }

    /// The greatest of it.
    pub fn peak(&self) -> f64 {
        let sizes = self.values.iter().map(|value| value.abs());
        sizes.fold(0.0, f64::max)
    }

    fn stride(&self, frequency: f64) -> usize {
        ((self.sampling_frequency / frequency).round() as usize).max(1)
    }
}

/// The largest difference between a history and an exact one.
pub fn greatest_difference(found: &[f64], exact: impl Iterator<Item = f64>) -> f64 {
    let differences = found.iter().zip(exact).map(|(one, other)| one - other);
    // What is not a number is no small error.
    differences.fold(0.0, |most: f64, difference| {
        if difference.is_nan() {
            f64::INFINITY
        } else {
            most.max(difference.abs())
        }
    })
}

/// The response to an input that rises smoothly to 1 and stays there: that to a
/// step from the start, less what the input is short of it.
pub fn smooth_step_response(taps: &[f64], input: impl Fn(usize) -> f64, count: usize) -> Vec<f64> {
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
pub fn short_response(taps: &[f64], input: &[f64], step: usize) -> f64 {
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
        let exact = Exact::new(100.0, 1.0, |s| (s + 1.0).powi(-3));
        assert_eq!((exact.count(100.0), exact.count(25.0)), (101, 26));
        let last = exact.at(25.0, 1).last().unwrap();
        assert!((last - 0.5 * (-1.0f64).exp()).abs() < 1e-8);
    }
}
