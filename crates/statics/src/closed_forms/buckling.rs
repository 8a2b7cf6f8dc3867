//! Buckling of a string on the low side of a straight hole, sideways: EI y⁗ + P y″ + (q/c) y = 0
//! (R. Dawson and P. R. Paslay, "Drill pipe buckling in inclined holes", *Journal of Petroleum
//! Technology* 36, 1984, 1734–1740).

use std::f64::consts::PI;

/// P under which a long string that lies on the low side along all its length snakes, N: 2 √(EI q/c),
/// by EI (N m²), q (N/m) and c (m). Necessary and sufficient without friction. Where it touches at
/// places alone, the wall holds it less: by half if there is one to a half wave, to a part in a
/// hundred if there are two.
///
/// ```
/// use statics::closed_forms::buckling::{of_lying_string, half_wave};
///
/// let force = of_lying_string(17e6, 1600.0, 0.054);
/// let span = std::f64::consts::PI / half_wave(17e6, 1600.0, 0.054);
/// let balance = 17e6 * span.powi(4) - force * span.powi(2) + 1600.0 / 0.054;
/// assert!(balance.abs() < 1e-6);
/// ```
pub fn of_lying_string(rigidity: f64, load: f64, clearance: f64) -> f64 {
    2.0 * (rigidity * load / clearance).sqrt()
}

/// Length of half a wave of that, m.
pub fn half_wave(rigidity: f64, load: f64, clearance: f64) -> f64 {
    PI * (rigidity * clearance / load).sqrt().sqrt()
}

/// The same force of a length (m) between pinned ends, N: never less than that of a long one.
///
/// ```
/// use statics::closed_forms::buckling::{half_wave, of_length, of_lying_string};
///
/// let long = of_lying_string(17e6, 1600.0, 0.054);
/// let length = 3.0 * half_wave(17e6, 1600.0, 0.054);
/// assert!((of_length(17e6, 1600.0, 0.054, length) / long - 1.0).abs() < 1e-12);
/// ```
pub fn of_length(rigidity: f64, load: f64, clearance: f64, length: f64) -> f64 {
    let of_waves = |count: f64| {
        let square = (count * PI / length).powi(2);
        rigidity * square + load / (clearance * square)
    };
    let waves = length / half_wave(rigidity, load, clearance);
    of_waves(waves.floor().max(1.0)).min(of_waves(waves.ceil().max(1.0)))
}
