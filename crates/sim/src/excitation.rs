//! What disturbs the string laterally: an impulse (Section 5.2.2) and the
//! forces of eccentric masses (Section 5.2.3).
//!
//! ```
//! use sim::{EccentricMass, Impulse};
//!
//! let impulse = Impulse { site: 0, amount: 50.0, start: 1.0, duration: 0.02, direction: 0.0 };
//! let step = 1e-5;
//! let times = (0..3000).map(|index| 1.0 + step * f64::from(index));
//! let momentum: f64 = times.map(|time| step * impulse.force(time)[0]).sum();
//! assert!((momentum - 50.0).abs() < 1e-6);
//!
//! // m_e d Ω² in the middle of the hole, along the x axis.
//! let mass = EccentricMass { site: 0, mass: 10.0, offset: 0.01 };
//! let [along, across] = mass.force(0.0, 0.0, 12.0);
//! assert!((along - 14.4).abs() < 1e-12 && across == 0.0);
//! ```

use linear::RaisedCosine;

use crate::convolution::partition::FIRST_BLOCK;
use crate::convolution::{Convolution, Kernels};
use crate::sampling::Sampling;

/// A band-limited lateral impulse: a raised cosine of unit area times its
/// amount, (1 − cos 2πt/τ)/τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impulse {
    /// The site it acts on.
    pub site: usize,
    /// Its amount I, N s.
    pub amount: f64,
    /// When it begins, s.
    pub start: f64,
    /// How long it lasts, τ, s.
    pub duration: f64,
    /// Its direction from the x axis, rad.
    pub direction: f64,
}

impl Impulse {
    /// Whether it acts at no time from `from` to `to`, s.
    pub fn is_quiet(&self, from: f64, to: f64) -> bool {
        to < self.start || from >= self.start + self.duration
    }

    /// The force at a time, N.
    pub fn force(&self, time: f64) -> [f64; 2] {
        let pulse = RaisedCosine {
            duration: self.duration,
        };
        let force = self.amount * pulse.at(time - self.start);
        // At nearly all times; a direction takes as long as half a contact.
        if force == 0.0 {
            return [0.0; 2];
        }
        [force * self.direction.cos(), force * self.direction.sin()]
    }
}

/// An unbalanced mass m_e that turns with the string.
///
/// On a string that moves by r the force of its inertia is m_e (d θ̇² e^(iθ) − r̈). Where the
/// responses are of a string that carries it ([`linear::Sites::carrying`]) the second part is in them,
/// and the first alone is a force. Where they are not, its force is that of the paper, Section 5.2.3,
/// m_e (d + |r|) θ̇² e^(iθ), which is right where r is in phase with the mass: well below the string's first
/// critical speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EccentricMass {
    /// The site it is at.
    pub site: usize,
    /// Mass m_e, kg.
    pub mass: f64,
    /// Offset d from the string's centre, m.
    pub offset: f64,
}

impl EccentricMass {
    /// The force m_e (d + r) θ̇² along (cos θ, sin θ) for a string at radius r,
    /// rotation θ and rotation speed θ̇, N; that of the offset alone where r is zero.
    pub fn force(&self, radius: f64, rotation: f64, speed: f64) -> [f64; 2] {
        let force = self.mass * (self.offset + radius) * speed * speed;
        [force * rotation.cos(), force * rotation.sin()]
    }
}

/// I₀: the least impulse (N s) of the given duration that brings a site from
/// its response to a unit force in one step, `taps`, to its clearance. Infinite where no impulse
/// does; NaN where the taps or the impulse are invalid.
pub fn least_impulse(taps: &[f64], sampling: Sampling, duration: f64, clearance: f64) -> f64 {
    clearance / reach_of_impulse(taps, sampling, duration)
}

/// How far (m per N s) an impulse of the given duration moves a site that answers to a unit
/// force in one step with `taps`. NaN where the taps or the impulse are invalid.
pub fn reach_of_impulse(taps: &[f64], sampling: Sampling, duration: f64) -> f64 {
    let unit = Impulse {
        site: 0,
        amount: 1.0,
        start: 0.0,
        duration,
        direction: 0.0,
    };
    // What follows the response moves nothing.
    let steps = ((duration * sampling.frequency).ceil() as usize).min(taps.len());
    let pulse: Vec<f64> = (0..=steps)
        .map(|step| unit.force(sampling.time_of(step))[0])
        .collect();
    furthest(&pulse, taps)
}

/// The largest magnitude of the response to a series of forces.
fn furthest(pulse: &[f64], taps: &[f64]) -> f64 {
    let largest = |responses: &mut dyn Iterator<Item = f64>| {
        responses.fold(0.0, |most: f64, response| most.max(response.abs()))
    };
    if pulse.len() <= FIRST_BLOCK {
        return largest(&mut (0..taps.len()).map(|step| {
            let reach = pulse.len().min(step + 1);
            (0..reach).map(|lag| pulse[lag] * taps[step - lag]).sum()
        }));
    }
    // The sum is the same the other way round, and by blocks it is short.
    let kernels = Kernels::of(&[vec![pulse.to_vec()]]);
    let mut convolution = Convolution::new(&kernels, 1, taps.len());
    largest(&mut taps.iter().map(|&tap| {
        let mut past = [0.0];
        convolution.write_past(&mut past);
        convolution.add(&[tap]);
        past[0] + kernels.instant(0, 0) * tap
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_pulse_goes_as_far_as_its_sum_over_all_steps() {
        let taps: Vec<f64> = (0..900)
            .map(|n| (f64::from(n) * 0.07).sin() / 900.0)
            .collect();
        let pulse: Vec<f64> = (0..300).map(|n| f64::from(n * n % 17)).collect();
        let sums = (0..taps.len()).map(|step| -> f64 {
            let lags = 0..pulse.len().min(step + 1);
            lags.map(|lag| pulse[lag] * taps[step - lag]).sum()
        });
        let expected = sums.fold(0.0, |most: f64, sum| most.max(sum.abs()));
        assert!((furthest(&pulse, &taps) / expected - 1.0).abs() < 1e-12);
    }
}
