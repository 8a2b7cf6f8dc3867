//! Limits and bounds as a table, and in a few lines.

use std::fmt::Write;

use campaign::words::short;
use studies::contacts::{LateralImpulse, LimitRow};

/// The columns of the table: their names, and what a row has there.
pub fn columns(row: &LimitRow) -> [(&'static str, String); 22] {
    let limit = row.limit.as_ref().ok();
    let lasts = limit.and_then(|limit| limit.lasts);
    let whirl = lasts.map(|(_, whirl)| whirl);
    let (kind, struck_at, ratio, per_metre) = match row.impulse {
        LateralImpulse::Local {
            from_bit, ratio, ..
        } => ("knock", Some(from_bit), Some(ratio), None),
        LateralImpulse::Distributed { per_metre, .. } => ("along", None, None, Some(per_metre)),
    };
    [
        ("string", row.string.clone()),
        ("method", row.method.name().to_owned()),
        ("sampling_frequency_hz", row.sampling_frequency.to_string()),
        ("contacts", row.contacts.to_string()),
        ("spacing_m", row.spacing.to_string()),
        ("blow", kind.to_owned()),
        ("knocked_at_m", known(struck_at)),
        ("knock_ratio", known(ratio)),
        ("impulse_n_s_m", known(per_metre)),
        ("impulse_n_s", row.impulse.amount().to_string()),
        (
            "friction_whirls",
            known(lasts.map(|(friction, _)| friction)),
        ),
        (
            "friction_does_not",
            known(limit.and_then(|limit| limit.does_not)),
        ),
        ("scanned_above", known(limit.map(|limit| limit.above))),
        (
            "scanned_above_without_whirl",
            known(limit.map(|limit| limit.above_without)),
        ),
        (
            "precession_turns_per_s",
            known(whirl.map(|whirl| whirl.turns_per_s)),
        ),
        ("site_from_bit_m", known(whirl.map(|whirl| whirl.from_bit))),
        (
            "rolling_fraction",
            known(whirl.map(|whirl| whirl.rolling_fraction)),
        ),
        ("share_touching", known(row.share_touching)),
        ("bound_any_sites", known(row.bounds.any_sites)),
        ("bound_one_site", known(row.bounds.one_site)),
        ("bound_carried", row.bounds.carried.to_string()),
        (
            "note",
            row.limit.as_ref().err().cloned().unwrap_or_default(),
        ),
    ]
}

/// A field that may be empty.
fn known<T: ToString>(value: Option<T>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

/// The name of an impulse, on any string.
pub fn impulse_name(impulse: &LateralImpulse, lowest: f64) -> String {
    match impulse {
        LateralImpulse::Local {
            from_bit, ratio, ..
        } if *from_bit == lowest => {
            format!("{ratio} I₀ at lowest contact")
        }
        LateralImpulse::Local {
            from_bit, ratio, ..
        } => format!("{ratio} I₀ at {from_bit} m"),
        LateralImpulse::Distributed { per_metre, .. } => format!("{per_metre} N s/m all along"),
    }
}

/// The limits, a line for each string, method and impulse and a column for each number of contacts.
pub fn summary(rows: &[LimitRow], lowest: f64) -> String {
    let mut text = String::new();
    let mut lines: Vec<(String, Vec<String>)> = Vec::new();
    let mut counts: Vec<usize> = rows.iter().map(|row| row.contacts).collect();
    counts.sort_unstable();
    counts.dedup();
    for row in rows {
        let name = format!(
            "{}, {}, {}",
            row.string,
            row.method.name(),
            impulse_name(&row.impulse, lowest)
        );
        let limit = match &row.limit {
            Err(_) => "?".to_owned(),
            Ok(limit) => match (&limit.lasts, limit.does_not) {
                (Some((friction, _)), Some(_)) => short_limit(*friction),
                (Some((friction, _)), None) => format!("<{}", short_limit(*friction)),
                (None, _) => "–".to_owned(),
            },
        };
        let place = counts.binary_search(&row.contacts).unwrap_or(0);
        let line = lines.iter().position(|(other, _)| *other == name);
        let line = line.unwrap_or_else(|| {
            lines.push((name, vec![String::new(); counts.len()]));
            lines.len() - 1
        });
        lines[line].1[place] = limit;
    }
    let width = lines.iter().map(|(name, _)| name.chars().count()).max();
    let width = width.unwrap_or(0);
    let mut line = |name: &str, fields: Vec<String>| {
        let fields: String = fields.iter().map(|field| format!(" {field:>6}")).collect();
        let _ = writeln!(text, "{name:<width$}{fields}");
    };
    line("contacts", counts.iter().map(usize::to_string).collect());
    for (name, limits) in lines {
        line(&name, limits);
    }
    text
}

/// Three digits: a bracket is 1 % wide.
fn short_limit(friction: f64) -> String {
    short((friction * 1e3).round() / 1e3)
}
