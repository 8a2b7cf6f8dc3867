//! Where a regime changes along one quantity.

/// A limit, and by how much it may be off, in parts of itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Truth {
    /// Surface speed in rpm, or coefficient of friction.
    pub limit: f64,
    /// Part of one.
    pub uncertainty: f64,
}

/// The mean that a bracket of plain numbers is halved by.
fn arithmetic(one: f64, other: f64) -> f64 {
    0.5 * (one + other)
}

/// The mean that a bracket of factors is halved by.
pub fn geometric(one: f64, other: f64) -> f64 {
    (one * other).sqrt()
}

/// The place in a bracket where a regime changes, after some halvings; `inside` says
/// whether its first end is within the regime, and its second end is the other way.
/// `None` where a case on the way has no answer.
pub fn bisected(
    [mut first, mut second]: [f64; 2],
    inside: bool,
    halvings: usize,
    mean: fn(f64, f64) -> f64,
    is_inside: impl Fn(f64) -> Option<bool>,
) -> Option<f64> {
    for _ in 0..halvings {
        let middle = mean(first, second);
        if is_inside(middle)? == inside {
            first = middle;
        } else {
            second = middle;
        }
    }
    Some(mean(first, second))
}

/// Halvings of a bracket of plain numbers: it is a few parts in a million wide in the
/// end.
const HALVINGS: usize = 17;

/// The value in a bracket at which `is_beyond` becomes true; `None` where it is so from
/// the start or never.
pub fn limit_between(
    [low, high]: [f64; 2],
    is_beyond: impl Fn(f64) -> Option<bool>,
) -> Option<f64> {
    if is_beyond(low)? || !is_beyond(high)? {
        return None;
    }
    bisected([low, high], false, HALVINGS, arithmetic, is_beyond)
}

/// A limit near a place is looked for within this factor of it,
pub const WITHIN: f64 = 1.6;

/// from this part of it outwards.
const NEAREST: f64 = 0.005;

/// The limit nearest to a place, within [`WITHIN`]; `between` gives the one in a bracket, where its
/// ends differ.
pub fn nearest(place: f64, between: impl Fn([f64; 2]) -> Option<f64>) -> Option<f64> {
    (0..)
        .map(|doubled| NEAREST * 2f64.powi(doubled))
        .take_while(|distance| *distance < 2.0 * WITHIN.ln())
        .find_map(|distance| {
            let factor = distance.min(WITHIN.ln()).exp();
            between([place / factor, place * factor])
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_found_between_two_regimes_only() {
        let found = |bracket| limit_between(bracket, |x| Some(x > 2.2));
        assert!((found([1.0, 3.0]).unwrap() - 2.2).abs() < 1e-4);
        assert_eq!(found([1.0, 2.0]), None);
        assert_eq!(found([2.5, 3.0]), None);
    }

    #[test]
    fn a_bracket_is_halved_from_above_too() {
        let found = bisected([3.0, 1.0], true, HALVINGS, geometric, |x| Some(x > 2.2));
        assert!((found.unwrap() - 2.2).abs() < 1e-4);
    }
}
