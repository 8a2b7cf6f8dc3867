//! Which axis decides: first-order indices of I. M. Sobol from cases as they were drawn, without a
//! special design (given data; E. Plischke, E. Borgonovo and C. L. Smith, *European Journal of
//! Operational Research* 226, 2013, 536–550).

use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, Normal};

use super::interval::Interval;
use campaign::random::Stream;

/// A binomial distribution of a larger variance is a normal one to a hundredth of its deviation,
/// and of many cases its own function is less exact.
const LARGE: f64 = 1e4;

/// Tables drawn for an interval.
const DRAWN: usize = 400;

/// The part of the variance of having a regime that is explained by the cell of one axis: of
/// each cell, how many cases of how many have it. The interval has 95 % of what other cases
/// with the same fractions would give. None where all cases are alike.
pub fn sensitivity(cells: &[[usize; 2]]) -> Option<Interval> {
    let value = index(cells)?;
    let mut drawn: Vec<f64> = (0..DRAWN)
        .filter_map(|number| {
            let mut stream = Stream::new(0, number as u64);
            let again: Vec<[usize; 2]> = cells
                .iter()
                .map(|&[count, of]| [redrawn(&mut stream, count, of), of])
                .collect();
            index(&again)
        })
        .collect();
    drawn.sort_by(f64::total_cmp);
    let at = |part: f64| drawn[((drawn.len() - 1) as f64 * part).round() as usize];
    let [low, high] = if drawn.is_empty() {
        [value; 2]
    } else {
        // Fractions that chance made unlike stay so when drawn again: what is drawn lies about
        // another value, as wide as other cases would.
        let mean = drawn.iter().sum::<f64>() / drawn.len() as f64;
        [value - (at(0.975) - mean), value + (mean - at(0.025))]
    };
    let [low, value, high] = [low, value, high].map(|it| it.clamp(0.0, 1.0));
    Some(Interval { value, low, high })
}

/// A random number of cases with the regime, out of `of`, when each has it about as often as was
/// found: zero of a few may well have been one (H. Jeffreys' mean).
fn redrawn(stream: &mut Stream, count: usize, of: usize) -> usize {
    let fraction = (count as f64 + 0.5) / (of as f64 + 1.0);
    let (mean, variance) = (
        fraction * of as f64,
        fraction * (1.0 - fraction) * of as f64,
    );
    let part = stream.part();
    let drawn = if variance > LARGE {
        let normal = Normal::new(mean, variance.sqrt()).ok();
        normal.map(|normal| normal.inverse_cdf(part).round())
    } else {
        let binomial = Binomial::new(fraction, of as u64).ok();
        binomial.map(|binomial| quantile(&binomial, part) as f64)
    };
    // The fraction is between 0 and 1, so the distribution exists.
    drawn.map_or(count, |drawn| drawn.clamp(0.0, of as f64) as usize)
}

