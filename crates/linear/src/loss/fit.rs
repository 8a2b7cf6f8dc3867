//! Loss with a memory as a few relaxations, for what steps in time with a variable for each: by least
//! squares on the imaginary axis, with weights that are not negative, so that the fit is as
//! passive as what it stands for (C. L. Lawson and R. J. Hanson, *Solving Least Squares
//! Problems*, 1974, chapter 23).
//!
//! The drag of mud is a sum of relaxations, one for each way in which it can stop between
//! its walls, with weights that are not negative; there are infinitely many of them, and a few whose
//! rates are spread evenly over the decades serve as well.

use num_complex::Complex64;
use numerics::{Col, Mat, equations, products};

use super::mud::Annulus;
use super::relaxation::{Relaxation, sum};
use crate::channel::Channel;

/// The frequencies that a fit serves, Hz.
const BAND: [f64; 2] = [0.01, 1000.0];

/// Relaxations of a fit: with as many, of which about 20 are not zero, drag is right to a part in 200.
pub(crate) const TERMS: usize = 24;

/// How far the rates reach beyond the band, below and above.
const BEYOND: [f64; 2] = [10.0, 8.0];

/// Frequencies at which it is compared, to each relaxation.
const PER_TERM: usize = 12;

/// A fit of c(s) by c(0) + Σ b s/(s + p).
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// c(0), exact.
    pub at_rest: f64,
    /// The rest, from the slowest on; weights are not negative.
    pub relaxations: Vec<Relaxation>,
    /// The largest error between 0.01 and 1000 Hz, as a part of |c|.
    pub error: f64,
}

impl Fit {
    /// Of the drag of mud on a tube; where it moves across, without the mass that it moves aside.
    pub(crate) fn of_drag(mud: &Annulus, channel: Channel) -> Self {
        let aside = match channel {
            Channel::Bending => mud.moved_aside(),
            Channel::Torsion | Channel::Axial => 0.0,
        };
        Self::of(mud.steady_drag(channel), |s| {
            mud.drag(channel, s) - s * aside
        })
    }

    /// Of a function that is `at_rest` at zero.
    fn of(at_rest: f64, function: impl Fn(Complex64) -> Complex64) -> Self {
        let exact: Vec<(Complex64, Complex64)> = (frequencies().into_iter())
            .map(|s| (s, function(s)))
            .collect();
        let rates = rates();
        // Real parts above imaginary ones, each in parts of the size there.
        let rows = 2 * exact.len();
        let part = |row: usize, value: Complex64| {
            let (_, size) = exact[row % exact.len()];
            let value = value / size.norm();
            if row < exact.len() {
                value.re
            } else {
                value.im
            }
        };
        let matrix = Mat::from_fn(rows, rates.len(), |row, column| {
            let (s, _) = exact[row % exact.len()];
            part(row, s / (s + rates[column]))
        });
        let wanted = Col::from_fn(rows, |row| {
            let (_, value) = exact[row % exact.len()];
            part(row, value - at_rest)
        });
        let weights = non_negative(&matrix, &wanted);
        let relaxations = (rates.iter().zip(weights))
            .filter(|(_, weight)| *weight > 0.0)
            .map(|(&rate, weight)| Relaxation { weight, rate })
            .collect();
        let mut fit = Self {
            at_rest,
            relaxations,
            error: 0.0,
        };
        let off = |(s, value): &(Complex64, Complex64)| (fit.at(*s) - value).norm() / value.norm();
        fit.error = exact.iter().map(off).fold(0.0, f64::max);
        fit
    }

    /// What it is at the Laplace variable s (rad/s).
    pub fn at(&self, s: Complex64) -> Complex64 {
        sum(&self.relaxations, s) + self.at_rest
    }
}

/// iω over the band, evenly in its logarithm.
fn frequencies() -> Vec<Complex64> {
    let count = TERMS * PER_TERM;
    let ratio = BAND[1] / BAND[0];
    let place = |index: usize| BAND[0] * ratio.powf(index as f64 / (count - 1) as f64);
    (0..count)
        .map(|index| Complex64::new(0.0, std::f64::consts::TAU * place(index)))
        .collect()
}

/// Rates of the relaxations, 1/s, evenly in their logarithm.
fn rates() -> Vec<f64> {
    let [low, high] = [BAND[0] / BEYOND[0], BAND[1] * BEYOND[1]];
    let place = |index: usize| low * (high / low).powf(index as f64 / (TERMS - 1) as f64);
    (0..TERMS)
        .map(|index| std::f64::consts::TAU * place(index))
        .collect()
}

