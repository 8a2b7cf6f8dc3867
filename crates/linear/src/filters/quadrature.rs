//! Convolution quadrature (Lubich, Numer. Math. 52, 1988, 129–145 and
//! 413–425) with the two-step backward difference formula.
//!
//! The taps are the Taylor coefficients in ζ of K(δ(ζ) f_s) with
//! δ(ζ) = 3/2 − 2ζ + ζ²/2. BDF2 is A-stable: δ maps the unit disc into the
//! right half plane, where a positive-real K has a positive real part. So the
//! taps are positive-real exactly, a sticking bit is stable, and since
//! δ(1) = 0 the static limits are exact.

use faer::c64;

use super::{inverse_transform, sample};

/// Samples on the circle per tap kept. Rounding grows as ρ^(−n); with four
/// samples a tap it grows by no more than CIRCLE_DECAY^(−1/4).
const SAMPLES_PER_TAP: usize = 4;

/// ρ^M for M samples on the circle of radius ρ: the part of tap n + M that is
/// folded back onto tap n. Between this and rounding, ρ is a compromise.
const CIRCLE_DECAY: f64 = 1e-10;

/// The points ζ at which generating functions are sampled.
pub(super) struct Circle {
    /// How many there are, all around.
    pub(super) samples: usize,
    radius: f64,
}

/// The circle for so many taps.
pub(super) fn circle(count: usize) -> Circle {
    let samples = SAMPLES_PER_TAP * count.max(2);
    Circle {
        samples,
        radius: CIRCLE_DECAY.powf(1.0 / samples as f64),
    }
}

impl Circle {
    /// A point, in the order of the transform.
    pub(super) fn point(&self, index: usize) -> c64 {
        let angle = -std::f64::consts::TAU / self.samples as f64;
        c64::from_polar(self.radius, angle * index as f64)
    }
}

/// The first `count` Taylor coefficients of what was sampled on a circle.
pub(super) fn coefficients(mut spectrum: Vec<c64>, circle: &Circle, count: usize) -> Vec<f64> {
    let mut taps = inverse_transform(&mut spectrum, circle.samples);
    taps.truncate(count);
    for (index, tap) in taps.iter_mut().enumerate() {
        *tap *= circle.radius.powf(-(index as f64));
    }
    taps
}

/// The first `count` taps of every channel.
pub fn taps(
    sampling_frequency: f64,
    count: usize,
    channels: usize,
    response: &(impl Fn(c64, &mut [c64]) + Sync),
) -> Vec<Vec<f64>> {
    let circle = circle(count);
    let on_circle = |index: usize| generating_function(circle.point(index)) * sampling_frequency;
    sample(channels, circle.samples / 2 + 1, on_circle, response)
        .into_iter()
        .map(|spectrum| coefficients(spectrum, &circle, count))
        .collect()
}

/// δ(ζ) of BDF2.
fn generating_function(zeta: c64) -> c64 {
    1.5 - zeta * (2.0 - 0.5 * zeta)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K(s) = 1/s integrates: 1/δ = 1/(1 − ζ) − 1/(3 − ζ) has the
    /// coefficients 1 − 3^(−n−1).
    #[test]
    fn taps_of_an_integrator_are_those_of_the_difference_formula() {
        let integrate = |s: c64, out: &mut [c64]| out[0] = s.inv();
        let taps = &taps(10.0, 64, 1, &integrate)[0];
        for (index, tap) in taps.iter().enumerate() {
            let exact = (1.0 - 3f64.powi(-(index as i32) - 1)) / 10.0;
            assert!((tap - exact).abs() < 1e-9, "{index}: {tap} {exact}");
        }
    }
}
