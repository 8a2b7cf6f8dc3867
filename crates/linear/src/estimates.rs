//! What can be said of a string without simulating it: static stiffness,
//! travel times, the paper's sampling frequency, and the characteristic times
//! and stability limit of stick-slip (Eqs. 72–75).
//!
//! ```
//! use linear::estimates;
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let stiffness = estimates::torsional_stiffness(&string);
//! assert!((stiffness / (80e9 * pipe.polar_moment() / 1000.0) - 1.0).abs() < 1e-12);
//!
//! let speed = 60.0 * std::f64::consts::TAU / 60.0;
//! let times = estimates::stick_slip_times(&string, speed, 1200.0, 1000.0);
//! assert!((times.first_slip * speed * stiffness / 1200.0 - 1.0).abs() < 1e-12);
//! assert!((times.slip - 2.0 * 1000.0 / string.torsional_wave_speed()).abs() < 1e-12);
//!
//! // Without damping, a front comes back from the surface as large as it went: Δ = 1/Z.
//! let undershoot = 1.0 / estimates::torsional_impedance(&string, &pipe);
//! let limit = estimates::stick_slip_speed_limit(undershoot, 1200.0, 1000.0);
//! assert_eq!(limit, 200.0 * undershoot);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use std::f64::consts::SQRT_2;

use num_complex::Complex64;

use crate::bending::Bending;
use crate::drillstring::{Drillstring, Tube};
use crate::in_mud::{self, Alike};

/// Parts of a string so near to a place, m, decide how it yields there to waves of some ten turns a second.
const NEAR: f64 = 1.0;

/// Static torsional stiffness k_eff between surface and bit, N m/rad.
pub fn torsional_stiffness(string: &Drillstring) -> f64 {
    let flexibility: f64 = string
        .tubes()
        .map(|(count, tube)| count * tube.length / string.section_constant(tube))
        .sum();
    string.modulus() / flexibility
}

/// Stiffness, N m/rad, against which a surface that is set to a steady speed winds up a
/// held bit: k_eff, in series with the integral gain of a top drive, which alone makes up
/// for a torque that grows.
pub fn winding_stiffness(string: &Drillstring) -> f64 {
    let stiffness = torsional_stiffness(string);
    let integral = (string.top_drive()).map_or(f64::INFINITY, |drive| drive.integral_gain);
    1.0 / (1.0 / stiffness + 1.0 / integral)
}

/// Characteristic torsional impedance J √(Gρ) of a tube, without damping,
/// N m s/rad.
pub fn torsional_impedance(string: &Drillstring, tube: &Tube) -> f64 {
    let material = string.material();
    string.section_constant(tube) * (string.modulus() * material.density).sqrt()
}

/// Force per displacement sideways, N/m, at a distance from the bit (m), of a string shaken there at a
/// rate (rad/s) whose waves in bending do not come back: 2√2 EI β³ with β⁴ = m ω²/EI, and at the free end
/// a quarter of that. Of the parts within a metre the most yielding counts, without the mud around it.
pub fn bending_wave_stiffness(
    string: &Drillstring,
    bending: &Bending,
    distance_from_bit: f64,
    rate: f64,
) -> f64 {
    let near = [-NEAR, 0.0, NEAR].map(|offset| string.parts_around(distance_from_bit + offset));
    let parts = near.into_iter().flatten();
    let stiffness = parts.map(|(section, part)| {
        let tube = &string.sections()[section].parts[part];
        let rigidity = bending.youngs_modulus * tube.second_moment();
        let wave_number = (string.mass_with_bore(tube) * rate * rate / rigidity).powf(0.25);
        let from_end = 3.0 * (-wave_number * distance_from_bit).exp();
        2.0 * SQRT_2 * rigidity * wave_number.powi(3) / (1.0 + from_end)
    });
    stiffness.fold(f64::INFINITY, f64::min)
}

/// Time a torsional wave takes from the surface to the bit, s.
pub fn torsional_travel_time(string: &Drillstring) -> f64 {
    string.length() / string.torsional_wave_speed()
}

/// The paper's sampling frequency (end of Section 2.4), Hz: four times the
/// first torsional mode, half a wavelength long, of one cell of the drillpipe.
/// The band then holds two of its stop-bands.
pub fn sampling_frequency(string: &Drillstring) -> f64 {
    let first_mode = string.torsional_wave_speed() / (2.0 * string.drillpipe().cell_length());
    4.0 * first_mode
}

