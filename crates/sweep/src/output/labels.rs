//! `labels.csv`: one row per case and method, tidy; `failures.csv`: the cases
//! without an answer.

use std::path::Path;

use anyhow::{Context, Result, bail};
use sim::{LateralMeasures, TorsionMeasures};

use crate::engine::{Row, RowOutcome};
use crate::lines::{COMMENT, line_from};
use crate::spec::{Axis, Sweep, to_rpm};

/// Columns that follow the axes.
const RESULT_COLUMNS: [&str; 20] = [
    "torsion",
    "lateral",
    "first_slip_s",
    "period_s",
    "slip_time_s",
    "sticks",
    "bit_speed_peak_rpm",
    "bit_speed_closing_rpm",
    "site_from_bit_m",
    "first_contact_s",
    "peak_radius_mm",
    "mean_radius_mm",
    "contact_fraction",
    "rolling_fraction",
    "precession_turns_per_s",
    "normal_force_mean_kn",
    "ambiguous_steps",
    "simulated_s",
    "ended",
    "status",
];

/// The whole of `labels.csv`.
pub fn labels_csv(sweep: &Sweep, rows: &[Row]) -> Result<Vec<u8>> {
    let with_torque = shows_torque(sweep);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = vec!["case", "method"];
    header.extend(sweep.design.axes().iter().map(|axis| axis.name()));
    header.extend(with_torque.then_some(Axis::TorqueDynamicNm.name()));
    header.extend(RESULT_COLUMNS);
    writer.write_record(&header)?;
    for row in rows {
        let mut fields = vec![row.case.to_string(), row.method.to_owned()];
        fields.extend(row.values.iter().map(f64::to_string));
        if with_torque {
            fields.push(optional(row.torque_dynamic_nm));
        }
        fields.extend(result_fields(sweep, &row.outcome));
        writer.write_record(&fields)?;
    }
    Ok(writer.into_inner()?)
}

/// What an axis is mapped to on the way to the model is a column too.
fn shows_torque(sweep: &Sweep) -> bool {
    sweep.bit.is_some() && !sweep.design.axes().contains(&Axis::TorqueDynamicNm)
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn result_fields(sweep: &Sweep, outcome: &RowOutcome) -> Vec<String> {
    let done = match outcome {
        RowOutcome::Done(outcome) => Some(outcome),
        RowOutcome::Failed(_) => None,
    };
    let torsion = done.and_then(|outcome| outcome.torsion.as_ref());
    let lateral = done.and_then(|outcome| outcome.lateral.as_ref());
    let mut fields = vec![
        torsion.map_or_else(String::new, |torsion| torsion.regime.name().to_owned()),
        lateral.map_or_else(String::new, |lateral| lateral.regime.name().to_owned()),
    ];
    fields.extend(torsion.map_or_else(|| vec![String::new(); 6], torsion_fields));
    let lateral_fields = |lateral| lateral_fields(sweep, lateral);
    fields.extend(lateral.map_or_else(|| vec![String::new(); 9], lateral_fields));
    let (ended, status) = match done {
        Some(_) => ("end", "ok"),
        None => ("", "failed"),
    };
    fields.push(optional(done.map(|outcome| outcome.simulated)));
    fields.extend([ended.to_owned(), status.to_owned()]);
    fields
}

fn torsion_fields(torsion: &TorsionMeasures) -> Vec<String> {
    vec![
        optional(torsion.first_slip),
        optional(torsion.period),
        optional(torsion.slip_time),
        torsion.sticks.to_string(),
        to_rpm(torsion.peak_speed).to_string(),
        to_rpm(torsion.closing_speed).to_string(),
    ]
}

fn lateral_fields(sweep: &Sweep, lateral: &LateralMeasures) -> Vec<String> {
    vec![
        sweep.sites.distances_from_bit()[lateral.site].to_string(),
        optional(lateral.first_contact),
        (1e3 * lateral.peak_radius).to_string(),
        (1e3 * lateral.mean_radius).to_string(),
        lateral.contact_fraction.to_string(),
        lateral.rolling_fraction.to_string(),
        (lateral.precession_rate / std::f64::consts::TAU).to_string(),
        (1e-3 * lateral.mean_normal_force).to_string(),
        lateral.ambiguous_steps.to_string(),
    ]
}

/// The whole of `failures.csv`.
pub fn failures_csv(sweep_file: &Path, rows: &[Row]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["case", "method", "reason", "repeat_with"])?;
    for row in rows {
        if let RowOutcome::Failed(reason) = &row.outcome {
            let repeat = format!(
                "sweep simulate {} --case {} --methods {}",
                sweep_file.display(),
                row.case,
                row.method
            );
            writer.write_record([&row.case.to_string(), row.method, reason, &repeat])?;
        }
    }
    Ok(writer.into_inner()?)
}

/// What is read back of a row: enough to draw it or to run it again.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelRow {
    /// Line of the file.
    pub line: usize,
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// Values along the given axes.
    pub values: Vec<f64>,
    /// The torsion label; empty where there is none.
    pub torsion: String,
    /// The lateral label; empty where there is none.
    pub lateral: String,
}

/// Reads labels back: the columns `case`, `method`, the axes asked for, `torsion`
/// and, if it is there, `lateral`, wherever they stand; others are passed over.
pub fn read_labels(path: &Path, axes: &[Axis]) -> Result<Vec<LabelRow>> {
    let text = std::fs::read_to_string(path)
        .with_context(|| format!("{} cannot be read", path.display()))?;
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(COMMENT))
        .from_reader(text.as_bytes());
    let header = reader.headers()?.clone();
    let column = |name: &str| {
        let found = header.iter().position(|field| field == name);
        let line = line_from(&text, 0);
        found.with_context(|| format!("{}:{line}: has no column `{name}`", path.display()))
    };
    let (case, method, torsion) = (column("case")?, column("method")?, column("torsion")?);
    let lateral = column("lateral").ok();
    let value_columns = axes
        .iter()
        .map(|axis| column(axis.name()))
        .collect::<Result<Vec<_>>>()?;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.with_context(|| format!("{} is not a table", path.display()))?;
        let line = line_from(
            &text,
            record.position().map_or(0, csv::Position::byte) as usize,
        );
        let Ok(case) = record[case].parse() else {
            bail!(
                "{}:{line}: `{}` is not a case number",
                path.display(),
                &record[case]
            );
        };
        let number = |&column: &usize| -> Result<f64> {
            record[column].parse().with_context(|| {
                format!(
                    "{}:{line}: `{}` is not a number",
                    path.display(),
                    &record[column]
                )
            })
        };
        rows.push(LabelRow {
            line,
            case,
            method: record[method].to_owned(),
            values: value_columns.iter().map(number).collect::<Result<_>>()?,
            torsion: record[torsion].to_owned(),
            lateral: lateral.map_or_else(String::new, |column| record[column].to_owned()),
        });
    }
    Ok(rows)
}
