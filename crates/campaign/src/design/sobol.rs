//! Points of Sobol's sequence, scrambled: any part of the axes' ranges has its share of them much
//! sooner than of random points, and each by itself is as random as those.
//!
//! Scrambled as by A. B. Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", *Monte
//! Carlo and Quasi-Monte Carlo Methods in Scientific Computing*, 1995, 299–317: whether a binary
//! digit of a coordinate is turned over is drawn anew for each combination of the digits before it.
//! With that the first point need not be left out (A. B. Owen, *Monte Carlo and Quasi-Monte Carlo
//! Methods* 2020, 71–86).

use super::direction_numbers::{DirectionRow, JOE_KUO};
use crate::random::{Stream, mixed};

/// Dimensions that there are direction numbers for.
pub const MOST_DIMENSIONS: usize = 1 + JOE_KUO.len();

/// Digits of the sequence itself, which has two to this power of points; and of the scrambled
/// points: as many as a double has.
const DIGITS: usize = 32;
const SCRAMBLED_DIGITS: usize = 53;

/// A scrambled sequence.
#[derive(Debug, Clone, PartialEq)]
pub struct Sobol {
    /// What each dimension is scrambled by.
    keys: Vec<u64>,
    /// Of each dimension, what each digit of a point's number adds, the lowest first.
    directions: Vec<[u32; DIGITS]>,
}

impl Sobol {
    /// That of a seed, with a number of dimensions, if there are as many.
    pub fn new(seed: u64, dimensions: usize) -> Option<Self> {
        if dimensions > MOST_DIMENSIONS {
            return None;
        }
        let key = |dimension: usize| Stream::new(seed, dimension as u64).bits();
        let rows = JOE_KUO.iter().map(directions);
        Some(Self {
            keys: (0..dimensions).map(key).collect(),
            directions: std::iter::once(van_der_corput())
                .chain(rows)
                .take(dimensions)
                .collect(),
        })
    }

    /// A point by its number: each coordinate from 0 to 1.
    pub fn point(&self, number: u32) -> Vec<f64> {
        (self.keys.iter().zip(&self.directions))
            .map(|(&key, directions)| scrambled(coordinate(directions, number), key))
            .collect()
    }
}

/// The first dimension: the digits of the number in reverse.
fn van_der_corput() -> [u32; DIGITS] {
    std::array::from_fn(|digit| 1 << (DIGITS - 1 - digit))
}

/// By the recurrence of I. M. Sobol (*USSR Computational Mathematics and Mathematical Physics*
/// 7, 1967, 86–112) from the initial ones.
fn directions(&(polynomial, initial): &DirectionRow) -> [u32; DIGITS] {
    let degree = initial.len();
    let mut directions = [0; DIGITS];
    for digit in 0..DIGITS {
        directions[digit] = match initial.get(digit) {
            Some(number) => number << (DIGITS - 1 - digit),
            None => {
                let earliest = directions[digit - degree];
                (1..degree)
                    .filter(|back| polynomial >> (degree - 1 - back) & 1 == 1)
                    .fold(earliest ^ (earliest >> degree), |sum, back| {
                        sum ^ directions[digit - back]
                    })
            }
        };
    }
    directions
}

/// The digits behind the point of a coordinate that is not scrambled.
fn coordinate(directions: &[u32; DIGITS], number: u32) -> u32 {
    let digits = directions.iter().enumerate();
    digits
        .filter(|(digit, _)| number >> digit & 1 == 1)
        .fold(0, |sum, (_, direction)| sum ^ direction)
}

