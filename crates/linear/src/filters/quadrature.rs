//! Convolution quadrature (Lubich, Numer. Math. 52, 1988, 129–145 and
//! 413–425): the taps are the Taylor coefficients in ζ of K(δ(ζ) f_s), where δ
//! belongs to a formula for differentiating in time.
//!
//! Both formulas here are A-stable: δ maps the unit disc into the right half
//! plane, where a positive-real K has a positive real part. So the taps are
//! positive-real exactly, and since δ(1) = 0 the static limits are exact.

use std::sync::Arc;

use num_complex::Complex64;

use super::{Buffers, ResponseAt, inverse_transform, keep, sample};
use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::fft::{self, ComplexToReal};

/// How closely a circle of radius ρ is sampled. With M samples, a part ρ^M of what is M taps later
/// is folded back, while rounding grows as ρ^(−n): ρ is a compromise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sampling {
    /// Of a response that continues: to some 1e-10 of its largest tap.
    Close,
    /// Of a response that continues, where each sample is expensive: to some 1e-8 of its largest
    /// tap.
    Wide,
    /// Of what has decayed before its last tap: nothing is left to be folded back.
    Once,
}

impl Sampling {
    /// Samples on the circle per tap kept.
    pub(crate) fn per_tap(self) -> usize {
        match self {
            Sampling::Close => 4,
            Sampling::Wide => 2,
            Sampling::Once => 1,
        }
    }

    /// ρ^M for M samples.
    fn folded_back(self) -> f64 {
        match self {
            Sampling::Close => 1e-10,
            Sampling::Wide => 1e-8,
            // Rounding at the end of the response grows a hundredfold.
            Sampling::Once => 1e-2,
        }
    }
}

/// The points ζ at which generating functions are sampled, as products of a starting point and a
/// turn from there: few sines are enough.
pub(super) struct Circle {
    plan: Arc<dyn ComplexToReal<f64>>,
    radius: f64,
    /// Starting points at regular intervals.
    from: Vec<Complex64>,
    /// The turns on, as many as there are points from one to the next.
    turns: Vec<Complex64>,
}

/// Buffers for the first `count` taps of every channel.
pub(crate) fn buffers(count: usize, channels: usize, sampling: Sampling) -> Buffers {
    Buffers {
        channels,
        samples: (sampling.per_tap() * count.max(2)).next_multiple_of(2),
        taps: count,
    }
}

/// The circle for a number of samples.
pub(super) fn circle(samples: usize, sampling: Sampling) -> Circle {
    let radius = sampling.folded_back().powf(1.0 / samples as f64);
    let angle = |index: usize| -std::f64::consts::TAU / samples as f64 * index as f64;
    let stride = samples.isqrt();
    let starts = (0..samples).step_by(stride);
    Circle {
        plan: fft::inverse(samples),
        radius,
        from: starts
            .map(|index| Complex64::from_polar(radius, angle(index)))
            .collect(),
        turns: (0..stride)
            .map(|index| Complex64::cis(angle(index)))
            .collect(),
    }
}

impl Circle {
    /// A point, in the order of the transform.
    pub(super) fn point(&self, index: usize) -> Complex64 {
        let stride = self.turns.len();
        self.from[index / stride] * self.turns[index % stride]
    }

    /// The first `count` Taylor coefficients of what was sampled here.
    pub(super) fn coefficients(&self, mut spectrum: Vec<Complex64>, count: usize) -> Vec<f64> {
        let mut taps = keep(inverse_transform(&*self.plan, &mut spectrum), count);
        self.unwind(&mut taps);
        taps
    }

    /// Undoes what the radius does to the coefficients of a series.
    fn unwind(&self, coefficients: &mut [f64]) {
        let stride = self.turns.len();
        let power = |index: usize| self.radius.powf(-(index as f64));
        let powers: Vec<f64> = (0..stride).map(power).collect();
        for (chunk, coefficients) in coefficients.chunks_mut(stride).enumerate() {
            let first = power(chunk * stride);
            for (coefficient, power) in coefficients.iter_mut().zip(&powers) {
                *coefficient *= first * power;
            }
        }
    }
}

/// A formula for differentiating in time, of second order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formula {
    /// Two-step backward differences, BDF2: δ(ζ) = 3/2 − 2ζ + ζ²/2. The highest
    /// frequency sampled is damped, δ(−1) = 4.
    BackwardDifferences,
    /// The trapezoidal rule: δ(ζ) = 2(1 − ζ)/(1 + ζ), kept to show that it fails.
    /// All frequencies to infinity are squeezed in below the highest one sampled,
    /// for δ(−1) is infinite, and none is damped by the formula: what is up there
    /// rings on for ever. Taps that are cut off anywhere are not positive-real.
    Trapezoidal,
}

