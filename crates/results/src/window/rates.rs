//! The rate of penetration over weight and speed, by simulated cases of a bit that cuts.

use anyhow::Result;

use super::simulated::{AXES, kind_of, labels};
use crate::analysis::Bins;
use crate::folder::{ResultTables, read_measured_cases};
use campaign::records::Measure;
use campaign::sweep_file::DesignKind;

/// Column of `labels.csv`.
const RATE: &str = "rate_of_penetration_m_h";

/// Rates of penetration, m/h.
#[derive(Debug, Clone, PartialEq)]
pub enum Rates {
    /// At the points of a lattice, of all speeds of one weight after one another.
    At([Vec<f64>; 2], Vec<Option<f64>>),
    /// The mean of random cases in ranges.
    In([Bins; 2], Vec<Option<f64>>),
}

impl Rates {
    /// Of the cases of a results folder, the mean of all methods, random ones in a number of ranges of
    /// either axis; none where no bit cuts.
    ///
    /// # Errors
    /// Where tables cannot be read.
    pub fn of(tables: &ResultTables, ranges: usize) -> Result<Option<Self>> {
        let content = &tables.manifest.sweep;
        let cuts = content.has_cutting();
        let Some(measure) = Measure::named(RATE).filter(|_| cuts) else {
            return Ok(None);
        };
        let mut cases = Vec::new();
        for case in read_measured_cases(&labels(tables), &AXES, &[measure])? {
            let case = case?;
            let rates = case.rows.iter().filter_map(|row| row.measures[0]);
            let rates: Vec<f64> = rates.collect();
            if !rates.is_empty() {
                let mean = rates.iter().sum::<f64>() / rates.len() as f64;
                cases.push(([case.values[0], case.values[1]], mean));
            }
        }
        if kind_of(tables).is_some_and(DesignKind::is_random) {
            let bins = Bins::along(std::slice::from_ref(tables), content, &AXES, ranges)?;
            let Ok(bins) = <[Bins; 2]>::try_from(bins) else {
                return Ok(None);
            };
            let size = bins.each_ref().map(|bins| bins.ranges.len());
            let place = |at: [f64; 2]| [0, 1].map(|axis| bins[axis].place(at[axis]));
            let means = means(size, cases.into_iter().map(|(at, rate)| (place(at), rate)));
            return Ok(Some(Self::In(bins, means)));
        }
        let values = [0, 1].map(|axis| {
            let mut values: Vec<f64> = cases.iter().map(|(at, _)| at[axis]).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            values
        });
        if values.iter().any(|values| values.len() < 2) {
            return Ok(None);
        }
        let size = values.each_ref().map(Vec::len);
        let place =
            |at: [f64; 2]| [0, 1].map(|axis| values[axis].partition_point(|it| *it < at[axis]));
        let means = means(size, cases.into_iter().map(|(at, rate)| (place(at), rate)));
        let rates = match tables.manifest.is_trace() {
            true => filled(&values, means),
            false => means,
        };
        Ok(Some(Self::At(values, rates)))
    }

    /// At a weight (kN) and a speed (rpm), straight between the four points around it; `None` where
    /// one of them has no answer.
    pub fn at(&self, place: [f64; 2]) -> Option<f64> {
        match self {
            Self::At(values, rates) => {
                let rows = values[1].len();
                let [column, row] = [0, 1].map(|axis| {
                    let above = values[axis].partition_point(|value| *value < place[axis]);
                    above.clamp(1, values[axis].len() - 1) - 1
                });
                let part = |axis: usize, from: usize| {
                    let [low, high] = [values[axis][from], values[axis][from + 1]];
                    ((place[axis] - low) / (high - low)).clamp(0.0, 1.0)
                };
                let along = |column: usize| {
                    let [low, high] = [row, row + 1].map(|row| rates[column * rows + row]);
                    Some(low? + part(1, row) * (high? - low?))
                };
                let [low, high] = [along(column)?, along(column + 1)?];
                Some(low + part(0, column) * (high - low))
            }
            Self::In(bins, rates) => {
                let [column, row] = [0, 1].map(|axis| bins[axis].place(place[axis]));
                rates[column * bins[1].ranges.len() + row]
            }
        }
    }
}

