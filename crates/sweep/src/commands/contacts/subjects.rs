//! The strings that are studied, as the command line asks for them.

use std::path::Path;

use anyhow::{Result, bail};

use crate::cli::ContactsArguments;
use crate::commands::prepare::{open, unique};
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use crate::commands::warnings::{warn_of_memory, warn_of_sweep};
use campaign::engine::unused_reason;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use studies::contacts::{Range, StudiedString, StudiedStringError};
use studies::scenes::shipped_by;

/// The strings of the study without a file, by their names.
const SHIPPED: [(&str, &str); 2] = [("paper", "contacts.toml"), ("field", "contacts_12in.toml")];

/// Every string to study.
///
/// # Errors
/// Where the file makes no sense, or what is asked cannot be asked of its string.
pub fn subjects(arguments: &ContactsArguments, terminal: Terminal) -> Result<Vec<StudiedString>> {
    let (work, quiet) = (&arguments.work, arguments.quiet);
    if let Some(file) = &arguments.file {
        let sweep = open(file, work, false, quiet, terminal)?.sweep;
        warn_of_sweep(&sweep, terminal);
        let name = sweep.name.clone();
        return Ok(vec![subject(name, sweep, Some(file), arguments)?]);
    }
    warn_of_memory(&work.memory, terminal);
    let methods = unique(&work.methods);
    let shipped = SHIPPED.into_iter().map(|(name, file)| {
        let sweep = shipped_by(file, &methods)?;
        subject(name.to_owned(), sweep, None, arguments)
    });
    shipped.collect()
}

fn subject(
    name: String,
    sweep: Sweep,
    file: Option<&Path>,
    arguments: &ContactsArguments,
) -> Result<StudiedString> {
    for &(axis, value) in &arguments.set {
        let refusal = match axis {
            Axis::WallAtSite { .. } => Some("the study chooses its own sites".to_owned()),
            Axis::ImpulseRatio => Some("the study chooses its own impulses: --impulses".to_owned()),
            Axis::FRICTION => Some("the study looks for it".to_owned()),
            _ => axis.check(value).err().map(|reason| reason.to_string()),
        };
        let refusal = refusal.or_else(|| unused_reason(&sweep, axis).map(str::to_owned));
        if let Some(refusal) = refusal {
            bail!(UsageError(format!("--set {}: {refusal}", axis.name())));
        }
    }
    let set = arguments.set.iter().copied();
    let values: Vec<(Axis, f64)> = StudiedString::first_values(&sweep).chain(set).collect();
    let to = (arguments.to_m).map_or_else(|| StudiedString::usual_end(&sweep, &values), Ok)?;
    let range = Range {
        from: arguments.from_m,
        to,
    };
    let first_impulse = sweep.content.impulses.first();
    let first_impulse = first_impulse.map(|impulse| impulse.distance_from_bit_m);
    let usual = || {
        [Some(range.from), first_impulse]
            .into_iter()
            .flatten()
            .collect()
    };
    let struck_at: Vec<f64> = arguments.impulse_at.clone().unwrap_or_else(usual);
    let subject = StudiedString {
        name,
        values,
        sweep,
        range,
        counts: unique(&arguments.counts),
        struck_at: unique(&struck_at),
        ratios: unique(&arguments.impulses),
        per_metre: unique(&arguments.impulses_along),
        time: arguments.time_s,
        sampling_frequency: arguments.sampling_hz,
    };
    subject.check().map_err(|error| {
        let place = file.map_or_else(String::new, |file| format!("{}: ", file.display()));
        match error.downcast_ref::<StudiedStringError>() {
            Some(reason) => UsageError(format!("{place}{reason}")).into(),
            None => error,
        }
    })?;
    Ok(subject)
}
