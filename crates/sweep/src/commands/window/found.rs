//! The window as `--json` has it.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::commands::document::ByColumn;
use crate::map::WindowView;
use results::window::{Best, Chart, Limit, Region, Standing, WINDOW_COLUMNS, by_axis};

/// An operating window.
#[derive(Serialize)]
pub struct WindowFound<'a> {
    title: &'a str,
    /// From the least to the greatest value of both axes.
    #[serde(flatten, serialize_with = "by_axis")]
    ranges: [[f64; 2]; 2],
    limits: Vec<LimitFound<'a>>,
    /// The largest first.
    safe_regions: &'a [Region],
    best: Option<BestFound<'a>>,
    not_examined: &'a [String],
    how_often_wrong: &'a [String],
    /// The rows of `window.csv`.
    #[serde(serialize_with = "by_column")]
    cells: &'a Chart,
    /// What was written.
    files: Vec<String>,
}

/// A limit, and which part of the map stands how to it.
#[derive(Serialize)]
struct LimitFound<'a> {
    #[serde(flatten)]
    limit: &'a Limit,
    parts: BTreeMap<&'static str, f64>,
}

/// The best point, and whether the end of the map is all that keeps it from a better one.
#[derive(Serialize)]
struct BestFound<'a> {
    #[serde(flatten)]
    best: &'a Best,
    is_at_end: bool,
}

impl<'a> WindowFound<'a> {
    /// Of what is drawn.
    pub fn new(view: &'a WindowView, files: Vec<String>) -> Self {
        let chart = view.chart;
        let limits = chart.limits.iter().map(|limit| {
            let part = |standing: Standing| (standing.key(), chart.part(limit, standing));
            LimitFound {
                limit,
                parts: Standing::ALL.map(part).into(),
            }
        });
        let best = view.best.as_ref().map(|best| BestFound {
            best,
            is_at_end: best.is_at_end(view.clearance, chart),
        });
        Self {
            title: &view.title,
            ranges: [0, 1].map(|axis| chart.range(axis)),
            limits: limits.collect(),
            safe_regions: &view.regions,
            best,
            not_examined: &view.not_examined,
            how_often_wrong: &view.how_often_wrong,
            cells: chart,
            files,
        }
    }
}

fn by_column<S: Serializer>(chart: &Chart, serializer: S) -> Result<S::Ok, S::Error> {
    ByColumn {
        columns: &WINDOW_COLUMNS,
        rows: chart.rows().collect(),
    }
    .serialize(serializer)
}
