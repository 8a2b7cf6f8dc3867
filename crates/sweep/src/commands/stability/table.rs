//! The atlas as a table, and in a few lines.

use std::fmt::Write;

use campaign::words::wrapped;
use studies::stability::{Cell, Entry, Family, Findings, explanation};

fn symptoms(entry: &Entry) -> String {
    let names: Vec<&str> = (entry.findings.symptoms().iter())
        .map(|symptom| symptom.name())
        .collect();
    names.join("+")
}

/// The columns of the table: their names, and what an entry has there.
pub fn columns(entry: &Entry) -> [(&'static str, String); 23] {
    let (cell, findings) = (&entry.cell, &entry.findings);
    let parameters = cell.parameters();
    let number = |value: Option<f64>| value.map_or_else(String::new, exactly);
    let count = |value: Option<usize>| value.map_or_else(String::new, |value| value.to_string());
    let word = |is: Option<bool>, yes: &str, no: &str| {
        is.map_or_else(String::new, |is| if is { yes } else { no }.to_owned())
    };
    let is_sound = Some(findings.symptoms().is_empty());
    let outcome = match findings.predicted_stable() {
        Some(_) => word(is_sound, "stable", "unstable"),
        None => word(is_sound, "accurate", "wrong"),
    };
    [
        ("family", cell.family.name()),
        ("method", cell.approach.name().to_owned()),
        ("sampling_frequency_hz", cell.sampling_frequency.to_string()),
        ("transform_s", number(parameters.transform_s)),
        ("gamma", number(parameters.gamma)),
        ("stiffness_n_m15", number(cell.stiffness)),
        ("site_spacing_m", number(cell.site_spacing)),
        ("sections", count(cell.sections)),
        ("steps", count(cell.steps)),
        ("margin_torsion", number(findings.margin_torsion)),
        ("margin_bending", number(findings.margin_bending)),
        ("margin_wall", number(findings.margin_wall)),
        (
            "predicted",
            word(findings.predicted_stable(), "stable", "unstable"),
        ),
        ("energy_gained", number(findings.energy_gained)),
        ("chatter", number(findings.chatter)),
        ("growth", number(findings.growth)),
        ("drift", number(findings.drift)),
        ("recaptures", count(findings.recaptures)),
        ("error", number(findings.error)),
        ("symptoms", symptoms(entry)),
        ("outcome", outcome),
        ("right", word(findings.is_right(), "yes", "no")),
        ("note", explanation(cell, findings).unwrap_or_default()),
    ]
}

/// A cell in a line: what makes it different from others of its family.
fn place(cell: &Cell) -> String {
    let mut place = format!("{}: {}", cell.family.name(), cell.method_name());
    let parts = [
        ("f_s", Some(cell.sampling_frequency), " Hz"),
        ("stiffness", cell.stiffness, " N/m^1.5"),
        ("spacing", cell.site_spacing, " m"),
        ("sections", cell.sections.map(|n| n as f64), ""),
    ];
    for (name, value, unit) in parts {
        if let Some(value) = value {
            place.push_str(&format!(", {name} {value}{unit}"));
        }
    }
    place
}

/// The shortest number that reads back as this one.
fn exactly(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Cells and right predictions of each family, and every wrong one with its
/// explanation.
pub fn summary(entries: &[Entry]) -> String {
    let mut text = format!(
        "{:<14} {:>6} {:>9} {:>6} {:>11}\n",
        "family", "cells", "predicted", "right", "unstable"
    );
    let mut line = |name: &str, of: &[&Entry]| {
        let count = |shows: fn(&Findings) -> bool| {
            let shown = of.iter().filter(|entry| shows(&entry.findings));
            shown.count()
        };
        let cells = of.len();
        let predicted = count(|findings| findings.is_right().is_some());
        let right = count(|findings| findings.is_right() == Some(true));
        let unstable = count(|findings| !findings.symptoms().is_empty());
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
            let symptoms = if symptoms(entry).is_empty() {
                "no symptom".to_owned()
            } else {
                symptoms(entry)
            };
            let words = format!(
                "not as predicted: {}: {symptoms}: {why}",
                place(&entry.cell)
            );
            text += &format!("\n{}", wrapped(&words, 0, 2));
        }
    }
    text
}
