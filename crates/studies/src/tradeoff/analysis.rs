//! What the rows say: the Pareto front, observed orders, and the cheapest
//! configuration that is good enough.

use super::configuration::Paper;
use super::measure::{Measure, MeasureSubject};
use super::paper::PaperSteps;
use super::row::{TradeoffRow, cost};

/// An error this close to its reference's uncertainty says nothing of the method.
const ABOVE_UNCERTAINTY: f64 = 4.0;

/// Rungs of the ladder that an order is fitted to.
const FITTED: usize = 3;

/// Neighbouring rungs of a fit have its slope to within this.
const REGULAR: f64 = 0.25;

/// The most that half the step can make of an error, by the third order: no method
/// here has a higher one.
const MOST_IMPROVEMENT: f64 = 8.0;

/// Errors of less are rounding, or the cut tail of a response.
const ROUNDING: f64 = 1e-7;

/// The rows of one measure that no other beats in both cost and error, cheapest
/// first, with the errors that they are sure not to exceed.
pub fn front(rows: &[TradeoffRow], measure: Measure) -> Vec<(&TradeoffRow, f64)> {
    let mut known: Vec<(&TradeoffRow, f64)> = (rows.iter())
        .filter(|row| row.measure == measure)
        .map(|row| (row, certain(rows, row)))
        .filter(|(_, error)| error.is_finite())
        .collect();
    known.sort_by(|(one, _), (other, _)| one.cost().total_cmp(&other.cost()));
    let mut best = f64::INFINITY;
    known.retain(|(_, error)| {
        let is_better = *error < best;
        best = best.min(*error);
        is_better
    });
    known
}

/// The error that a row is sure not to exceed: no finer step of the same method has
/// a larger one, and none is smaller than the next coarser step allows, for an error
/// that passes through zero by chance promises nothing; and the reference may be off
/// by its uncertainty.
fn certain(rows: &[TradeoffRow], row: &TradeoffRow) -> f64 {
    let title = row.configuration.title();
    let frequency = |row: &TradeoffRow| row.configuration.sampling_frequency;
    let error = |row: &TradeoffRow| row.error.unwrap_or(f64::INFINITY);
    let (finer, coarser): (Vec<&TradeoffRow>, Vec<&TradeoffRow>) = (rows.iter())
        .filter(|other| other.measure == row.measure && other.configuration.title() == title)
        .partition(|other| frequency(other) >= frequency(row));
    let largest = finer.iter().map(|row| error(row)).fold(0.0, f64::max);
    // A finer step confirms; the finest has only the coarser to be judged by.
    let allowed = (coarser.iter())
        .max_by(|one, other| frequency(one).total_cmp(&frequency(other)))
        .filter(|_| finer.len() == 1)
        .map_or(0.0, |coarser| error(coarser) / MOST_IMPROVEMENT);
    largest.max(allowed) + row.reference.uncertainty
}

/// How fast the error of one method falls with f_s.
#[derive(Debug, Clone, PartialEq)]
pub struct Order {
    /// Method and parameters.
    pub title: String,
    /// Least-squares slope of error over f_s, both logarithmic.
    pub order: f64,
    /// The highest f_s it is fitted to, Hz.
    pub highest: f64,
}

/// Observed orders, fitted to the last rungs before the error no longer falls, where
/// it falls regularly.
pub fn orders(rows: &[TradeoffRow], measure: Measure) -> Vec<Order> {
    let known: Vec<&TradeoffRow> = rows.iter().filter(|row| row.measure == measure).collect();
    // The rungs of a ladder follow one another.
    let ladders =
        known.chunk_by(|one, next| one.configuration.title() == next.configuration.title());
    let order_of = |ladder: &[&TradeoffRow]| {
        let mut points: Vec<(f64, f64)> = (ladder.iter())
            .map_while(|row| {
                let least = (ABOVE_UNCERTAINTY * row.reference.uncertainty).max(ROUNDING);
                let error = row.error.filter(|error| *error > least)?;
                Some((row.configuration.sampling_frequency, error))
            })
            .collect();
        // What falls no further is another error than that of the step.
        while matches!(points[..], [.., before, last] if last.1 > 0.75 * before.1) {
            points.pop();
        }
        let fitted = &points[points.len().checked_sub(FITTED)?..];
        let order = -slope(fitted);
        let is_regular = (fitted.windows(2)).all(|pair| (slope(pair) + order).abs() < REGULAR);
        is_regular.then_some(Order {
            title: ladder[0].configuration.title(),
            order,
            highest: points.last()?.0,
        })
    };
    ladders.filter_map(order_of).collect()
}