/// The least number that so large a part of all draws does not exceed. Rounding may make the
/// distribution function fall here and there: halving, unlike the library's search, does not mind.
fn quantile(drawn: &Binomial, part: f64) -> u64 {
    let (mut low, mut high) = (0, drawn.n());
    while low < high {
        let middle = low + (high - low) / 2;
        if drawn.cdf(middle) >= part {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

/// Variance between cells over all, less what cells of few cases add by chance.
fn index(cells: &[[usize; 2]]) -> Option<f64> {
    let filled = || cells.iter().filter(|cell| cell[1] > 0);
    let all: f64 = filled().map(|cell| cell[1] as f64).sum();
    let mean = filled().map(|cell| cell[0] as f64).sum::<f64>() / all;
    let variance = mean * (1.0 - mean);
    if variance.is_nan() || variance <= 0.0 {
        return None;
    }
    let (mut between, mut by_chance) = (0.0, 0.0);
    for &[count, of] in filled() {
        let of = of as f64;
        let fraction = count as f64 / of;
        between += of / all * (fraction - mean).powi(2);
        // The variance of a mean of so few, which has its own share of the mean of all.
        if of > 1.0 {
            by_chance += (1.0 - of / all) / all * of * fraction * (1.0 - fraction) / (of - 1.0);
        }
    }
    Some((between - by_chance) / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CELLS: usize = 20;

    /// Cells of each of three axes, even between 0 and 1, of cases with a regime or not.
    fn cells(seed: u64, cases: u64, regime: impl Fn([f64; 3]) -> bool) -> [Vec<[usize; 2]>; 3] {
        let mut all = [0; 3].map(|_: i32| vec![[0; 2]; CELLS]);
        for case in 0..cases {
            let mut stream = Stream::new(seed, case);
            let point = [0.0; 3].map(|_| stream.part());
            for (cells, value) in all.iter_mut().zip(point) {
                let cell = &mut cells[(value * CELLS as f64) as usize];
                *cell = [cell[0] + usize::from(regime(point)), cell[1] + 1];
            }
        }
        all
    }

    /// x + 2 y > 1.5 in half of all cases; what of them is left for a given x or y is known, and so
    /// are the integrals of its variance.
    #[test]
    fn a_plane_has_the_indices_of_its_integrals() {
        let regime = |[x, y, _]: [f64; 3]| x + 2.0 * y > 1.5;
        let steps = 100_000;
        let variance_of = |fraction: &dyn Fn(f64) -> f64| {
            let at = |step: i32| fraction((f64::from(step) + 0.5) / f64::from(steps));
            let mean = (0..steps).map(at).sum::<f64>() / f64::from(steps);
            (0..steps)
                .map(|step| (at(step) - mean).powi(2))
                .sum::<f64>()
                / f64::from(steps)
        };
        let given_x = |x: f64| (1.0 - 0.5 * (1.5 - x)).clamp(0.0, 1.0);
        let given_y = |y: f64| (1.0 - (1.5 - 2.0 * y)).clamp(0.0, 1.0);
        let expected = [variance_of(&given_x), variance_of(&given_y), 0.0].map(|it| it / 0.25);
        let found = cells(1, 100_000, regime).map(|cells| sensitivity(&cells).unwrap());
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found.value - expected).abs() < 0.01,
                "{found:?} {expected}"
            );
        }
        // A test of the interval: how often it has the index of few cases.
        let mut held = 0;
        for seed in 0..30 {
            let found = cells(100 + seed, 600, regime).map(|cells| sensitivity(&cells).unwrap());
            let holds = |(found, expected): (&Interval, f64)| {
                found.low <= expected && expected <= found.high
            };
            held += found
                .iter()
                .zip(expected)
                .filter(|&pair| holds(pair))
                .count();
        }
        assert!(held > 81, "{held} of 90");
    }

    #[test]
    fn numbers_are_drawn_of_few_and_of_ten_million() {
        for (count, of) in [
            (1, 3),
            (30, 100),
            (0, 100_000),
            (700_000, 1_000_000),
            (2_500_000, 10_000_000),
        ] {
            let draws = 2000;
            let drawn: Vec<f64> = (0..draws)
                .map(|number| redrawn(&mut Stream::new(5, number), count, of) as f64)
                .collect();
            let p = (count as f64 + 0.5) / (of as f64 + 1.0);
            let (mean, variance) = (p * of as f64, p * (1.0 - p) * of as f64);
            let draws = draws as f64;
            let found = drawn.iter().sum::<f64>() / draws;
            assert!(
                (found - mean).abs() < 4.0 * (variance / draws).sqrt(),
                "{count} {found}"
            );
            let square = drawn.iter().map(|it| (it - mean).powi(2)).sum::<f64>() / draws;
            assert!(
                (square / variance - 1.0).abs() < 0.2,
                "{count} {square} {variance}"
            );
        }
    }

    #[test]
    fn every_number_has_its_part() {
        let drawn = Binomial::new(0.3, 4).unwrap();
        for number in 0..=4 {
            let part = drawn.cdf(number);
            assert_eq!(quantile(&drawn, part - 1e-9), number);
            assert_eq!(
                quantile(&drawn, (part + 1e-9).min(1.0)),
                (number + 1).min(4)
            );
        }
    }

    #[test]
    fn cases_that_are_alike_have_no_index() {
        assert_eq!(sensitivity(&[[3, 3], [5, 5], [0, 0]]), None);
        assert_eq!(sensitivity(&[[0, 3]]), None);
    }
}