fn scrambled(coordinate: u32, key: u64) -> f64 {
    let digits = u64::from(coordinate) << (SCRAMBLED_DIGITS - DIGITS);
    let turned = (0..SCRAMBLED_DIGITS).fold(0, |turned, digit| {
        // The digits before this one, behind a one: no other digit has the same.
        let before = (1 << digit) | (digits >> (SCRAMBLED_DIGITS - digit));
        let is_turned = mixed(key, before) >> 63;
        turned | is_turned << (SCRAMBLED_DIGITS - 1 - digit)
    });
    (digits ^ turned) as f64 / (1u64 << SCRAMBLED_DIGITS) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(seed: u64, dimensions: usize, count: u32) -> Vec<Vec<f64>> {
        let sobol = Sobol::new(seed, dimensions).unwrap();
        (0..count).map(|number| sobol.point(number)).collect()
    }

    /// Whether each box with sides 2^-d, the `digits` d being given, has the same number of points.
    fn is_even(points: &[Vec<f64>], digits: &[u32]) -> bool {
        let boxes = 1 << digits.iter().sum::<u32>();
        let mut counts = vec![0; boxes];
        for point in points {
            let place = point.iter().zip(digits).fold(0, |place, (part, digits)| {
                (place << digits) + (part * f64::from(1 << digits)) as usize
            });
            counts[place] += 1;
        }
        counts.iter().all(|count| count * boxes == points.len())
    }

    /// Every way to deal a number of digits to a number of dimensions.
    fn dealt(digits: u32, dimensions: usize) -> Vec<Vec<u32>> {
        if dimensions == 1 {
            return vec![vec![digits]];
        }
        let first = 0..=digits;
        let with = |first| {
            let others = dealt(digits - first, dimensions - 1);
            others
                .into_iter()
                .map(move |rest| [&[first], &rest[..]].concat())
        };
        first.flat_map(with).collect()
    }

    /// Of 2^m points from any multiple of 2^m on, every interval of length 2^-m has one, in every
    /// dimension.
    #[test]
    fn every_dimension_is_even() {
        for seed in [0, 7] {
            let all = points(seed, MOST_DIMENSIONS, 1 << 11);
            for (dimension, part) in (0..MOST_DIMENSIONS).zip([0, 1].into_iter().cycle()) {
                let some = &all[part << 10..(part + 1) << 10];
                let one = |point: &Vec<f64>| vec![point[dimension]];
                let along: Vec<Vec<f64>> = some.iter().map(one).collect();
                assert!(is_even(&along, &[10]), "{dimension}");
            }
        }
    }

    /// The first dimensions are (t, m, s)-nets with t the sum of the degrees of their
    /// polynomials less one each (H. Niederreiter, *Monatshefte für Mathematik* 104, 1987, 273–337):
    /// boxes of volume 2^(t - m) have 2^t points each, for any shape. Scrambling leaves
    /// that as it is. Two dimensions of the table are even in smaller boxes than that, and random
    /// points in none.
    #[test]
    fn the_first_dimensions_are_nets() {
        let m = 9;
        for (dimensions, t) in [(2, 0), (3, 1), (4, 3), (5, 5)] {
            for seed in [1, 2] {
                let points = points(seed, dimensions, 3 << m);
                for digits in dealt(m - t, dimensions) {
                    for part in points.chunks(1 << m) {
                        assert!(is_even(part, &digits), "{digits:?}");
                    }
                }
            }
        }
        let mut stream = Stream::new(1, 0);
        let random: Vec<Vec<f64>> = (0..1 << m)
            .map(|_| vec![stream.part(), stream.part()])
            .collect();
        assert!(dealt(m, 2).iter().all(|digits| !is_even(&random, digits)));
        let net = points(1, 2, 1 << m);
        assert!(!is_even(&net, &[m, 1]));
    }

    /// Each coordinate of each point is uniform over the seeds, and tells nothing of another's.
    #[test]
    fn a_point_is_random_over_the_seeds() {
        let seeds = 4000;
        for number in [0, 1, 6] {
            let drawn: Vec<Vec<f64>> = (0..seeds)
                .map(|seed| Sobol::new(seed, 3).unwrap().point(number))
                .collect();
            let mean = |of: &dyn Fn(&[f64]) -> f64| {
                drawn.iter().map(|point| of(point)).sum::<f64>() / seeds as f64
            };
            // Four standard errors.
            let error = 4.0 / (seeds as f64).sqrt();
            for dimension in 0..3 {
                for eighth in 1..8 {
                    let level = 0.125 * f64::from(eighth);
                    let below = mean(&|point| f64::from(u8::from(point[dimension] < level)));
                    let error = error * (level * (1.0 - level)).sqrt();
                    assert!((below - level).abs() < error, "{dimension} {level} {below}");
                }
                // Digits that the sequence itself does not have.
                let last = mean(&|point| point[dimension] * 2f64.powi(40) % 1.0);
                assert!((last - 0.5).abs() < 0.3 * error, "{last}");
                let next = (dimension + 1) % 3;
                let together = mean(&|point| (point[dimension] - 0.5) * (point[next] - 0.5));
                assert!((12.0 * together).abs() < error, "{dimension} {together}");
            }
        }
    }

    /// The root of the mean square over seeds of the error of the integral of a smooth function:
    /// with n random points it falls as n^-1/2, with these as n^-3/2 but for a power of log n
    /// (A. B. Owen, *Annals of Statistics* 25, 1997, 1541–1562).
    #[test]
    fn integrals_are_nearer_than_with_random_points() {
        // Over each coordinate, a mean of 1.
        let function = |point: &[f64]| -> f64 {
            let factors = point
                .iter()
                .map(|x| 1.0 + 0.5 * (x.exp() - 1f64.exp() + 1.0));
            factors.product()
        };
        let seeds = 30;
        let error = |count: u64, is_random: bool| -> f64 {
            let of_seed = |seed: u64| {
                let sobol = Sobol::new(seed, 4).unwrap();
                let point = |number: u64| match is_random {
                    true => {
                        let mut stream = Stream::new(seed, number);
                        (0..4).map(|_| stream.part()).collect()
                    }
                    false => sobol.point(number as u32),
                };
                let sum: f64 = (0..count).map(|number| function(&point(number))).sum();
                (sum / count as f64 - 1.0).powi(2)
            };
            ((0..seeds).map(of_seed).sum::<f64>() / seeds as f64).sqrt()
        };
        let falls = |is_random| error(128, is_random) / error(2048, is_random);
        let (random, sobol) = (falls(true), falls(false));
        assert!((2.5..6.5).contains(&random), "{random}");
        assert!(sobol > 16.0, "{sobol}");
        let nearer = error(2048, true) / error(2048, false);
        assert!(nearer > 50.0, "{nearer}");
    }

    #[test]
    fn there_are_this_many_dimensions_and_no_more() {
        assert!(Sobol::new(0, MOST_DIMENSIONS).is_some());
        assert_eq!(Sobol::new(0, MOST_DIMENSIONS + 1), None);
    }
}