/// Rates of a trace, which simulates a coarse lattice and what is near limits: straight between those that
/// it has, along the speed first and then along the weight.
fn filled(values: &[Vec<f64>; 2], mut rates: Vec<Option<f64>>) -> Vec<Option<f64>> {
    let rows = values[1].len();
    for column in rates.chunks_mut(rows) {
        fill(&values[1], column);
    }
    for row in 0..rows {
        let mut along: Vec<_> = rates.iter().skip(row).step_by(rows).copied().collect();
        fill(&values[0], &mut along);
        for (rate, filled) in rates.iter_mut().skip(row).step_by(rows).zip(along) {
            *rate = filled;
        }
    }
    rates
}

/// What is between known rates along one axis.
fn fill(values: &[f64], rates: &mut [Option<f64>]) {
    let known = rates
        .iter()
        .enumerate()
        .filter_map(|(at, rate)| Some((at, (*rate)?)));
    let known: Vec<(usize, f64)> = known.collect();
    for ends in known.windows(2) {
        let [(from, low), (to, high)] = [ends[0], ends[1]];
        for at in from + 1..to {
            let part = (values[at] - values[from]) / (values[to] - values[from]);
            rates[at] = Some(low + part * (high - low));
        }
    }
}

/// The mean of what is at each place.
fn means(
    [columns, rows]: [usize; 2],
    found: impl Iterator<Item = ([usize; 2], f64)>,
) -> Vec<Option<f64>> {
    let mut sums = vec![(0.0, 0usize); columns * rows];
    for ([column, row], rate) in found {
        let (sum, count) = &mut sums[column * rows + row];
        *sum += rate;
        *count += 1;
    }
    let mean = |(sum, count): (f64, usize)| (count > 0).then(|| sum / count as f64);
    sums.into_iter().map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use campaign::sweep_file::Spacing;

    #[test]
    fn a_rate_is_straight_between_points() {
        let values = [vec![10.0, 30.0], vec![40.0, 60.0, 100.0]];
        let found = |of: &dyn Fn(f64, f64) -> Option<f64>| {
            let rates = values[0].iter().flat_map(|weight| {
                let speeds = values[1].iter();
                speeds.map(move |speed| of(*weight, *speed))
            });
            Rates::At(values.clone(), rates.collect())
        };
        // Bilinear interpolation is exact of a product.
        let product = found(&|weight, speed| Some(0.01 * weight * speed));
        for at in [[10.0, 40.0], [17.0, 55.0], [30.0, 100.0], [12.0, 80.0]] {
            let exact = 0.01 * at[0] * at[1];
            assert!((product.at(at).unwrap() - exact).abs() < 1e-12, "{at:?}");
        }
        let with_a_gap = found(&|weight, speed| (weight < 20.0 || speed < 90.0).then_some(1.0));
        assert_eq!(with_a_gap.at([15.0, 50.0]), Some(1.0));
        assert_eq!(with_a_gap.at([15.0, 70.0]), None);
    }

    /// A coarse lattice, and three points of a limit between.
    #[test]
    fn rates_of_a_trace_are_straight_between_those_that_it_has() {
        let values = [
            vec![10.0, 15.0, 20.0, 30.0],
            vec![40.0, 50.0, 60.0, 90.0, 100.0],
        ];
        let rate = |column: usize, row: usize| 0.01 * values[0][column] * values[1][row];
        let is_coarse = |column: usize, row: usize| column % 3 == 0 && row % 2 == 0;
        let is_near = |column: usize, row: usize| row == 1 || (column, row) == (2, 3);
        let places = (0..20).map(|at| (at / 5, at % 5));
        let has = places.clone().map(|(column, row)| {
            let is_known = is_coarse(column, row) || is_near(column, row);
            is_known.then(|| rate(column, row))
        });
        let found = filled(&values, has.collect());
        for (found, (column, row)) in found.into_iter().zip(places) {
            let exact = rate(column, row);
            assert!((found.unwrap() - exact).abs() < 1e-12, "{column} {row}");
        }
    }

    #[test]
    fn random_cases_are_their_mean_in_a_range() {
        let bins = |axis, count: usize| Bins {
            axis,
            ranges: (0..count).map(|at| [at as f64, at as f64 + 1.0]).collect(),
            spacing: Spacing::Linear,
        };
        let found = [([0, 0], 1.0), ([0, 1], 4.0), ([0, 1], 6.0)];
        let means = means([1, 3], found.into_iter());
        let rates = Rates::In([bins(AXES[0], 1), bins(AXES[1], 3)], means);
        let at = |speed: f64| rates.at([0.5, speed]);
        assert_eq!([0.5, 1.5, 2.5].map(at), [Some(1.0), Some(5.0), None]);
    }
}
