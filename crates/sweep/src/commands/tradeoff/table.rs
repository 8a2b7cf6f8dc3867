//! `tradeoff.csv`: every configuration by every measure.

use anyhow::{Context, Result};

use crate::studies::tradeoff::{Measure, Row, front};

/// Measures that were studied, in order.
pub fn measures(rows: &[Row]) -> Vec<Measure> {
    let mut measures: Vec<Measure> = rows.iter().map(|row| row.measure).collect();
    measures.dedup();
    measures
}

/// `tradeoff.csv`.
pub fn table(rows: &[Row]) -> Result<Vec<u8>> {
    let fronts: Vec<&Row> = (measures(rows).into_iter())
        .flat_map(|measure| front(rows, measure))
        .map(|(row, _)| row)
        .collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "measure",
        "method",
        "gamma",
        "elements_per_cell",
        "transform_s",
        "sampling_frequency_hz",
        "value",
        "reference",
        "reference_uncertainty",
        "relative_error",
        "build_s",
        "step_s_per_simulated_s",
        "cost_1000_cases_s",
        "on_front",
    ])?;
    let optional = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for row in rows {
        let parameters = row.configuration.parameters();
        let on_front = fronts.iter().any(|front| std::ptr::eq(*front, row));
        // Of a whole history there is no one value, nor a reference for it.
        let reference = row.value.map(|_| row.reference.value);
        writer.write_record([
            row.measure.name().to_owned(),
            row.configuration.method().to_owned(),
            optional(parameters.gamma),
            (parameters.elements_per_cell)
                .map_or_else(String::new, |elements| elements.to_string()),
            optional(parameters.transform_s),
            row.configuration.sampling_frequency.to_string(),
            optional(row.value),
            optional(reference),
            row.reference.uncertainty.to_string(),
            optional(row.error),
            row.build_seconds.to_string(),
            row.step_seconds.to_string(),
            row.cost().to_string(),
            if on_front { "yes" } else { "no" }.to_owned(),
        ])?;
    }
    writer.into_inner().context("the table cannot be written")
}
