//! The exact response in time, by inverting a Laplace transform numerically: the
//! reference that no discrete method has a part in.
//!
//! The inversion integral along Re s = σ by the trapezoidal rule is a Fourier
//! series: exact but for what the function is a period later, damped by e^(−σT),
//! and for the frequencies left out (H. Dubner and J. Abate, *Journal of the
//! ACM* 15, 1968, 115–123). So the transform must fall fast: an input that rises
//! smoothly, not a jump.
//!
//! 1/(1 + s)³ is the transform of t²/2 e^(−t):
//!
//! ```
//! use linear::waves::inversion::time_response;
//!
//! let (step, count) = (0.05, 200);
//! let found = time_response(|s| (1.0 + s).powi(-3), step, count, 64);
//! for (index, value) in found.into_iter().enumerate() {
//!     let time = index as f64 * step;
//!     assert!((value - 0.5 * time * time * (-time).exp()).abs() < 1e-5);
//! }
//! ```

use num_complex::Complex64;

use crate::{fft, parallel};

/// σT: what is folded back is damped to 1e-10.
const DAMPING: f64 = 23.0;

/// Only this part of the period is kept: rounding in the transform, which is a
/// few thousand times that of the numbers, grows by e^(σt) and so no further
/// than to 1e-10.
const KEPT_PART: usize = 4;

/// Frequencies that a thread takes at a time, at least.
const MIN_FREQUENCIES: usize = 256;

/// The function of time whose Laplace transform is `transform`, at the times
/// `k · step` (s) for k below `count`; frequencies up to `oversampling` times
/// half the rate of these samples are taken into account.
pub fn time_response(
    transform: impl Fn(Complex64) -> Complex64 + Sync,
    step: f64,
    count: usize,
    oversampling: usize,
) -> Vec<f64> {
    let only = |s: Complex64, values: &mut [Complex64]| values[0] = transform(s);
    time_responses(only, 1, step, count, oversampling).swap_remove(0)
}

/// The same for a number of `functions` whose transforms are found together.
///
/// Frequencies that differ by a multiple of the sampling rate are one at the times of the
/// samples. So they are added up before the FFT, which is as short as what it returns.
pub fn time_responses(
    transforms: impl Fn(Complex64, &mut [Complex64]) + Sync,
    functions: usize,
    step: f64,
    count: usize,
    oversampling: usize,
) -> Vec<Vec<f64>> {
    let (kept, oversampling) = (KEPT_PART * count.max(1), oversampling.max(1));
    let last = kept / 2 * oversampling;
    let period = kept as f64 * step;
    let shift = DAMPING / period;
    // Of each frequency of the samples, what those above zero add up to that are one with it.
    let at_once = MIN_FREQUENCIES.div_ceil(oversampling);
    let folded: Vec<Vec<Complex64>> = parallel::map(kept, at_once, |remainder| {
        let mut values = vec![Complex64::ZERO; functions];
        let mut sums = values.clone();
        for index in (remainder..=last).step_by(kept) {
            let rate = std::f64::consts::TAU * index as f64 / period;
            transforms(Complex64::new(shift, rate), &mut values);
            // The two that are their own conjugates count once, and half from each side.
            let part = if index == 0 || index == last {
                0.5
            } else {
                1.0
            };
            for (sum, value) in sums.iter_mut().zip(&values) {
                *sum += part * value;
            }
        }
        sums
    });
    let plan = fft::inverse(kept);
    let mut samples = plan.make_output_vec();
    let of_function = |function: usize| {
        // Those below zero are the conjugates.
        let mut spectrum: Vec<Complex64> = (0..=kept / 2)
            .map(|index| folded[index][function] + folded[(kept - index) % kept][function].conj())
            .collect();
        spectrum[0].im = 0.0;
        spectrum[kept / 2].im = 0.0;
        plan.process(&mut spectrum, &mut samples)
            .expect("lengths and the two real ends are set above");
        let growing = |(index, sample): (usize, &f64)| {
            let time = index as f64 * step;
            sample * (shift * time).exp() / period
        };
        samples[..count].iter().enumerate().map(growing).collect()
    };
    (0..functions).map(of_function).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// t³ e^(−t), whose transform 6/(s + 1)⁴ falls fast.
    #[test]
    fn a_closed_form_is_met_to_eight_digits() {
        let values = time_response(|s| 6.0 * (s + 1.0).powi(-4), 0.01, 2000, 8);
        for (index, value) in values.iter().enumerate() {
            let time = index as f64 * 0.01;
            let exact = time.powi(3) * (-time).exp();
            assert!((value - exact).abs() < 1e-8, "{time}: {value} {exact}");
        }
    }

    /// A wave that arrives after a delay, and echoes that never die.
    #[test]
    fn delays_and_echoes_are_met() {
        let rate = std::f64::consts::TAU;
        let pulse = |s: Complex64| rate.powi(2) * (1.0 - (-s).exp()) / (s * (s * s + rate * rate));
        let values = time_response(|s| pulse(s) / (1.0 + (-s * 2.0).exp()), 0.005, 2000, 16);
        for (index, value) in values.iter().enumerate() {
            let time = index as f64 * 0.005;
            let sign = if ((time / 2.0) as usize) % 2 == 0 {
                1.0
            } else {
                -1.0
            };
            let since = time % 2.0;
            let lasts = since < 1.0;
            let exact = if lasts {
                sign * (1.0 - (rate * since).cos())
            } else {
                0.0
            };
            assert!((value - exact).abs() < 1e-6, "{time}: {value} {exact}");
        }
    }
}
