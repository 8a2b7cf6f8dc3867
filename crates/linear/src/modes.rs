//! Torsional modes of a string with its surface: how fast each swings, and how fast it dies
//! away. They are the zeros of the exact string's characteristic function; where to look for
//! them, a string of a few dozen lumped inertias says.
//!
//! Damping c_t along a uniform string lets each mode decay at the rate c_t/(2ρJ):
//!
//! ```
//! use linear::modes::torsional_modes;
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.02)?;
//! let decay_rate = 0.5 * 0.02 / (7840.0 * pipe.polar_moment());
//! let modes = torsional_modes(&string, 3)?;
//! assert_eq!(modes.len(), 3);
//! for mode in modes {
//!     assert!((-mode.pole.re / decay_rate - 1.0).abs() < 1e-6);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use num_complex::Complex64;
use numerics::{Mat, eigenvalues};

use crate::controllers::reflection;
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::estimates::{
    torsional_decay_rate, torsional_drag, torsional_inertia, torsional_travel_time,
};
use crate::sites::Sites;
use crate::waves::network::TorsionNetwork;

/// A mode that swings.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TorsionalMode {
    /// The pole s, rad/s: amplitudes go as |e^(st)|, and Im s is its angular frequency.
    pub pole: Complex64,
}

impl TorsionalMode {
    /// Frequency of its oscillation, Hz.
    pub fn frequency(&self) -> f64 {
        self.pole.im / std::f64::consts::TAU
    }

    /// Damping ratio: 1 would be critical.
    pub fn damping_ratio(&self) -> f64 {
        -self.pole.re / self.pole.norm()
    }
}

/// Lumped inertias for each mode that is looked for.
const LUMPS_PER_MODE: usize = 16;

/// The least number of lumps.
const FEWEST_LUMPS: usize = 64;

/// Steps of the secant rule after which a pole is not there.
const MOST_STEPS: usize = 60;

/// The secant rule is done with a step of this part of the pole. The step after it would be
/// far smaller; a smaller one than this may never come, as stiffnesses of short tubes at low
/// frequencies leave a rounding of up to 1e-10 of the pole.
const LAST_STEP: f64 = 1e-8;

/// A mode swings where the imaginary part is at least this part of its pole.
const SWINGS: f64 = 1e-6;

/// The lowest modes that oscillate, from the slowest up, at most `most`; overdamped modes are left
/// out, and one near critical damping may be missed (of 1 in 300 random strings).
///
/// # Errors
/// Where eigenvalues cannot be found.
pub fn torsional_modes(
    string: &Drillstring,
    most: usize,
) -> Result<Vec<TorsionalMode>, BuildError> {
    let network = TorsionNetwork::new(string, &Sites::bit())?;
    let guesses = lumped_poles(string, (LUMPS_PER_MODE * most).max(FEWEST_LUMPS))?;
    let found = poles_near(&network, guesses.into_iter().take(2 * most));
    let mut poles: Vec<Complex64> = found.into_iter().flatten().collect();
    poles.retain(|pole| pole.im > SWINGS * pole.norm());
    poles.sort_by(|one, other| one.im.total_cmp(&other.im));
    poles.truncate(most);
    Ok(poles
        .into_iter()
        .map(|pole| TorsionalMode { pole })
        .collect())
}

/// The mode with damping of each natural frequency without it (rad/s, from the lowest up), of the
/// string with its surface held, with any drive; `None` where it is overdamped, or the search leads
/// to the pole of another.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn damped_modes(
    string: &Drillstring,
    frequencies: &[f64],
) -> Result<Vec<Option<TorsionalMode>>, BuildError> {
    damped(&string.clone().without_top_drive(), frequencies)
}

/// The same of a string below its drive, or its hoist, which takes a part of every wave; those of
/// natural frequencies without either's damping.
///
/// # Errors
/// As [`damped_modes`].
pub fn damped_modes_below_drive(
    string: &Drillstring,
    frequencies: &[f64],
) -> Result<Vec<Option<TorsionalMode>>, BuildError> {
    damped(string, frequencies)
}

