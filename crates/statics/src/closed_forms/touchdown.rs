//! A long string that is held in the middle of its hole at the bit and lies down on the low side
//! above it.
//!
//! It lies down over a length a, with no moment at either end and a force R at touchdown. With
//! k² = P/EI
//!
//! ```text
//! R = (q/k) tan(ka/2),    R (a − sin(ka)/k)/k² − q (a²/2 − (1 − cos ka)/k²)/k² = EI c
//! ```
//!
//! and the bit bears F = qa/2 − Pc/a. Without P, a = (24 EI c/q)^¼ and F = R = qa/2. From there on
//! the wall bears q per metre.

use super::trigonometry::{cosine, root, sine_ratio, tangent_ratio};

/// Below this (ka)² the differences above lose digits, and their series are taken.
const SMALL: f64 = 0.05;

/// Where a string lies down above its bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touchdown {
    /// Distance from the bit at which it touches first, m.
    pub length: f64,
    /// Force that the bit bears, N.
    pub bit_force: f64,
    /// Force of the wall where it touches first, N.
    pub force: f64,
}

/// Where a string of a rigidity EI (N m²) lies down, under a load q (N/m) and a compression P (N,
/// tension where negative), its clearance c (m) below the bit.
///
/// ```
/// use statics::closed_forms::touchdown;
///
/// let free = touchdown(17e6, 0.054, 1600.0, 0.0);
/// assert!((free.length - (24.0 * 17e6 * 0.054 / 1600f64).powf(0.25)).abs() < 1e-9);
/// // What pulls holds it up for longer.
/// assert!(touchdown(17e6, 0.054, 1600.0, -1e5).length > free.length);
/// ```
pub fn touchdown(rigidity: f64, clearance: f64, load: f64, compression: f64) -> Touchdown {
    let square = compression / rigidity;
    let force = |a: f64| 0.5 * load * a * tangent_ratio(0.25 * square * a * a);
    // What lies lower than the clearance at touchdown, times EI.
    let beyond = |a: f64| {
        let y = square * a * a;
        let (of_force, of_load) = match y.abs() < SMALL {
            true => (
                1.0 / 6.0 - y * (1.0 / 120.0 - y * (1.0 / 5040.0 - y / 362_880.0)),
                1.0 / 24.0 - y * (1.0 / 720.0 - y * (1.0 / 40_320.0 - y / 3_628_800.0)),
            ),
            false => ((1.0 - sine_ratio(y)) / y, (0.5 - (1.0 - cosine(y)) / y) / y),
        };
        a.powi(3) * (force(a) * of_force - load * a * of_load) - rigidity * clearance
    };
    let free = (24.0 * rigidity * clearance / load).sqrt().sqrt();
    let high = match compression > 0.0 {
        // Where tan(ka/2) is infinite.
        true => std::f64::consts::PI / square.sqrt() * (1.0 - 1e-12),
        false => {
            let mut high = 2.0 * free;
            while beyond(high) < 0.0 {
                high *= 2.0;
            }
            high
        }
    };
    let length = root(0.0, high, beyond);
    Touchdown {
        length,
        bit_force: 0.5 * load * length - compression * clearance / length,
        force: force(length),
    }
}
