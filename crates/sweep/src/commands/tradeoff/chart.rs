//! The chart of accuracy against speed.

use super::table::measures;
use crate::commands::prepare::unique;
use plot::{Axis, Picture, ScatterPanel, Series, method_style, scatter_grid};
use studies::tradeoff::{CASE_SECONDS, CASES, Measure, TradeoffRow, front};

/// Smaller errors are drawn here: they are rounding.
const SMALLEST_DRAWN: f64 = 1e-9;

/// Draws each measure's configurations.
pub fn chart(rows: &[TradeoffRow]) -> Picture {
    let panels = (measures(rows).into_iter())
        .enumerate()
        .map(|(index, measure)| panel(rows, measure, index % 3 == 0));
    let title = format!(
        "Accuracy against speed: what {CASES} cases of {CASE_SECONDS} s cost, and how far off each is"
    );
    scatter_grid(
        &title,
        [
            "smallest reliable error at this cost; points below are accurate by chance",
            "the reference is no surer than this",
            "the paper's own: 640 Hz, filters of 10 s or 20 elements",
        ],
        &panels.collect::<Vec<_>>(),
    )
}

fn panel(rows: &[TradeoffRow], measure: Measure, is_first: bool) -> ScatterPanel {
    let point = |row: &TradeoffRow| Some((row.cost(), row.error?.max(SMALLEST_DRAWN)));
    let known = || rows.iter().filter(|row| row.measure == measure);
    let family = |row: &TradeoffRow| row.configuration.family();
    let families = unique(&known().map(family).collect::<Vec<_>>());
    let kinds = families.into_iter().map(|name| Series {
        name: name.to_owned(),
        style: method_style(name),
        points: (known().filter(|row| family(row) == name))
            .filter_map(point)
            .collect(),
    });
    let uncertainty = known().map(|row| row.reference.uncertainty).next();
    ScatterPanel {
        title: measure.title().to_owned(),
        axes: [
            Axis::logarithmic(format!("Time of {CASES} cases (s)")),
            Axis::logarithmic(if is_first { "Relative error" } else { "" }),
        ],
        kinds: kinds.collect(),
        front: (front(rows, measure).into_iter())
            .map(|(row, error)| (row.cost(), error.max(SMALLEST_DRAWN)))
            .collect(),
        rims: known()
            .filter(|row| row.configuration.paper().is_some())
            .filter_map(point)
            .collect(),
        floor: uncertainty.filter(|part| *part > 0.0),
    }
}
