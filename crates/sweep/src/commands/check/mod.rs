//! `sweep check`: the regression of regime labels.

mod comparison;
mod junit;
mod reference;
mod report;

use std::collections::BTreeMap;
use std::sync::Mutex;

use anyhow::Result;
use serde_json::json;

use super::choosing::choose;
use super::document::document;
use super::input::read_text;
use super::listed::Listed;
use super::margin::margin_of;
use super::outputs::{Output, refuse_to_lose};
use super::status::Status;
use super::terminal::{Terminal, say, say_commands};
use super::threads::use_threads;
use super::warnings::warn_of_memory;
use crate::cli::{CheckArguments, CheckFormat};
use campaign::Campaign;
use campaign::plan::Sweep;
use campaign::printable::printable;
use campaign::records::Record;
use comparison::{FoundRecords, compare};
use junit::junit_of_error;
use reference::{cases_of, read_reference};
use report::{CheckReport, annotation};
use results::files::write_atomically;

/// Reruns the cases of a reference file and compares their labels. What ends it before there is any
/// is said in the format asked for, too: an output of an earlier check does not outlive it.
pub fn check(arguments: &CheckArguments, terminal: Terminal) -> Result<Status> {
    refuse_to_lose_output(arguments)?;
    let checked = compare_labels(arguments, terminal);
    if let Err(error) = &checked {
        let (reference, message) = (&arguments.reference, format!("{error:#}"));
        let format = arguments.output.format();
        let text = match format {
            CheckFormat::Human => format!("error: {message}\n"),
            CheckFormat::Github => annotation(&arguments.file, &message),
            CheckFormat::Junit => junit_of_error(reference, &message)?,
            CheckFormat::Json => document("check", &json!({ "error": message }))?,
        };
        match &arguments.output.output {
            Some(file) => write_atomically(file, printable(&text).as_bytes())?,
            // It is on standard error.
            None if matches!(format, CheckFormat::Human | CheckFormat::Json) => {}
            None if format == CheckFormat::Github => say_commands(&text)?,
            None => say(&text)?,
        }
    }
    checked
}

/// Refuses to write over what no check has written.
fn refuse_to_lose_output(arguments: &CheckArguments) -> Result<()> {
    let Some(path) = &arguments.output.output else {
        return Ok(());
    };
    let count = format!("{}: ", arguments.reference.display());
    let beginnings: [&[u8]; 7] = [
        b"<?xml",
        b"{\"command\":\"check\",",
        b"::error ",
        b"labels: ",
        b"case ",
        b"error: ",
        count.as_bytes(),
    ];
    let force = arguments.output.overwrite.force;
    refuse_to_lose(path, Output::Beginning(&beginnings), force)
}

fn compare_labels(arguments: &CheckArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    warn_of_memory(&arguments.memory, terminal);
    let limit = arguments.memory.limit();
    let campaign = Campaign::open(&arguments.file, &[], &read_text)?;
    let Campaign { sweep } = choose(campaign, false, &limit, false, terminal)?;
    let (reference, methods) = read_reference(&arguments.reference, &arguments.file, &sweep)?;
    let cases = cases_of(&sweep, &reference, &arguments.reference)?;
    let numbers: Vec<usize> = cases.keys().copied().collect();
    let sweep = Sweep { methods, ..sweep };
    let listed = Listed::new(
        sweep,
        cases.into_values().collect(),
        &arguments.reference,
        &limit,
        terminal,
    )?;
    let found = run_all(&listed, &numbers, terminal)?;
    let compared = compare(&listed.sweep, &listed.systems, &reference, &found);
    let report = CheckReport {
        reference: &arguments.reference,
        margin: margin_of(&arguments.reference)?,
        compared: &compared,
    };
    let format = arguments.output.format();
    let text = report.in_format(format)?;
    match &arguments.output.output {
        Some(file) => {
            write_atomically(file, printable(&text).as_bytes())?;
            say(&report.for_people())?;
        }
        None if format == CheckFormat::Github => say_commands(&text)?,
        None => say(&text)?,
    }
    let differs = report.different().next().is_some();
    Ok(if differs {
        Status::LabelsDiffer
    } else {
        Status::Complete
    })
}

/// The rows of all cases, by the reference's numbers and by method.
fn run_all(listed: &Listed, numbers: &[usize], terminal: Terminal) -> Result<FoundRecords> {
    let found = Mutex::new(BTreeMap::new());
    let keep = |record: Record| {
        if let Ok(mut found) = found.lock() {
            let method = listed.sweep.methods[record.method].name();
            found.insert((numbers[record.case], method), record);
        }
        Ok(())
    };
    listed.run(&|_, _| true, &keep, terminal)?;
    Ok(found.into_inner().unwrap_or_default())
}