impl Formula {
    /// δ(ζ) within the unit circle, |ζ| < 1, where it is finite.
    pub(crate) fn generating_function<T: Number>(self, zeta: T) -> T {
        match self {
            Formula::BackwardDifferences => zeta * (zeta * 0.5 - 2.0) + 1.5,
            Formula::Trapezoidal => (-zeta + 1.0) * (zeta + 1.0).inverse() * 2.0,
        }
    }
}

/// The first `count` taps of every channel.
pub fn taps(
    formula: Formula,
    sampling_frequency: f64,
    count: usize,
    channels: usize,
    sampling: Sampling,
    response: &ResponseAt<'_>,
) -> Vec<Vec<f64>> {
    let generating = |zeta: Lanes, values: &mut [Lanes]| {
        response(
            formula.generating_function(zeta) * sampling_frequency,
            values,
        );
    };
    series(count, channels, sampling, &generating)
}

/// The first `count` coefficients of every channel's generating function of ζ, |ζ| < 1.
pub(crate) fn series<T: Number + Send>(
    count: usize,
    channels: usize,
    sampling: Sampling,
    generating: &ResponseAt<'_, T>,
) -> Vec<Vec<f64>> {
    series_made(count, channels, sampling, generating, &|taps| taps)
}

/// The same, each made into something else before the next ones are there.
pub(crate) fn series_made<T: Number + Send>(
    count: usize,
    channels: usize,
    sampling: Sampling,
    generating: &ResponseAt<'_, T>,
    make: &(dyn Fn(Vec<f64>) -> Vec<f64> + Sync),
) -> Vec<Vec<f64>> {
    let buffers = buffers(count, channels, sampling);
    let circle = circle(buffers.samples, sampling);
    let on_circle = |index: usize| circle.point(index);
    sample(buffers, &on_circle, generating, &|spectrum| {
        make(circle.coefficients(spectrum, count))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::nodes::Relation;

    fn assert_integrates(formula: Formula, exact: impl Fn(i32) -> f64) {
        let integrate = |s: Lanes, out: &mut [Lanes]| out[0] = s.inverse();
        let taps = &taps(formula, 10.0, 64, 1, Sampling::Close, &integrate)[0];
        for (index, tap) in taps.iter().enumerate() {
            let exact = exact(index as i32) / 10.0;
            assert!((tap - exact).abs() < 1e-9, "{index}: {tap} {exact}");
        }
    }

    /// K(s) = 1/s integrates: 1/δ = 1/(1 − ζ) − 1/(3 − ζ) has the
    /// coefficients 1 − 3^(−n−1).
    #[test]
    fn taps_of_an_integrator_are_those_of_the_difference_formula() {
        assert_integrates(Formula::BackwardDifferences, |n| 1.0 - 3f64.powi(-n - 1));
    }

    /// 1/δ = ½ + ζ + ζ² + …
    #[test]
    fn the_trapezoidal_rule_gives_half_its_weight_to_the_ends() {
        assert_integrates(Formula::Trapezoidal, |n| if n == 0 { 0.5 } else { 1.0 });
    }

    /// 1/(1 − 2 cos φ ζ + ζ²) = Σ sin((n + 1)φ)/sin φ ζⁿ, which nothing damps.
    #[test]
    fn what_rings_for_ever_is_as_right_as_is_estimated() {
        const COUNT: usize = 20_000;
        let angle = 0.7f64;
        let ringing = |zeta: Lanes, out: &mut [Lanes]| {
            out[0] = (zeta * (zeta - 2.0 * angle.cos()) + 1.0).inverse();
        };
        let [close, wide] = [Sampling::Close, Sampling::Wide].map(|sampling| {
            let found = &series(COUNT, 1, sampling, &ringing)[0];
            let off = found.iter().enumerate().map(|(index, tap)| {
                let exact = ((index + 1) as f64 * angle).sin();
                (tap * angle.sin() - exact).abs()
            });
            off.fold(0.0, f64::max)
        });
        assert!(close < 2e-10 && wide < 2e-8, "{close} {wide}");
    }

    /// 1/(1 − aζ) = Σ aⁿ ζⁿ, of which 1e-12 is left at the end.
    #[test]
    fn what_has_decayed_needs_one_sample_a_tap() {
        const COUNT: usize = 20_000;
        let rate = 1e-12f64.powf(1.0 / COUNT as f64);
        let decaying = |zeta: Lanes, out: &mut [Lanes]| out[0] = (zeta * -rate + 1.0).inverse();
        let found = &series(COUNT, 1, Sampling::Once, &decaying)[0];
        for (index, tap) in found.iter().enumerate() {
            let exact = rate.powf(index as f64);
            assert!((tap - exact).abs() < 1e-12, "{index}: {tap} {exact}");
        }
    }
}
