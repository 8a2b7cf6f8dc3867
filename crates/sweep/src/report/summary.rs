//! What a results folder says, as `sweep summary --json` has it.

use std::collections::BTreeMap;

use serde::Serialize;
use sim::Labels;

use super::agreement::Agreement;
use super::failures::Failures;
use super::limit::LimitChecks;
use super::results::Results;
use campaign::quantities::Axis;
use results::folder::{CaseRows, Manifest, SoFar};

/// A results folder.
#[derive(Serialize)]
pub struct SummaryFound<'a> {
    folder: &'a str,
    /// How far the run is, where it is not finished.
    so_far: Option<SoFar>,
    agreement: &'a Agreement,
    /// The first cases on which methods differ.
    differing_cases: Vec<DifferingCase<'a>>,
    analytic_limit: &'a Option<LimitChecks>,
    failures: &'a Failures,
    /// As in `manifest.json`.
    manifest: &'a Manifest,
}

/// What each method says of a case.
#[derive(Serialize)]
struct DifferingCase<'a> {
    case: usize,
    values: BTreeMap<String, f64>,
    labels: BTreeMap<&'a str, &'a Labels>,
}

impl<'a> SummaryFound<'a> {
    /// Of a folder.
    pub fn new(results: &'a Results) -> Self {
        let axes = &results.manifest.axes;
        let listed = results.agreement.listed.iter();
        Self {
            folder: &results.name,
            so_far: results.tables.so_far,
            agreement: &results.agreement,
            differing_cases: listed.map(|case| DifferingCase::new(case, axes)).collect(),
            analytic_limit: &results.limits,
            failures: &results.failures,
            manifest: &results.manifest,
        }
    }
}

impl<'a> DifferingCase<'a> {
    fn new(case: &'a CaseRows, axes: &[Axis]) -> Self {
        let values = axes.iter().zip(&case.values);
        let rows = case.rows.iter();
        Self {
            case: case.case,
            values: values.map(|(axis, value)| (axis.name(), *value)).collect(),
            labels: rows.map(|row| (row.method.as_str(), &row.labels)).collect(),
        }
    }
}