/// Rate at which torsional vibration of the whole string decays: the damping
/// coefficient over twice the moment of inertia, 1/s. Where loss depends on frequency, that of
/// its first mode, the slowest.
pub fn torsional_decay_rate(string: &Drillstring) -> f64 {
    let inertia = torsional_inertia(string);
    if !string.loss().has_memory() {
        return string.torsional_damping() * string.length() / (2.0 * inertia);
    }
    // Mud that moves along makes it slower.
    let rate = first_mode(string).frequency;
    let bare = Complex64::new(0.0, rate);
    let moved = torsional_drag(string, bare).im / rate;
    let s = bare * (inertia / (inertia + moved)).sqrt();
    let drag = torsional_drag(string, s);
    let of_material = 0.5 * s.im * string.loss().stiffening(s).arg();
    0.5 * drag.re / (inertia + drag.im / s.im) + of_material
}

/// Torque per speed of the whole string where it turns alike everywhere, at the Laplace variable s
/// (rad/s, off the negative real axis), without that of the inertia of its tubes, N m s/rad.
pub(crate) fn torsional_drag(string: &Drillstring, s: Complex64) -> Complex64 {
    let mut drag = Complex64::from(string.torsional_damping() * string.length());
    for Alike { length, mud, .. } in in_mud::tubes(string) {
        if let Some(mud) = mud {
            drag += mud.drag(string.channel(), s) * length;
        }
    }
    drag
}

/// The same of a steady rotation.
pub fn torsional_resistance(string: &Drillstring) -> f64 {
    let mut drag = string.torsional_damping() * string.length();
    if string.loss().viscous_mud().is_some() {
        for Alike { length, mud, .. } in in_mud::tubes(string) {
            drag += mud.map_or(0.0, |mud| mud.steady_drag(string.channel()) * length);
        }
    }
    drag
}

/// No period of torsional vibration with the bit free is longer than this, s: that of all
/// the string's inertia at the end of its flexibility, and of a top drive's. It is at least
/// 2π travel times. A drive without integral gain is not held by a spring.
pub fn torsional_period(string: &Drillstring) -> f64 {
    let inertia = torsional_inertia(string);
    let of_string = inertia / torsional_stiffness(string);
    let sprung = (string.top_drive()).filter(|drive| drive.integral_gain > 0.0);
    let of_drive = sprung.map_or(0.0, |drive| (inertia + drive.inertia) / drive.integral_gain);
    std::f64::consts::TAU * (of_string + of_drive).sqrt()
}

/// How a string swings in its first torsional mode, the surface held and the bit free.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FirstMode {
    /// Natural frequency ω₁ without damping, rad/s.
    pub frequency: f64,
    /// The inertia J₁ that pulls as much on a surface that moves, at the end of a spring
    /// ω₁² J₁ (the mode's effective mass), kg m².
    pub inertia: f64,
}

/// The first mode of torsion.
pub fn first_mode(string: &Drillstring) -> FirstMode {
    // Of the surface's rotation above a bit that turns, as a function of ω², all zeros are
    // positive: from below, Newton's steps go up to the first and never past it.
    let bound = torsional_inertia(string) / torsional_stiffness(string);
    let mut square = 1.0 / bound;
    let mut at_surface = swing(string, square);
    for _ in 0..MOST_NEWTON_STEPS {
        let step = -at_surface.rotation / at_surface.change;
        square += step;
        at_surface = swing(string, square);
        if step.abs() <= 1e-14 * square {
            break;
        }
    }
    FirstMode {
        frequency: square.sqrt(),
        inertia: at_surface.torque / (square * square * at_surface.change),
    }
}

/// Far more than it takes them.
const MOST_NEWTON_STEPS: usize = 60;

/// What a free bit that swings by 1 rad makes of the surface.
struct Swing {
    /// Rotation, rad, and how it changes with ω², rad s².
    rotation: f64,
    change: f64,
    /// Torque from above, N m.
    torque: f64,
}

