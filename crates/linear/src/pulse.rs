//! The raised cosine of unit area: the band-limited impulse of Section 5.2.2,
//! and the window through which a step is compared where a jump would be in no method's band.
//!
//! ```
//! use linear::RaisedCosine;
//!
//! let pulse = RaisedCosine { duration: 0.02 };
//! assert_eq!(pulse.at(0.01), 2.0 / 0.02);
//! assert_eq!((pulse.at(-0.01), pulse.at(0.03)), (0.0, 0.0));
//! // Half of its unit area by its middle.
//! assert!((pulse.integral(0.01) - 0.5).abs() < 1e-12);
//! assert_eq!(pulse.integral(1.0), 1.0);
//! ```

use std::f64::consts::TAU;

use num_complex::Complex64;

/// (1 − cos 2πt/τ)/τ for 0 ≤ t ≤ τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaisedCosine {
    /// How long it lasts, τ, s.
    pub duration: f64,
}

impl RaisedCosine {
    /// Its value at a time (s) since it began, 1/s.
    pub fn at(&self, time: f64) -> f64 {
        if (0.0..self.duration).contains(&time) {
            (1.0 - (TAU * time / self.duration).cos()) / self.duration
        } else {
            0.0
        }
    }

    /// Its integral up to a time (s): a smooth step from 0 to 1.
    pub fn integral(&self, time: f64) -> f64 {
        let phase = (time / self.duration).clamp(0.0, 1.0);
        phase - (TAU * phase).sin() / TAU
    }

    /// Its Laplace transform at `s` (rad/s), Re s > 0.
    pub fn transform(&self, s: Complex64) -> Complex64 {
        let rate = TAU / self.duration;
        (1.0 - (-s * self.duration).exp()) / self.duration * rate * rate
            / (s * (s * s + rate * rate))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integral_and_transform_are_those_of_the_pulse() {
        let pulse = RaisedCosine { duration: 0.3 };
        let (step, s) = (1e-4, Complex64::new(2.0, 5.0));
        let times = (0..3000).map(|index| (f64::from(index) + 0.5) * step);
        let (mut integral, mut transform) = (0.0, Complex64::new(0.0, 0.0));
        for time in times {
            integral += pulse.at(time) * step;
            transform += (-s * time).exp() * (pulse.at(time) * step);
            assert!((pulse.integral(time + 0.5 * step) - integral).abs() < 1e-6);
        }
        assert!((pulse.transform(s) - transform).norm() < 1e-6);
        assert_eq!((pulse.integral(-1.0), pulse.integral(1.0)), (0.0, 1.0));
    }
}