fn damped(
    string: &Drillstring,
    frequencies: &[f64],
) -> Result<Vec<Option<TorsionalMode>>, BuildError> {
    let network = TorsionNetwork::new(string, &Sites::bit())?;
    let taken = |frequency: f64| {
        let round_trip = 2.0 * torsional_travel_time(string);
        let left = |drive| reflection(string, &drive, frequency).norm();
        string
            .top_drive()
            .map_or(0.0, |drive| -left(drive).ln() / round_trip)
    };
    let guesses: Vec<Complex64> = if string.loss().has_memory() {
        let inertia = torsional_inertia(string);
        let guess = |&frequency: &f64| slowed(string, inertia, frequency) - taken(frequency);
        frequencies.iter().map(guess).collect()
    } else {
        let decay = torsional_decay_rate(string);
        // That of a uniform string: |s| is the frequency without damping.
        let guess = |&frequency: &f64| {
            let swings = (frequency * frequency - decay * decay).max(0.0).sqrt();
            Complex64::new(-decay - taken(frequency), swings)
        };
        frequencies.iter().map(guess).collect()
    };
    let found = poles_near(&network, guesses.iter().copied());
    // Of constant damping the size is that of the frequency without it.
    let expected: Vec<f64> = if string.loss().has_memory() {
        guesses.iter().map(|it| it.norm()).collect()
    } else {
        frequencies.to_vec()
    };
    let is_its_own = |pole: &Complex64, own: f64| {
        let far = (pole.norm() - own).abs();
        let mut others = expected.iter().filter(|other| **other != own);
        pole.im > SWINGS * pole.norm() && others.all(|other| far < (pole.norm() - other).abs())
    };
    let own = expected.iter().zip(found);
    let modes = own.map(|(&own, pole)| {
        let pole = pole.filter(|pole| is_its_own(pole, own))?;
        Some(TorsionalMode { pole })
    });
    Ok(modes.collect())
}

/// About where the pole is of a natural frequency without loss (rad/s): as of a uniform string,
/// s²(1 + C/(sJ)) = −m ω², C and J those of the whole string.
fn slowed(string: &Drillstring, inertia: f64, frequency: f64) -> Complex64 {
    let mut s = Complex64::new(0.0, frequency);
    for _ in 0..GUESSED {
        let heavier = torsional_drag(string, s) / (s * inertia) + 1.0;
        let squared = string.loss().stiffening(s) / heavier;
        s = squared.sqrt() * Complex64::new(0.0, frequency);
    }
    s
}

/// Each step comes several times as close, of loss that is small.
const GUESSED: usize = 4;

/// The pole that each guess leads to.
fn poles_near(
    network: &TorsionNetwork<'_>,
    guesses: impl Iterator<Item = Complex64>,
) -> Vec<Option<Complex64>> {
    let mut poles: Vec<Complex64> = Vec::new();
    let find = |guess: Complex64| {
        // Of two poles close to one another, both guesses would find the same one: those that
        // are known, and their mirror images, are divided out.
        // Hundreds of factors overflow: each is taken in parts of about their mean, a power of two,
        // which rounds nothing.
        let factor = |s: Complex64, pole: &Complex64| (s - pole) * (s - pole.conj());
        let sizes = poles.iter().map(|pole| factor(guess, pole).norm().log2());
        let mean = sizes.sum::<f64>() / poles.len().max(1) as f64;
        let part = (-mean.round()).exp2();
        let others = |s: Complex64| {
            let known = poles.iter().map(|pole| factor(s, pole) * part);
            network.characteristic(s) / known.product::<Complex64>()
        };
        let pole = zero_near(&others, guess);
        poles.extend(pole);
        pole
    };
    guesses.map(find).collect()
}