/// Undamped swinging at ω², from the bit upwards.
fn swing(string: &Drillstring, square: f64) -> Swing {
    let mut at = Swing {
        rotation: 1.0,
        change: 0.0,
        torque: 0.0,
    };
    let mut torque_change = 0.0;
    let (frequency, speed) = (square.sqrt(), string.torsional_wave_speed());
    for section in string.sections().iter().rev() {
        for tube in (0..section.repeat).flat_map(|_| section.parts.iter().rev()) {
            let angle = frequency * tube.length / speed;
            let (sin, cos) = angle.sin_cos();
            let stiffness = frequency * torsional_impedance(string, tube);
            let Swing {
                rotation,
                change,
                torque,
            } = at;
            let along = 0.5 / square;
            let turned = sin / stiffness;
            let turned_change = (angle * cos - sin) * along / stiffness;
            let pulled = stiffness * sin;
            let pulled_change = stiffness * (sin + angle * cos) * along;
            let cos_change = -sin * angle * along;
            at = Swing {
                rotation: rotation * cos + torque * turned,
                change: change * cos
                    + rotation * cos_change
                    + torque_change * turned
                    + torque * turned_change,
                torque: torque * cos - rotation * pulled,
            };
            torque_change = torque_change * cos + torque * cos_change
                - change * pulled
                - rotation * pulled_change;
        }
    }
    at
}

/// Periods of the slowest vibration in which an undershoot is looked for.
const UNDERSHOOT_PERIODS: f64 = 1.5;

/// The time after a step of torque, s, within which the bit swings back furthest; where
/// damping puts that off, it is by less than a hundredth of what the bit moves at once.
pub fn undershoot_time(string: &Drillstring) -> f64 {
    UNDERSHOOT_PERIODS * torsional_period(string)
}

/// Moment of inertia of the whole string about its axis, kg m².
pub fn torsional_inertia(string: &Drillstring) -> f64 {
    let moments = string
        .tubes()
        .map(|(count, tube)| count * tube.length * string.section_constant(tube));
    moments.sum::<f64>() * string.material().density
}

/// Time constant, s, in which torque that distributed damping holds back seeps
/// along the string to a free bit: 4 c_t L/(π² k_eff), or a quarter of that where
/// the bit is held. Strings of a few kilometres vibrate longer than that; longer
/// ones do not vibrate, and seeping is the slowest they do. What a top drive takes
/// ([`drive_settling_time`]) is added.
pub fn torsional_settling_time(string: &Drillstring) -> f64 {
    let squared = std::f64::consts::PI.powi(2);
    let resistance = torsional_resistance(string);
    let seeps = 4.0 * resistance / (squared * torsional_stiffness(string));
    seeps + drive_settling_time(string)
}

/// Time constant, s, in which a top drive with the whole string below it reaches its set speed;
/// zero where the surface turns as prescribed.
pub fn drive_settling_time(string: &Drillstring) -> f64 {
    let Some(drive) = string.top_drive() else {
        return 0.0;
    };
    let held_back = drive.proportional_gain + torsional_resistance(string);
    let spins_down = 2.0 * (drive.inertia + torsional_inertia(string)) / held_back;
    match drive.integral_gain {
        0.0 => spins_down,
        gain => spins_down + held_back / gain,
    }
}

/// What damping leaves of the amplitude of a torsional wave on its way from the
/// surface to the bit: exp(−Σ c_t L / 2Z) over all tubes, reflections apart. Where loss depends on
/// frequency, of one that is as slow as the first mode ([`torsional_wave_left_at`]).
pub fn torsional_wave_left(string: &Drillstring) -> f64 {
    if string.loss().has_memory() {
        let hertz = first_mode(string).frequency / std::f64::consts::TAU;
        return torsional_wave_left_at(string, hertz);
    }
    let loss: f64 = string
        .tubes()
        .map(|(count, tube)| count * tube.length / torsional_impedance(string, tube))
        .sum::<f64>()
        * string.torsional_damping();
    (-0.5 * loss).exp()
}

/// What all loss leaves of the amplitude of a torsional wave of a frequency (Hz, positive) on its
/// way from the surface to the bit: exp(−Σ L Re γ) over all tubes, reflections apart.
pub fn torsional_wave_left_at(string: &Drillstring, frequency: f64) -> f64 {
    let s = Complex64::new(0.0, std::f64::consts::TAU * frequency);
    let material = string.material();
    let modulus = string.loss().stiffening(s) * string.modulus();
    let wave = |Alike {
                    length, tube, mud, ..
                }: Alike| {
        let section = string.section_constant(&tube);
        let mud = mud.map_or(Complex64::ZERO, |mud| mud.drag(string.channel(), s));
        let drag = mud + string.torsional_damping();
        let squared = s * (s * material.density * section + drag) / (modulus * section);
        squared.sqrt().re * length
    };
    (-in_mud::tubes(string).into_iter().map(wave).sum::<f64>()).exp()
}

