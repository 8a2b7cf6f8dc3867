//! Onsets of growth at the default sampling frequency as a table, and in a few lines.

use std::collections::BTreeMap;

use campaign::words::counted;
use studies::promises::Onset;

/// The columns of the table: their names, and what an onset has there.
pub fn columns(onset: &Onset) -> [(&'static str, String); 13] {
    let (problem, surroundings) = (&onset.problem, onset.problem.surroundings);
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let frequency = onset.resonance.frequency;
    [
        ("string", problem.number.to_string()),
        ("family", problem.shape.to_owned()),
        ("surface", problem.surface.to_owned()),
        ("length_m", problem.length.to_string()),
        (
            "viscosity_cp",
            number(surroundings.map(|around| around.viscosity)),
        ),
        (
            "loss_factor",
            number(surroundings.map(|around| around.loss_factor)),
        ),
        ("rule", onset.steps.name().to_owned()),
        (
            "sampling_frequency_hz",
            onset.sampling_frequency.to_string(),
        ),
        ("resonance_hz", frequency.to_string()),
        (
            "steps_per_period",
            (onset.sampling_frequency / frequency).to_string(),
        ),
        (
            "exact_fall_nms_rad",
            onset.resonance.steepest_fall().to_string(),
        ),
        ("fall_nms_rad", number(onset.fall)),
        ("error", onset.error().to_string()),
    ]
}

/// How far off the onsets are, by rule.
pub fn summary(onsets: &[Onset]) -> String {
    let mut groups: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for onset in onsets {
        let group = groups.entry(onset.steps.name()).or_default();
        group.push(onset.error().abs());
    }
    let line = |(name, errors): (&&str, &Vec<f64>)| {
        let worst = errors.iter().copied().fold(0.0, f64::max);
        let strings = counted(errors.len(), "string");
        format!(
            "steps {name}: on {strings}, the worst {:.1} %\n",
            100.0 * worst
        )
    };
    groups.iter().map(line).collect()
}
