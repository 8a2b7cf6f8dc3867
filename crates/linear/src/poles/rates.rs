//! The poles of what is projected, and what forces that are held over steps make of them.

use num_complex::Complex64;
use numerics::{Mat, eigenvalues, equations, products};

use super::BendingPoles;
use super::passive::{Speeds, least_margin};
use super::projection::Projected;
use crate::error::BuildError;
use crate::passivity::STABLE_MARGIN;

/// Speed, as a part of the greatest within a step, of a string that is pushed and not held, in the end:
/// below it is rounding.
const LEAST_DRIFT: f64 = 1e-9;

/// Poles in continuous time.
pub(super) struct Rates {
    sites: usize,
    /// λ, 1/s: of two that are conjugate that above the real axis.
    rates: Vec<Complex64>,
    /// How fast each site, and what is seen besides, moves by each pole (row by row), of conjugate poles both;
    moves: Mat<Complex64>,
    /// and what a force at it excites (column by column).
    excited: Mat<Complex64>,
}

impl Rates {
    /// The poles of what is projected.
    pub(super) fn of(projected: &Projected) -> Result<Self, BuildError> {
        let sites = projected.by_force.ncols();
        let (rates, vectors) = eigenvalues::general_with_vectors(&projected.system)?;
        let [by_force, seen] = [&projected.by_force, &projected.seen].map(|it| {
            Mat::from_fn(it.nrows(), it.ncols(), |row, column| {
                Complex64::from(it[(row, column)])
            })
        });
        let excited = equations::solve_complex(&vectors, &by_force);
        let [moves, seen] =
            [by_force, seen].map(|it| products::product_complex(it.transpose(), vectors.as_ref()));
        let kept: Vec<(usize, f64)> = (rates.iter().enumerate())
            .filter(|(_, rate)| rate.im >= 0.0)
            .map(|(place, rate)| (place, if rate.im > 0.0 { 2.0 } else { 1.0 }))
            .collect();
        Ok(Self {
            sites,
            rates: kept.iter().map(|(place, _)| rates[*place]).collect(),
            moves: Mat::from_fn(sites + seen.nrows(), kept.len(), |output, pole| {
                let (place, both) = kept[pole];
                let moves = match output.checked_sub(sites) {
                    None => moves[(output, place)],
                    Some(output) => seen[(output, place)],
                };
                moves * both
            }),
            excited: Mat::from_fn(kept.len(), sites, |pole, site| {
                excited[(kept[pole].0, site)]
            }),
        })
    }

    /// Over all poles: what a weight of each makes at an output of a force at a site, row by row.
    fn sum(&self, weights: &[Complex64]) -> Vec<f64> {
        let pairs = 0..self.moves.nrows() * self.sites;
        let of_pair = |pair: usize| {
            let (output, input) = (pair / self.sites, pair % self.sites);
            let of_pole = |(pole, weight): (usize, &Complex64)| {
                (self.moves[(output, pole)] * weight * self.excited[(pole, input)]).re
            };
            weights.iter().enumerate().map(of_pole).sum()
        };
        pairs.map(of_pair).collect()
    }

    /// At a sampling frequency, Hz.
    ///
    /// # Errors
    /// Where steps take more from a string than it has.
    pub(super) fn held(&self, sampling_frequency: f64) -> Result<BendingPoles, BuildError> {
        let (sites, step) = (self.sites, sampling_frequency.recip());
        let outputs = self.moves.nrows();
        let turns: Vec<Complex64> = self.rates.iter().map(|rate| (rate * step).exp()).collect();
        let poles = || self.rates.iter().zip(&turns);
        // A force over a step moves a pole by (z − 1)/λ in it, on which the displacement follows by the time
        // that is left. As means of both ends of a step, half of that counts in the step itself.
        let own: Vec<Complex64> = poles()
            .map(|(rate, turn)| 0.5 * ((turn - 1.0) / rate - step) / rate)
            .collect();
        let later: Vec<Complex64> = poles()
            .map(|(rate, turn)| (turn - 1.0) * (turn + 1.0) / (2.0 * rate * rate))
            .collect();
        let instants = self.sum(&own);
        let speeds = Speeds {
            turns: &turns,
            own: instants.iter().map(|it| 2.0 * it / step).collect(),
            moves: &self.moves,
            excited: Mat::from_fn(turns.len(), sites, |pole, site| {
                let (rate, turned) = (self.rates[pole], turns[pole] - 1.0);
                self.excited[(pole, site)] * turned * turned / (rate * rate * step)
            }),
        };
        let margin = least_margin(&speeds)?;
        if margin < STABLE_MARGIN {
            return Err(BuildError::PolesNotPassive { margin });
        }
        let of_rates = |output: usize, pole: usize| self.moves[(output, pole)];
        let by_force = |site: usize, pole: usize| self.excited[(pole, site)] * later[pole];
        let (drifts, drift) = self.drift(&speeds.own, step)?;
        let rows = |count: usize, of_pole: &dyn Fn(usize, usize) -> Complex64| -> Vec<Complex64> {
            let row = |output: usize| {
                let own = (0..turns.len()).map(move |pole| of_pole(output, pole));
                own.chain((0..drifts).map(|place| drift[(output, place)].into()))
                    .collect::<Vec<_>>()
            };
            (0..count).flat_map(row).collect()
        };
        let (shapes, inputs) = (rows(outputs, &of_rates), rows(sites, &by_force));
        let turns = turns.iter().copied();
        Ok(BendingPoles {
            sites,
            places: Vec::new(),
            turns: turns.chain((0..drifts).map(|_| 1.0.into())).collect(),
            shapes,
            inputs,
            instants,
            margin,
            sampling_frequency,
        })
    }

    /// How far a string that nothing holds stays from where it was after a force of a step, √(m/N): columns
    /// whose products are that of each output by each site, and how many.
    fn drift(&self, own: &[f64], step: f64) -> Result<(usize, Mat<f64>), BuildError> {
        let at_rest: Vec<Complex64> = self.rates.iter().map(|rate| -rate.inv()).collect();
        let speeds = self.sum(&at_rest);
        let sites = self.sites;
        let symmetric = Mat::from_fn(sites, sites, |row, column| {
            0.5 * step * (speeds[row * sites + column] + speeds[column * sites + row])
        });
        let greatest = (0..sites)
            .map(|site| own[site * (sites + 1)])
            .fold(0.0, f64::max);
        let (values, vectors) = eigenvalues::of_symmetric_with_vectors(&symmetric)?;
        let first = values.partition_point(|value| *value <= LEAST_DRIFT * greatest * step);
        let drift = Mat::from_fn(self.moves.nrows(), sites - first, |output, place| {
            let (vector, value) = (vectors.col(first + place), values[first + place]);
            match output < sites {
                true => vector[output] * value.sqrt(),
                false => {
                    let speeds = speeds[output * sites..][..sites].iter();
                    let along: f64 = speeds.zip(vector.iter()).map(|(a, b)| a * b).sum();
                    step * along / value.sqrt()
                }
            }
        });
        Ok((sites - first, drift))
    }
}
