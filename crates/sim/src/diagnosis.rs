//! What time histories show of the linear method behind them: chatter, growth,
//! drift. Where a bit is held fast, or whirl is steady, the motion is known, and
//! what differs from it is the method's doing.
//!
//! How the string of the crate's example feels a bit that is held fast:
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
//! # let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! use sim::Simulator;
//! use sim::diagnosis::{roughness, sticking};
//!
//! let alternating: Vec<f64> = (0..100).map(|step| 3.0 * f64::from(1 - step % 2 * 2)).collect();
//! assert_eq!(roughness(&alternating), 4.0 * 3.0);
//!
//! let simulator = Simulator::new(&responses)?;
//! let held = simulator.stuck_torque().ok_or("the bit alone is acted on")?;
//! let stiffness = linear::estimates::torsional_stiffness(&string);
//! let instant = responses.at_bit().unwrap_or_default()[0];
//! let found = sticking(held, 640.0, stiffness, instant);
//! assert!(found.chatter < 1e-6 && found.drift.abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

/// How a bit that is held fast while the surface turns feels the string.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Sticking {
    /// [`roughness`] of the held torque over the last quarter of the time, in
    /// units of the torque that would set the bit turning with the surface at
    /// once, Ω/A(0). The true torque is a straight line by then, its waves long
    /// damped.
    pub chatter: f64,
    /// The same over that of the second quarter: above one, chatter grows.
    pub growth: f64,
    /// The rate at which the torque winds up over the second half of the time,
    /// against the true one Ω k_eff, less one.
    pub drift: f64,
}

/// Analyses the torque that holds a bit, N m per rad/s of a surface that turns
/// from the first step on (see [`crate::Simulator::stuck_torque`]), for a string of
/// the given static stiffness k_eff (N m/rad) and response A(0) (rad/s per N m).
/// Values that are not finite give results that are not finite; so does a torque of fewer than four
/// steps.
pub fn sticking(
    held: &[f64],
    sampling_frequency: f64,
    stiffness: f64,
    instant_response: f64,
) -> Sticking {
    let quarter = held.len() / 4;
    let early = roughness(&held[quarter..2 * quarter]);
    let late = roughness(&held[3 * quarter..]);
    let (half_way, last) = (2 * quarter, held.len().saturating_sub(1));
    let wound_up = match held {
        [_, _, _, _, ..] => (held[half_way] - held[last]).abs(),
        _ => f64::NAN,
    };
    let truly = stiffness * (last - half_way) as f64 / sampling_frequency;
    Sticking {
        chatter: late * instant_response,
        growth: late / early,
        drift: wound_up / truly - 1.0,
    }
}

/// Mean magnitude of the second difference of a signal: nothing for a straight
/// line, four times the amplitude where it alternates from step to step.
pub fn roughness(signal: &[f64]) -> f64 {
    let second_differences = signal
        .windows(3)
        .map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
    second_differences.sum::<f64>() / (signal.len().max(3) - 2) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_wind_up_shows_nothing_and_an_alternating_one_its_chatter() {
        let line = |n: usize| -500.0 * n as f64 / 100.0;
        let smooth: Vec<f64> = (0..4000).map(line).collect();
        let found = sticking(&smooth, 100.0, 500.0, 0.1);
        assert!(found.chatter < 1e-10 && found.drift.abs() < 1e-12);
        let alternating = |n: usize| (-1f64).powi(n as i32) * 1.001f64.powi(n as i32);
        let rough: Vec<f64> = (0..4000).map(|n| line(n) + alternating(n)).collect();
        let found = sticking(&rough, 100.0, 500.0, 0.1);
        assert!(found.chatter > 1.0 && (found.growth / 7.39 - 1.0).abs() < 0.01);
    }
}