/// A zero of a function by the secant rule.
fn zero_near(function: &impl Fn(Complex64) -> Complex64, guess: Complex64) -> Option<Complex64> {
    let (mut before, mut now) = (guess * 1.0001, guess);
    let mut at_before = function(before);
    for _ in 0..MOST_STEPS {
        let at_now = function(now);
        let step = at_now * (now - before) / (at_now - at_before);
        if !step.is_finite() {
            return (at_now.norm() == 0.0).then_some(now);
        }
        (before, at_before) = (now, at_now);
        now -= step;
        if step.norm() <= LAST_STEP * now.norm() {
            return Some(now);
        }
    }
    None
}

/// Oscillating poles of a string of equally long pieces, each with half its inertia
/// at either end, from the lowest frequency up.
fn lumped_poles(string: &Drillstring, count: usize) -> Result<Vec<Complex64>, BuildError> {
    let pieces = pieces(string, count);
    let drive = string.top_drive();
    // Nodes below the surface, and that itself where it may move.
    let first = usize::from(drive.is_none());
    let size = count + 1 - first;
    let (mut inertia, mut dashpot) = (vec![0.0; count + 1], vec![0.0; count + 1]);
    let mut stiffness = Mat::<f64>::zeros(count + 1, count + 1);
    for (index, piece) in pieces.iter().enumerate() {
        for node in [index, index + 1] {
            inertia[node] += 0.5 * piece.inertia;
            dashpot[node] += 0.5 * piece.dashpot;
            stiffness[(node, node)] += piece.spring;
        }
        stiffness[(index, index + 1)] -= piece.spring;
        stiffness[(index + 1, index)] -= piece.spring;
    }
    if let Some(drive) = drive {
        inertia[0] += drive.inertia;
        dashpot[0] += drive.proportional_gain;
        stiffness[(0, 0)] += drive.integral_gain;
    }
    // Speeds below rotations: s [θ; ω] = [0, 1; −K/J, −C/J] [θ; ω].
    let matrix = Mat::from_fn(2 * size, 2 * size, |row, column| {
        if row < size {
            return f64::from(u8::from(column == row + size));
        }
        let node = row - size + first;
        if column < size {
            -stiffness[(node, column + first)] / inertia[node]
        } else if column == row {
            -dashpot[node] / inertia[node]
        } else {
            0.0
        }
    });
    let found = eigenvalues::general(&matrix)?;
    let mut poles: Vec<Complex64> = found.into_iter().filter(|pole| pole.im > 0.0).collect();
    poles.sort_by(|one, other| one.im.total_cmp(&other.im));
    Ok(poles)
}

/// An equivalent uniform piece.
#[derive(Debug, Clone, Copy)]
struct Piece {
    inertia: f64,
    spring: f64,
    dashpot: f64,
}

/// The string in equally long pieces from the surface down, with what is in each of inertia,
/// flexibility and damping.
fn pieces(string: &Drillstring, count: usize) -> Vec<Piece> {
    let material = string.material();
    let tubes = string
        .sections()
        .iter()
        .flat_map(|section| (0..section.repeat).flat_map(|_| section.parts.iter()));
    let length = string.length() / count as f64;
    let (mut inertias, mut flexibilities) = (vec![0.0; count], vec![0.0; count]);
    let mut depth = 0.0;
    for tube in tubes {
        let section = string.section_constant(tube);
        let (top, bottom) = (depth, depth + tube.length);
        let last = ((bottom / length).ceil() as usize).min(count);
        for piece in (top / length) as usize..last {
            let from = top.max(piece as f64 * length);
            let shared = (bottom.min((piece + 1) as f64 * length) - from).max(0.0);
            inertias[piece] += material.density * section * shared;
            flexibilities[piece] += shared / (string.modulus() * section);
        }
        depth = bottom;
    }
    let piece = |(inertia, flexibility): (f64, f64)| Piece {
        inertia,
        spring: 1.0 / flexibility,
        dashpot: string.torsional_damping() * length,
    };
    inertias.into_iter().zip(flexibilities).map(piece).collect()
}
