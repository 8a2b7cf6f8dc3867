//! A passive load that looks for energy in the string: an oscillator without loss, attached to the
//! sites, tuned, and released.
//!
//! A string whose responses are positive-real takes energy from it, always. One
//! that is not gives it energy, and for ever more of it, if the oscillator is
//! tuned to a frequency at which the real part of the response is negative. So
//! it shows in time what the positive-real margin ([`linear::passivity`]) says
//! of all frequencies: not every scene finds that load, but some load there is.
//!
//! The plain inverse transform gives energy to such a load, convolution quadrature takes it:
//!
//! ```
//! # use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//! # let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! # let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! # let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! # let request = Request {
//! #     sites: Sites::bit(),
//! #     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//! #     sampling_frequency: 640.0,
//! #     longest_time: 20.0,
//! # };
//! # let request = Request { sampling_frequency: 50.0, longest_time: 5.0, ..request };
//! use linear::method::Transform;
//! use sim::oscillator::worst_load_gain;
//!
//! let gain = |method: Method| -> Result<f64, Box<dyn std::error::Error>> {
//!     let responses = linear::responses(&string, &method, &request)?;
//!     let torsion = responses.torsion().ok_or("torsion was asked for")?;
//!     Ok(worst_load_gain(&torsion.driving_points())?)
//! };
//! let rounding = -linear::passivity::STABLE_MARGIN;
//! assert!(gain(Method::Quadrature)? < rounding);
//! assert!(gain(Method::DirectIdft(Transform::default()))? > rounding);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use linear::passivity::{Ending, worst_point};
use linear::{BuildError, ResponseError};

use crate::convolution::{Convolution, Kernels};

/// Steps that the oscillator is followed, in lengths of the response.
const RESPONSE_LENGTHS: usize = 128;

/// No oscillator is followed longer, in steps.
const MOST_STEPS: usize = 1 << 22;

/// The energy gain, in units of the largest A(0), of an oscillator attached to the sites
/// with the responses `taps[output][input]`, tuned to where these are furthest from
/// positive-real and distributed as they are weakest. Where the margin is right, that
/// is its negative.
///
/// # Errors
/// Where there are not equally many finite taps from every site to every site.
pub fn worst_load_gain(taps: &[Vec<&[f64]>]) -> Result<f64, BuildError> {
    if taps.iter().any(|inputs| inputs.len() != taps.len()) {
        return Err(ResponseError::Shape.into());
    }
    let worst = worst_point(taps.len(), Ending::Whole, |output, input| {
        taps[output][input]
    })?;
    let mut combined = vec![0.0; taps[0][0].len()];
    for (output, inputs) in taps.iter().enumerate() {
        for (input, taps) in inputs.iter().enumerate() {
            let factor = worst.direction[output] * worst.direction[input];
            for (sum, tap) in combined.iter_mut().zip(*taps) {
                *sum += factor * tap;
            }
        }
    }
    let largest = (0..taps.len()).map(|site| taps[site][site][0]);
    let scale = combined[0] / largest.fold(0.0, f64::max);
    Ok(scale * energy_gained(&combined, worst.angle))
}

/// What an oscillator at `angle` (rad per step) gains from a string at rest with
/// the driving-point response `taps`: over the second half of the time, when the
/// waves of its start have died away, the mean resistance that it met, negated,
/// in units of A(0). Above zero, energy is gained: minus the real part of the
/// response at that frequency.
///
/// Its state x turns by `angle` in each step and is pushed by the site's speed,
/// x ← (x + v) exp(i angle), its torque is −κ (Re x + v/2), and it holds ½κ|x|²:
/// in each step exactly as much more as the string gives, −T v. A weak κ leaves
/// it at its frequency.
fn energy_gained(taps: &[f64], angle: f64) -> f64 {
    let steps = (RESPONSE_LENGTHS * taps.len().max(2)).min(MOST_STEPS);
    let kernels = Kernels::of(&[vec![taps.to_vec()]]);
    let compliance = kernels.instant(0, 0);
    let (sine, cosine) = angle.sin_cos();
    // At the ends of the band x has one direction only, and is pushed twice as
    // much.
    let pushes = if sine.abs() < 1.0 / steps as f64 {
        2.0
    } else {
        1.0
    };
    // Met by a resistance A(0), half of the time takes a factor e.
    let stiffness = 2.0 / (pushes * compliance * steps as f64);
    let (mut real, mut imaginary) = (1.0, 0.0);
    let mut half_way = 0.0;
    let mut torques = Convolution::new(&kernels, 1, steps);
    for step in 0..steps {
        if step == steps / 2 {
            half_way = f64::ln(real * real + imaginary * imaginary);
        }
        let mut past = [0.0];
        torques.write_past(&mut past);
        // The load line speed = past + A(0) torque, met by the oscillator.
        let torque = -stiffness * (real + 0.5 * past[0]) / (1.0 + 0.5 * stiffness * compliance);
        let pushed = real + past[0] + compliance * torque;
        (real, imaginary) = (
            pushed * cosine - imaginary * sine,
            pushed * sine + imaginary * cosine,
        );
        torques.add(&[torque]);
    }
    f64::ln(real * real + imaginary * imaginary) - half_way
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Re 1/(1 − ζ/2) at ζ = −i is 0.8.
    #[test]
    fn a_passive_response_takes_what_its_real_part_says() {
        let lag: Vec<f64> = (0..64).map(|n| 0.5f64.powi(n)).collect();
        let gained = energy_gained(&lag, std::f64::consts::FRAC_PI_2);
        assert!((gained + 0.8).abs() < 0.01, "{gained}");
    }

    /// Re (1 + 2ζ³) at ζ = 1 is 3, at ζ = −1 it is −1.
    #[test]
    fn a_delay_that_is_too_strong_gives_energy_where_its_real_part_is_negative() {
        let delayed: Vec<f64> = (0..64)
            .map(|n| [1.0, 0.0, 0.0, 2.0].get(n).copied().unwrap_or(0.0))
            .collect();
        assert!(energy_gained(&delayed, std::f64::consts::FRAC_PI_3) > 0.5);
        assert!(energy_gained(&delayed, 0.5) < 0.0);
    }
}