/// Least-squares slope of ln y over ln x.
fn slope(points: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logarithms.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logarithms.iter().map(of).sum::<f64>() / count;
    let (x_mean, y_mean) = (mean(|point| point.0), mean(|point| point.1));
    let (mut products, mut squares) = (0.0, 0.0);
    for (x, y) in &logarithms {
        products += (x - x_mean) * (y - y_mean);
        squares += (x - x_mean).powi(2);
    }
    products / squares
}

/// The cheapest way to an accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cheapest<'a> {
    /// Of which measure.
    pub measure: Measure,
    /// The accuracy asked for.
    pub accuracy: f64,
    /// The row, where there is one.
    pub row: Option<&'a TradeoffRow>,
    /// How many times dearer the paper's filters are, and its elements.
    pub paper: [Option<PaperRatio>; 2],
}

/// How many times dearer than the cheapest a configuration of the paper is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperRatio {
    /// With its responses stepped as here.
    pub stepped_here: f64,
    /// Stepped in the paper's own way.
    pub own_way: f64,
}

/// The cheapest configuration that is sure to be within an accuracy.
pub fn cheapest<'a>(
    rows: &'a [TradeoffRow],
    steps: &PaperSteps,
    measure: Measure,
    accuracy: f64,
) -> Cheapest<'a> {
    let known = || rows.iter().filter(|row| row.measure == measure);
    let row = known()
        .filter(|row| certain(rows, row) <= accuracy)
        .min_by(|one, other| one.cost().total_cmp(&other.cost()));
    let scene = usize::from(measure.subject() == MeasureSubject::Bending);
    let dearer = |paper, step_seconds: f64| {
        let paper = known().find(|row| row.configuration.paper() == Some(paper))?;
        Some(PaperRatio {
            stepped_here: paper.cost() / row?.cost(),
            own_way: cost(paper.build_seconds, step_seconds) / row?.cost(),
        })
    };
    Cheapest {
        measure,
        accuracy,
        row,
        paper: [
            dearer(Paper::Filter, steps.filter[scene]),
            dearer(Paper::Elements, steps.elements[scene]),
        ],
    }
}

#[cfg(test)]
mod tests {
    use linear::Method;

    use super::super::configuration::{Configuration, Scheme};
    use super::super::row::Reference;
    use super::*;

    fn row(sampling_frequency: f64, error: f64, step_seconds: f64) -> TradeoffRow {
        TradeoffRow {
            measure: Measure::FirstSlip,
            configuration: Configuration {
                scheme: Scheme::Method(Method::Quadrature),
                sampling_frequency,
            },
            value: Some(1.0),
            reference: Reference {
                value: 1.0,
                uncertainty: 1e-4,
            },
            error: Some(error),
            build_seconds: 0.0,
            step_seconds,
        }
    }

    /// An error of the second order, but for one that is zero by chance.
    fn second_order() -> Vec<TradeoffRow> {
        let rungs = [80.0, 160.0, 320.0, 640.0];
        let mut rows: Vec<TradeoffRow> = rungs
            .iter()
            .map(|rung| row(*rung, 400.0 / (rung * rung), 1e-6 * rung))
            .collect();
        rows[0].error = Some(0.0);
        rows
    }

    #[test]
    fn an_error_that_is_small_by_chance_promises_nothing() {
        let rows = second_order();
        let steps = PaperSteps {
            filter: [1.0; 2],
            elements: [1.0; 2],
        };
        let found = |accuracy| {
            let cheapest = cheapest(&rows, &steps, Measure::FirstSlip, accuracy);
            cheapest.row.map(|row| row.configuration.sampling_frequency)
        };
        assert_eq!(found(0.1), Some(80.0));
        assert_eq!(found(0.01), Some(320.0));
        assert_eq!(found(0.00105), None);
        assert_eq!(found(0.0011), Some(640.0));
        let front = front(&rows, Measure::FirstSlip);
        assert_eq!(front[0].0.configuration.sampling_frequency, 80.0);
        assert_eq!(front.len(), 3);
    }

    #[test]
    fn the_order_of_an_error_is_its_slope() {
        let mut rows = second_order();
        rows[0].error = Some(400.0 / (80.0 * 80.0));
        let found = orders(&rows, Measure::FirstSlip);
        assert!((found[0].order - 2.0).abs() < 1e-9, "{found:?}");
    }
}
