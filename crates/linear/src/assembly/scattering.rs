//! Pieces of string between nodes by the waves that they send back, instead of by stiffness.
//!
//! To a port where the string is met with the torque f and turns at v, an impedance Z ascribes
//! the wave a = (f + Z v)/2 that goes in and b = (Z v − f)/2 that comes out: a matched line of
//! that impedance sends nothing back. What comes out of a piece follows from what goes in,
//! b = S a with S = (Z + D)⁻¹ (Z − D) where f = D v, and passivity is |S| ≤ 1.

use super::number::Number;
use super::torsion::{Drive, DynamicStiffness};

/// A piece of string between two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Scattered<T> {
    /// Reflection at its top.
    pub top: T,
    /// What comes out at the other end, whichever it goes in at.
    pub across: T,
    /// Reflection at its bottom.
    pub bottom: T,
}

/// The string above the uppermost node, up to a surface that is set to a speed, its drive
/// included. Waves are at the node.
#[derive(Debug, Clone, Copy)]
pub struct Uppermost<T> {
    /// Its reflection.
    pub reflection: T,
    /// The wave that comes down per set speed.
    pub sent: T,
    /// Torque with which the surface is turned, of a drive its motor's, per set speed.
    pub torque_by_set: T,
    /// The same per wave that goes up.
    pub torque_by_wave: T,
    /// Speed of the surface per set speed, and per wave that goes up.
    pub speed_by_set: T,
    /// The same per wave that goes up.
    pub speed_by_wave: T,
}

impl<T: Number> DynamicStiffness<T> {
    /// Torques per speed, of a piece whose torques are per motion at a `rate` of speed per motion.
    pub fn per_speed(self, rate: T) -> Self {
        let per_rate = rate.inverse();
        Self {
            top: self.top * per_rate,
            cross: self.cross * per_rate,
            bottom: self.bottom * per_rate,
        }
    }

    /// The waves of a piece, its torques per speed.
    pub fn scattered(self, impedance: f64) -> Scattered<T> {
        let Self { top, cross, bottom } = self;
        let squared = cross * cross;
        let scale = ((top + impedance) * (bottom + impedance) - squared).inverse();
        Scattered {
            top: ((-top + impedance) * (bottom + impedance) + squared) * scale,
            across: cross * scale * (-2.0 * impedance),
            bottom: ((top + impedance) * (-bottom + impedance) + squared) * scale,
        }
    }
}

/// What ends the string at a node, opposing this torque per speed there: the wave it sends back.
pub fn reflection<T: Number>(opposes: T, impedance: f64) -> T {
    (-opposes + impedance) * (opposes + impedance).inverse()
}

/// The piece above the uppermost node, all of it and of its drive per speed.
pub fn uppermost<T: Number>(
    piece: DynamicStiffness<T>,
    drive: Option<Drive<T>>,
    impedance: f64,
) -> Uppermost<T> {
    let DynamicStiffness { top, cross, bottom } = piece;
    let Some(Drive {
        holds,
        opposes,
        motor,
    }) = drive
    else {
        // The surface turns as it is set to.
        let passes = (bottom + impedance).inverse();
        return Uppermost {
            reflection: reflection(bottom, impedance),
            sent: cross * passes * -impedance,
            torque_by_set: top - cross * cross * passes,
            torque_by_wave: cross * passes * 2.0,
            speed_by_set: T::real(1.0),
            speed_by_wave: T::zero(),
        };
    };
    let gives = (opposes + top).inverse();
    let below = bottom - cross * cross * gives;
    let pull = cross * holds * gives;
    // What the motor gives to the motion below is late where its controller is.
    let given = cross * motor * gives;
    let passes = (below + impedance).inverse();
    Uppermost {
        reflection: reflection(below, impedance),
        sent: pull * passes * -impedance,
        torque_by_set: holds * (top + opposes - motor) * gives - pull * given * passes,
        torque_by_wave: given * passes * 2.0,
        speed_by_set: (holds + cross * pull * passes) * gives,
        speed_by_wave: cross * gives * passes * -2.0,
    }
}
