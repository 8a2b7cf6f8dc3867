//! Where a regime begins along one quantity.

/// Halvings of the bracket: it is a few parts in a million wide in the end.
const HALVINGS: usize = 17;

/// The value between `low` and `high` at which `is_beyond` becomes true; `None`
/// where it is so from the start or never.
pub fn limit_between(
    low: f64,
    high: f64,
    mut is_beyond: impl FnMut(f64) -> Option<bool>,
) -> Option<f64> {
    let (mut low, mut high) = (low, high);
    if is_beyond(low)? || !is_beyond(high)? {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_beyond(middle)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (low + high))
}

/// The limit of a sequence of the given order from its values at two neighbouring
/// frequencies, the second twice the first.
pub fn extrapolated(coarse: f64, fine: f64, order: i32) -> f64 {
    fine + (fine - coarse) / (2f64.powi(order) - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_found_between_two_regimes_only() {
        let found = limit_between(1.0, 3.0, |x| Some(x > 2.2)).unwrap();
        assert!((found - 2.2).abs() < 1e-4);
        assert_eq!(limit_between(1.0, 2.0, |x| Some(x > 2.2)), None);
        assert_eq!(limit_between(2.5, 3.0, |x| Some(x > 2.2)), None);
    }

    #[test]
    fn extrapolation_removes_the_leading_error() {
        let value = |h: f64| 5.0 + 3.0 * h * h;
        assert!((extrapolated(value(0.2), value(0.1), 2) - 5.0).abs() < 1e-12);
    }
}