/// The highest frequency (Hz) at which all loss leaves a part of the amplitude of a torsional wave
/// on its way from the surface to the bit, between 0.01 Hz and 1 MHz: where loss grows with
/// frequency, what is faster does not come back.
pub fn torsional_wave_survives_to(string: &Drillstring, part: f64) -> f64 {
    let is_left = |hertz: f64| torsional_wave_left_at(string, hertz) > part;
    // By halving the interval of its logarithm.
    let [mut low, mut high] = [0.01_f64, 1e6].map(f64::ln);
    if is_left(high.exp()) {
        return high.exp();
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_left(middle.exp()) {
            low = middle;
        } else {
            high = middle;
        }
    }
    high.exp()
}

/// To a ten-thousandth of the frequency.
const HALVINGS: usize = 18;

/// Δ of Eq. 75: the largest undershoot of the step response whose taps are
/// given, in the units of the response (rad/s per N m at the bit). Where nothing comes back
/// from the surface there is none.
pub fn largest_undershoot(taps: &[f64]) -> f64 {
    let [least, most] = ends_of_step_response(taps);
    if -least > UNDERSHOOT_OF_ROUNDING * most {
        -least
    } else {
        0.0
    }
}

/// The number of taps after which the step response whose taps are given is first within a hundredth of
/// its largest undershoot; none where it has no undershoot.
pub fn taps_to_undershoot(taps: &[f64]) -> Option<usize> {
    let deep = NEARLY_DEEPEST * largest_undershoot(taps);
    let mut speed = 0.0;
    let mut reaches = taps.iter().map(|tap| {
        speed += tap;
        speed <= -deep
    });
    (deep > 0.0).then(|| reaches.position(|it| it)).flatten()
}

/// The part of the largest undershoot that is as good as all of it.
const NEARLY_DEEPEST: f64 = 0.99;

/// The most that a step of torque makes of the bit's speed, in the units of the response.
pub fn largest_response(taps: &[f64]) -> f64 {
    ends_of_step_response(taps)[1].max(0.0)
}

fn ends_of_step_response(taps: &[f64]) -> [f64; 2] {
    let (mut speed, mut least, mut most) = (0.0f64, f64::INFINITY, f64::NEG_INFINITY);
    for tap in taps {
        speed += tap;
        (least, most) = (least.min(speed), most.max(speed));
    }
    [least, most]
}

/// What taps that are cut off, and rounding, leave of a step response in the end, as a part of
/// its peak.
const UNDERSHOOT_OF_ROUNDING: f64 = 1e-6;

/// The time scales of stick-slip, s.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StickSlipTimes {
    /// τ₁ (Eq. 72): from rest until the torque has wound up to T_s.
    pub first_slip: f64,
    /// τ₂: a torsional wave from the bit to the surface and back.
    pub slip: f64,
    /// τ₃ (Eq. 73): from T_d to T_s at the steady rate of winding.
    pub stick: f64,
}

/// The time scales of stick-slip at a steady surface speed (rad/s) for a bit
/// with the given static and dynamic torques (N m).
pub fn stick_slip_times(
    string: &Drillstring,
    surface_speed: f64,
    torque_static: f64,
    torque_dynamic: f64,
) -> StickSlipTimes {
    let winding_rate = surface_speed * winding_stiffness(string);
    StickSlipTimes {
        first_slip: torque_static / winding_rate,
        slip: 2.0 * torsional_travel_time(string),
        stick: (torque_static - torque_dynamic) / winding_rate,
    }
}

/// Surface speed below which a bit that turns evenly sticks again when its torque drops once from
/// static to dynamic (Eq. 74), rad/s: an estimate of where stick-slip is.
pub fn stick_slip_speed_limit(undershoot: f64, torque_static: f64, torque_dynamic: f64) -> f64 {
    (torque_static - torque_dynamic) * undershoot
}
