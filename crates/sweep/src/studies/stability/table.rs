//! The atlas as a table, and in a few lines.

use std::fmt::Write;

use anyhow::{Context, Result};

use super::families::{Approach, Cell, Family};
use super::verdict::{Findings, explanation};
use crate::studies::methods::Parameters;
use crate::words::wrapped;

/// A cell and what it shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The cell.
    pub cell: Cell,
    /// What it shows.
    pub findings: Findings,
}

const HEADER: [&str; 23] = [
    "family",
    "method",
    "sampling_frequency_hz",
    "transform_s",
    "gamma",
    "stiffness_n_m15",
    "site_spacing_m",
    "sections",
    "steps",
    "margin_torsion",
    "margin_bending",
    "margin_wall",
    "predicted",
    "energy_gained",
    "chatter",
    "growth",
    "drift",
    "recaptures",
    "error",
    "symptoms",
    "outcome",
    "right",
    "note",
];

impl Entry {
    /// The parameters of its method.
    pub fn parameters(&self) -> Parameters {
        match self.cell.approach {
            Approach::Method(method) => Parameters::of(&method),
            _ => Parameters::none(),
        }
    }

    /// The method, with its parameter where that is not the usual one.
    pub fn method_name(&self) -> String {
        let name = self.cell.approach.name();
        let parameters = self.parameters();
        match (parameters.transform_s, parameters.gamma) {
            (Some(seconds), _) => format!("{name}, {seconds} s"),
            (None, Some(gamma)) => format!("{name}, γ = {gamma}"),
            (None, None) => name.to_owned(),
        }
    }

    fn symptoms(&self) -> String {
        let names: Vec<&str> = (self.findings.symptoms().iter())
            .map(|symptom| symptom.name())
            .collect();
        names.join("+")
    }

    fn fields(&self) -> [String; 23] {
        let (cell, findings, parameters) = (&self.cell, &self.findings, self.parameters());
        let number = |value: Option<f64>| value.map_or_else(String::new, exactly);
        let count =
            |value: Option<usize>| value.map_or_else(String::new, |value| value.to_string());
        let verdict = |stable: bool| if stable { "stable" } else { "unstable" }.to_owned();
        let is_sound = findings.symptoms().is_empty();
        let outcome = match (findings.predicted_stable(), is_sound) {
            (Some(_), is_stable) => verdict(is_stable),
            (None, true) => "accurate".to_owned(),
            (None, false) => "wrong".to_owned(),
        };
        [
            cell.family.name(),
            cell.approach.name().to_owned(),
            cell.sampling_frequency.to_string(),
            number(parameters.transform_s),
            number(parameters.gamma),
            number(cell.stiffness),
            number(cell.site_spacing),
            count(cell.sections),
            count(cell.steps),
            number(findings.margin_torsion),
            number(findings.margin_bending),
            number(findings.margin_wall),
            (findings.predicted_stable()).map_or_else(String::new, verdict),
            number(findings.energy_gained),
            number(findings.chatter),
            number(findings.growth),
            number(findings.drift),
            count(findings.recaptures),
            number(findings.error),
            self.symptoms(),
            outcome,
            (findings.is_right()).map_or_else(String::new, |right| {
                if right { "yes" } else { "no" }.to_owned()
            }),
            explanation(cell, findings).unwrap_or_default(),
        ]
    }

    /// The cell in a line: what makes it different from others of its family.
    fn place(&self) -> String {
        let mut place = format!("{}: {}", self.cell.family.name(), self.method_name());
        let parts = [
            ("f_s", Some(self.cell.sampling_frequency), " Hz"),
            ("stiffness", self.cell.stiffness, " N/m^1.5"),
            ("spacing", self.cell.site_spacing, " m"),
            ("sections", self.cell.sections.map(|n| n as f64), ""),
        ];
        for (name, value, unit) in parts {
            if let Some(value) = value {
                place.push_str(&format!(", {name} {value}{unit}"));
            }
        }
        place
    }
}

/// The shortest number that reads back as this one.
fn exactly(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// All rows, header first.
///
/// # Errors
/// Where memory does not take them.
pub fn to_csv(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for entry in entries {
        writer.write_record(entry.fields())?;
    }
    writer.into_inner().context("the table is not whole")
}

/// Cells and right predictions of each family, and every wrong one with its
/// explanation.
pub fn summary(entries: &[Entry]) -> String {
    let mut text = format!(
        "{:<14} {:>6} {:>9} {:>6} {:>11}\n",
        "family", "cells", "predicted", "right", "unstable"
    );
    let mut line = |name: &str, of: &[&Entry]| {
        let predicted = of
            .iter()
            .filter(|entry| entry.findings.is_right().is_some());
        let right = of
            .iter()
            .filter(|entry| entry.findings.is_right() == Some(true));
        let unstable = (of.iter()).filter(|entry| !entry.findings.symptoms().is_empty());
        let counts = [of.len(), predicted.count(), right.count(), unstable.count()];
        let [cells, predicted, right, unstable] = counts;
        let _ = writeln!(
            text,
            "{name:<14} {cells:>6} {predicted:>9} {right:>6} {unstable:>11}"
        );
    };
    for family in Family::all() {
        let of: Vec<&Entry> = (entries.iter())
            .filter(|entry| entry.cell.family == *family)
            .collect();
        if !of.is_empty() {
            line(&family.name(), &of);
        }
    }
    line("all", &entries.iter().collect::<Vec<_>>());
    for entry in entries {
        if entry.findings.is_right() == Some(false) {
            let why = explanation(&entry.cell, &entry.findings);
            let why = why.unwrap_or_else(|| "not explained".to_owned());
            let symptoms = if entry.symptoms().is_empty() {
                "no symptom".to_owned()
            } else {
                entry.symptoms()
            };
            let words = format!("not as predicted: {}: {symptoms}: {why}", entry.place());
            text += &format!("\n{}", wrapped(&words, 0, 2));
        }
    }
    text
}
