//! How far a string climbs that turns on the low side at a speed that does not change, and when it
//! rolls all round: a disc of mass m per metre with a load q = mG, at an angle φ from the low side in
//! the direction of climb, pressed on with N = m(G cos φ + c φ′²).
//!
//! ```text
//! sliding:   c φ″ = −G sin φ + μ (G cos φ + c φ′²)                steady at tan φ = μ
//!            z = φ′² = A e^(2μφ) + (2G/c)/(1 + 4μ²) [(1 − 2μ²) cos φ + 3μ sin φ]
//! rolling:   φ′ = RΩ/c, while |sin φ| ≤ μ (cos φ + λ)             λ = R²Ω²/(cG)
//! ```
//!
//! Contact at the top of the hole needs c φ′² ≥ G, so that λ ≥ 1 is necessary for whirl all round,
//! and not sufficient.

use std::f64::consts::{PI, TAU};

use super::trigonometry::root;

/// Angles compared in a turn.
const ANGLES: usize = 20_000;

/// c/G times φ′² of a disc that slides, per unit of e^(2μφ), and the rest.
fn particular(friction: f64, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let squared = friction * friction;
    2.0 / (1.0 + 4.0 * squared) * ((1.0 - 2.0 * squared) * cos + 3.0 * friction * sin)
}

/// c/G times φ′² at an angle, of a disc that slides since it had a square of the speed at another.
fn sliding(friction: f64, (from, square): (f64, f64), angle: f64) -> f64 {
    let grown = (2.0 * friction * (angle - from)).exp();
    (square - particular(friction, from)) * grown + particular(friction, angle)
}

/// The angle of steady climb, rad: necessary and sufficient for balance.
///
/// ```
/// assert_eq!(statics::closed_forms::climb::steady_angle(1.0), std::f64::consts::FRAC_PI_4);
/// ```
pub fn steady_angle(friction: f64) -> f64 {
    friction.atan()
}

/// The greatest angle of a disc that is let go at the low side, turning so fast that it slides
/// all the way, rad: more than twice the steady angle, for ever, without damping. None where it
/// does not turn back before it has lost contact or gone round.
///
/// ```
/// use statics::closed_forms::climb::greatest_angle;
///
/// assert!((greatest_angle(0.3).unwrap().to_degrees() - 35.622).abs() < 1e-3);
/// assert_eq!(greatest_angle(0.8), None);
/// ```
pub fn greatest_angle(friction: f64) -> Option<f64> {
    let square = |angle: f64| sliding(friction, (0.0, 0.0), angle);
    let angle = |step: usize| TAU * step as f64 / ANGLES as f64;
    // From the steady angle on it slows down.
    let steady = steady_angle(friction);
    let after = (0..ANGLES).map(angle).filter(|it| *it > steady);
    let end = after.into_iter().find(|it| {
        let lost_contact = it.cos() + square(*it) < 0.0;
        square(*it) <= 0.0 || lost_contact
    })?;
    (square(end) <= 0.0).then(|| root(steady, end, |it| -square(it)))
}

/// The least friction with which a disc goes round that is let go at the low side, however fast it
/// turns: necessary and, at a high enough speed, sufficient.
///
/// ```
/// let friction = statics::closed_forms::climb::least_friction_to_go_round_from_rest();
/// assert!((friction - 0.713_089).abs() < 1e-5);
/// ```
pub fn least_friction_to_go_round_from_rest() -> f64 {
    root(0.1, 2.0, |friction| {
        goes_round(friction, (0.0, 0.0), f64::INFINITY)
    })
}

/// λ from which a disc that rolls at the low side rolls all round without slip: sufficient.
///
/// ```
/// assert!((statics::closed_forms::climb::rolls_all_round(0.3) - 3.480_102).abs() < 1e-6);
/// ```
pub fn rolls_all_round(friction: f64) -> f64 {
    friction.hypot(1.0) / friction
}

/// λ from which a disc that rolls at the low side goes all round, slipping on its way up: necessary
/// to stay in contact, and sufficient where nothing takes its energy.
///
/// ```
/// assert!((statics::closed_forms::climb::goes_round_once_rolling(0.3) - 2.377).abs() < 1e-3);
/// ```
pub fn goes_round_once_rolling(friction: f64) -> f64 {
    let rolls = rolls_all_round(friction);
    root(1.0, rolls, |ratio| {
        // It slips from where friction no longer drives it up.
        let holds = |angle: f64| angle.sin() - friction * (angle.cos() + ratio);
        let most = PI - friction.recip().atan();
        if holds(most) <= 0.0 {
            return 1.0;
        }
        let slips = root(0.0, most, holds);
        goes_round(friction, (slips, ratio), ratio)
    })
}

/// Above zero where a disc that slides from an angle, with a square of the speed there, stays in
/// contact until it rolls with another, or is round: the least of z and N on the way.
fn goes_round(friction: f64, from: (f64, f64), rolling: f64) -> f64 {
    let mut least = f64::INFINITY;
    for step in 1..ANGLES {
        let angle = from.0 + (TAU - from.0) * step as f64 / ANGLES as f64;
        let square = sliding(friction, from, angle);
        least = least.min(square).min(angle.cos() + square);
        if least < 0.0 || (square >= rolling && angle > PI) {
            break;
        }
    }
    least
}

/// Speed of rotation Ω, rad/s, of a λ, by the clearance c and the radius R of the string (m), and
/// G, its load by its mass (m/s²).
///
/// ```
/// use statics::closed_forms::climb::rotation_speed;
///
/// let speed = rotation_speed(1.0, 0.054, 0.1016, 4.94);
/// assert!((speed - (4.94_f64 / 0.054).sqrt() * 0.054 / 0.1016).abs() < 1e-12);
/// ```
pub fn rotation_speed(ratio: f64, clearance: f64, radius: f64, acceleration: f64) -> f64 {
    (ratio * clearance * acceleration).sqrt() / radius
}
