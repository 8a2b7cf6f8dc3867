//! The exact response in time, by inverting a Laplace transform numerically: the
//! reference that no discrete method has a part in.
//!
//! The inversion integral along Re s = σ by the trapezoidal rule is a Fourier
//! series: exact but for what the function is a period later, damped by e^(−σT),
//! and for the frequencies left out (H. Dubner and J. Abate, *Journal of the
//! ACM* 15, 1968, 115–123). So the transform must fall fast: an input that rises
//! smoothly, not a jump.

use num_complex::Complex64;
use rayon::prelude::*;
use realfft::RealFftPlanner;

/// σT: what is folded back is damped to 1e-10.
const DAMPING: f64 = 23.0;

/// Only this part of the period is kept: rounding in the transform, which is a
/// few thousand times that of the numbers, grows by e^(σt) and so no further
/// than to 1e-10.
const KEPT_PART: usize = 4;

/// The function of time whose Laplace transform is `transform`, at the times
/// `k · step` (s) for k below `count`; frequencies up to `oversampling` times
/// half the rate of these samples are taken into account.
pub fn time_response(
    transform: impl Fn(Complex64) -> Complex64 + Sync,
    step: f64,
    count: usize,
    oversampling: usize,
) -> Vec<f64> {
    let (kept, oversampling) = (KEPT_PART * count.max(1), oversampling.max(1));
    let samples = kept * oversampling;
    let period = kept as f64 * step;
    let shift = DAMPING / period;
    let mut spectrum: Vec<Complex64> = (0..samples / 2 + 1)
        .into_par_iter()
        .with_min_len(256)
        .map(|index| {
            let rate = std::f64::consts::TAU * index as f64 / period;
            transform(Complex64::new(shift, rate))
        })
        .collect();
    spectrum[0].im = 0.0;
    spectrum[samples / 2].im = 0.0;
    let plan = RealFftPlanner::<f64>::new().plan_fft_inverse(samples);
    let mut values = plan.make_output_vec();
    plan.process(&mut spectrum, &mut values)
        .expect("lengths and the two real ends are set above");
    (0..count)
        .map(|index| {
            let time = index as f64 * step;
            values[index * oversampling] * (shift * time).exp() / period
        })
        .collect()
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
            let sign = if ((time / 2.0) as usize).is_multiple_of(2) {
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