/// The weights, none negative, with which columns come closest to what is wanted: by Lawson
/// and Hanson's active sets.
fn non_negative(matrix: &Mat<f64>, wanted: &Col<f64>) -> Vec<f64> {
    let columns = matrix.ncols();
    let mut weights = vec![0.0; columns];
    let mut used: Vec<usize> = Vec::new();
    // Each step takes one column more, or the last one; rounding may come back to a set.
    for _ in 0..3 * columns {
        let left = Col::from_fn(matrix.nrows(), |row| {
            let found: f64 = (0..columns).map(|it| matrix[(row, it)] * weights[it]).sum();
            wanted[row] - found
        });
        let gain = |column: usize| products::dot(matrix.col(column), left.as_ref());
        let next = (0..columns)
            .filter(|column| !used.contains(column))
            .map(|column| (column, gain(column)))
            .max_by(|one, other| one.1.total_cmp(&other.1));
        let Some((column, _)) = next.filter(|(_, gain)| *gain > SMALLEST_GAIN) else {
            break;
        };
        used.push(column);
        while !used.is_empty() {
            let tried = least_squares(matrix, &used, wanted);
            if tried.iter().all(|weight| *weight > 0.0) {
                weights.fill(0.0);
                used.iter()
                    .zip(tried)
                    .for_each(|(&it, weight)| weights[it] = weight);
                break;
            }
            // As far towards them as none is negative.
            let reach = (used.iter().zip(&tried))
                .filter(|(_, tried)| **tried <= 0.0)
                .map(|(&it, tried)| weights[it] / (weights[it] - tried))
                .fold(1.0, f64::min);
            for (&it, tried) in used.iter().zip(&tried) {
                weights[it] += reach * (tried - weights[it]);
            }
            used.retain(|&it| weights[it] > f64::MIN_POSITIVE);
            (0..columns)
                .filter(|it| !used.contains(it))
                .for_each(|it| weights[it] = 0.0);
        }
    }
    weights
}

/// What a column gains less than is rounding.
const SMALLEST_GAIN: f64 = 1e-12;

/// The weights of some columns, of either sign.
fn least_squares(matrix: &Mat<f64>, columns: &[usize], wanted: &Col<f64>) -> Vec<f64> {
    let chosen = Mat::from_fn(matrix.nrows(), columns.len(), |row, column| {
        matrix[(row, columns[column])]
    });
    equations::least_squares(&chosen, wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Weights that would be negative are zero, and the others then the best.
    #[test]
    fn weights_are_the_best_that_are_not_negative() {
        // By hand: of x + y = 1, x = 2, y = 0 the best has y = 0, x = 3/2.
        let matrix = Mat::from_fn(3, 2, |row, column| {
            [[1.0, 1.0], [1.0, 0.0], [0.0, 1.0]][row][column]
        });
        let wanted = Col::from_fn(3, |row| [1.0, 2.0, -0.5][row]);
        let found = non_negative(&matrix, &wanted);
        assert!(
            (found[0] - 1.5).abs() < 1e-12 && found[1] == 0.0,
            "{found:?}"
        );
    }

    #[test]
    fn a_sum_of_relaxations_is_found_again() {
        let rates = rates();
        let of = [(3, 0.7), (9, 2.0), (12, 0.01)].map(|(index, weight)| Relaxation {
            weight,
            rate: rates[index],
        });
        let fit = Fit::of(0.3, |s| sum(&of, s) + 0.3);
        assert!(fit.error < 1e-9, "{}", fit.error);
    }

    /// The drag of mud of water to a gel in annuli of any width, by relaxations with
    /// non-negative weights, at rest exactly.
    #[test]
    fn a_fit_of_mud_is_passive_and_known_to_a_part() {
        for (viscosity, hole, most) in [
            (1e-3, 0.07, 5e-3),
            (0.03, 0.108, 5e-3),
            (0.2, 0.16, 5e-3),
            (1.0, 0.108, 5e-3),
        ] {
            let annulus = Annulus {
                viscosity,
                density: 1300.0,
                inner: 0.054,
                outer: 0.0635,
                hole,
            };
            for channel in [Channel::Torsion, Channel::Bending, Channel::Axial] {
                let fit = Fit::of_drag(&annulus, channel);
                assert!(fit.error < most, "{viscosity} {channel}: {}", fit.error);
                assert!(fit.relaxations.iter().all(|it| it.weight > 0.0));
                assert_eq!(fit.at(Complex64::ZERO).re, annulus.steady_drag(channel));
            }
        }
    }
}
