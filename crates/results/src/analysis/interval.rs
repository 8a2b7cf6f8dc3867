//! How sure a fraction is.

/// Standard deviations on either side of a normal distribution that have 95 % of it between them.
const DEVIATIONS: f64 = 1.959_963_984_540_054;

/// A fraction with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// What was found.
    pub value: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// How many more cases than there are it takes for an interval no wider than `width`, if the
/// fraction stays what it is.
pub fn more_cases(fraction: f64, of: usize, width: f64) -> usize {
    cases_for(fraction, width).saturating_sub(of)
}

/// The fraction of a count of all, with the interval of E. B. Wilson (*Journal of the American
/// Statistical Association* 22, 1927, 209–212), which holds near 0 and 1 and for few, too; without
/// cases there is no fraction.
pub fn wilson(count: usize, of: usize) -> Option<Interval> {
    if of == 0 {
        return None;
    }
    let value = count as f64 / of as f64;
    let [low, high] = around(value, of as f64);
    Some(Interval { value, low, high })
}

fn around(fraction: f64, of: f64) -> [f64; 2] {
    let square = DEVIATIONS * DEVIATIONS;
    let centre = fraction + 0.5 * square / of;
    let spread = (fraction * (1.0 - fraction) / of + 0.25 * square / (of * of)).sqrt();
    let scale = 1.0 + square / of;
    [-1.0, 1.0].map(|sign| ((centre + sign * DEVIATIONS * spread) / scale).clamp(0.0, 1.0))
}

/// How many cases it takes for an interval no wider than `width`, if the fraction stays what it is.
fn cases_for(fraction: f64, width: f64) -> usize {
    let is_enough = |of: usize| {
        let [low, high] = around(fraction, of as f64);
        high - low <= width
    };
    let mut most = 1;
    while !is_enough(most) {
        most *= 2;
    }
    let mut least = most / 2;
    while most - least > 1 {
        let middle = least + (most - least) / 2;
        if is_enough(middle) {
            most = middle;
        } else {
            least = middle;
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;
    use campaign::random::Stream;

    /// By R. G. Newcombe, *Statistics in Medicine* 17, 1998, 857–872, Table I.
    #[test]
    fn intervals_are_those_of_the_literature() {
        for (count, of, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let found = wilson(count, of).unwrap();
            assert!((found.low - low).abs() < 5e-5, "{found:?}");
            assert!((found.high - high).abs() < 5e-5, "{found:?}");
        }
        assert_eq!(wilson(0, 0), None);
    }

    #[test]
    fn about_nineteen_of_twenty_intervals_hold() {
        for fraction in [0.02, 0.3, 0.9] {
            let holds = |number: &u64| {
                let mut stream = Stream::new(1, *number);
                let count = (0..200).filter(|_| stream.part() < fraction).count();
                let found = wilson(count, 200).unwrap();
                found.low <= fraction && fraction <= found.high
            };
            let held = (0..2000).filter(holds).count();
            assert!((1850..1970).contains(&held), "{fraction}: {held} of 2000");
        }
    }

    #[test]
    fn this_number_of_cases_is_enough_and_one_less_is_not() {
        for (fraction, width) in [(0.5, 0.02), (0.01, 0.01), (0.0, 0.001), (0.37, 0.5)] {
            let of = cases_for(fraction, width);
            let wide = |of: usize| {
                let [low, high] = around(fraction, of as f64);
                high - low
            };
            assert!(wide(of) <= width && wide(of - 1) > width, "{of}");
        }
    }
}
