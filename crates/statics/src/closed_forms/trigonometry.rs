//! Functions of the square of an angle: below zero those of the hyperbola, as tension takes the
//! place of compression.

/// cos √z.
pub(super) fn cosine(square: f64) -> f64 {
    match square >= 0.0 {
        true => square.sqrt().cos(),
        false => (-square).sqrt().cosh(),
    }
}

/// sin √z/√z.
pub(super) fn sine_ratio(square: f64) -> f64 {
    let root = square.abs().sqrt();
    match root {
        small if small < 1e-4 => 1.0 - square / 6.0,
        _ if square > 0.0 => root.sin() / root,
        _ => root.sinh() / root,
    }
}

/// tan √z/√z.
pub(super) fn tangent_ratio(square: f64) -> f64 {
    sine_ratio(square) / cosine(square)
}

/// Where a function that rises through zero between two numbers is zero.
pub(super) fn root(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if of(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}
