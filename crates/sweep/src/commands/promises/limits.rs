//! Limits at the default sampling frequency as a table, and in a few lines.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};

use studies::promises::{Found, Truth};

/// The names of the columns that are read again.
const STRING: &str = "string";
const EXACT_LIMIT: &str = "exact_limit_rpm";
const UNCERTAINTY: &str = "exact_uncertainty";
const NOTE: &str = "note";

/// The columns of the table: their names, and what a limit has there.
pub fn columns(found: &Found) -> [(&'static str, String); 17] {
    let problem = &found.problem;
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let (truth, surroundings) = (found.truth.as_ref().ok(), problem.surroundings);
    [
        (STRING, problem.number.to_string()),
        ("family", problem.shape.to_owned()),
        ("surface", problem.surface.to_owned()),
        ("length_m", problem.length.to_string()),
        ("loss_of_wave", problem.loss.to_string()),
        ("method", found.method.to_owned()),
        ("rule", found.rule.name().to_owned()),
        (
            "sampling_frequency_hz",
            found.sampling_frequency.to_string(),
        ),
        ("steps_per_travel", found.steps_per_travel.to_string()),
        ("limit_rpm", number(found.limit)),
        (EXACT_LIMIT, number(truth.map(|truth| truth.limit))),
        (UNCERTAINTY, number(truth.map(|truth| truth.uncertainty))),
        ("error", number(found.error())),
        (NOTE, found.truth.clone().err().unwrap_or_default()),
        (
            "viscosity_cp",
            number(surroundings.map(|around| around.viscosity)),
        ),
        (
            "loss_factor",
            number(surroundings.map(|around| around.loss_factor)),
        ),
        ("exact_limit_by", found.reference().to_owned()),
    ]
}

/// Exact limits, or why there are none, of the strings of an earlier table.
pub type Known = BTreeMap<usize, Result<Truth, String>>;

/// Those of a file.
pub fn known(path: &Path) -> Result<Known> {
    let name = path.display().to_string();
    let mut reader = csv::Reader::from_path(path).with_context(|| name.clone())?;
    let header = reader.headers()?.clone();
    let place = |column: &str| {
        let place = header.iter().position(|name| name == column);
        place.with_context(|| format!("{name}: lacks the column `{column}`"))
    };
    let places = [STRING, EXACT_LIMIT, UNCERTAINTY, NOTE].map(place);
    let [string, limit, uncertainty, note] = places;
    let (string, limit, uncertainty, note) = (string?, limit?, uncertainty?, note?);
    let mut known = Known::new();
    for row in reader.records() {
        let row = row.with_context(|| name.clone())?;
        let truth = match (row[limit].parse(), row[uncertainty].parse()) {
            (Ok(limit), Ok(uncertainty)) => Ok(Truth { limit, uncertainty }),
            _ => Err(row[note].to_owned()),
        };
        let number = row[string].parse();
        known.insert(
            number.with_context(|| format!("{name}: `{STRING}`"))?,
            truth,
        );
    }
    Ok(known)
}

/// Errors up to this are counted as good.
const GOOD: f64 = 0.05;

/// How many limits are good, by method and rule, for each family and surface.
pub fn summary(found: &[Found]) -> String {
    let mut groups: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    let mut unknown = 0;
    for one in found {
        let Some(error) = one.error() else {
            unknown += 1;
            continue;
        };
        let by = format!("{}, {} frequency", one.method, one.rule.name());
        for of in ["all strings", one.problem.shape, one.problem.surface] {
            let group = groups.entry(format!("{by}, {of}")).or_default();
            group.push(error.abs());
        }
    }
    let line = |(name, errors): (&String, &Vec<f64>)| {
        let good = errors.iter().filter(|error| **error <= GOOD).count();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        let worst = if worst.is_finite() {
            format!("{:.0} %", 100.0 * worst)
        } else {
            "not near".to_owned()
        };
        format!(
            "{name}: {good} of {} within 5 % ({:.0} %), the worst {worst}\n",
            errors.len(),
            100.0 * good as f64 / errors.len() as f64
        )
    };
    let lines: String = groups.iter().map(line).collect();
    lines + &format!("{unknown} limits where the exact one is not known well enough\n")
}
