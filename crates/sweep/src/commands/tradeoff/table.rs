//! `tradeoff.csv`: every configuration by every measure.

use anyhow::Result;

use crate::commands::csv_table::csv_table;
use studies::tradeoff::{Measure, TradeoffRow, front};

/// Measures that were studied, in order.
pub fn measures(rows: &[TradeoffRow]) -> Vec<Measure> {
    let mut measures: Vec<Measure> = rows.iter().map(|row| row.measure).collect();
    measures.dedup();
    measures
}

/// `tradeoff.csv`.
pub fn table(rows: &[TradeoffRow]) -> Result<Vec<u8>> {
    let fronts: Vec<&TradeoffRow> = (measures(rows).into_iter())
        .flat_map(|measure| front(rows, measure))
        .map(|(row, _)| row)
        .collect();
    csv_table(rows.iter().map(|row| {
        let is_on_front = fronts.iter().any(|front| std::ptr::eq(*front, row));
        columns(row, is_on_front)
    }))
}

/// The columns of the table: their names, and what a row has there.
fn columns(row: &TradeoffRow, is_on_front: bool) -> [(&'static str, String); 14] {
    fn optional(value: Option<impl ToString>) -> String {
        value.map_or_else(String::new, |value| value.to_string())
    }
    let (configuration, parameters) = (&row.configuration, row.configuration.parameters());
    let frequency = configuration.sampling_frequency;
    // Of a whole history there is no one value, nor a reference for it.
    let reference = row.value.map(|_| row.reference.value);
    let uncertainty = row.reference.uncertainty;
    [
        ("measure", row.measure.name().to_owned()),
        ("method", configuration.method().to_owned()),
        ("gamma", optional(parameters.gamma)),
        ("elements_per_cell", optional(parameters.elements_per_cell)),
        ("transform_s", optional(parameters.transform_s)),
        ("sampling_frequency_hz", frequency.to_string()),
        ("value", optional(row.value)),
        ("reference", optional(reference)),
        ("reference_uncertainty", uncertainty.to_string()),
        ("relative_error", optional(row.error)),
        ("build_s", row.build_seconds.to_string()),
        ("step_s_per_simulated_s", row.step_seconds.to_string()),
        ("cost_1000_cases_s", row.cost().to_string()),
        (
            "on_front",
            if is_on_front { "yes" } else { "no" }.to_owned(),
        ),
    ]
}
