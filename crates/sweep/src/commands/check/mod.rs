//! `sweep check`: the regression of regime labels.

mod comparison;
mod junit;
mod reference;
mod told;

use std::collections::BTreeMap;
use std::sync::Mutex;

use anyhow::Result;

use super::choosing::choose;
use super::margin::margin_of;
use super::prepare::{build_systems, survey_cases};
use super::progress::Progress;
use super::status::Status;
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::{warn_of_memory, warn_of_unstable};
use crate::cli::CheckArguments;
use crate::design::{Design, List};
use crate::engine::{MethodSystem, Record, RunOptions, Shard, Work};
use crate::files::write_atomically;
use crate::memory::{Purpose, admit};
use crate::plan::Sweep;
use crate::quantities::Axis;
use comparison::{Found, compare};
use reference::{cases_of, read_reference};
use told::Told;

/// Reruns the cases of a reference file and compares their labels.
pub fn check(arguments: &CheckArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    warn_of_memory(&arguments.memory, terminal);
    let limit = arguments.memory.limit();
    let sweep = Sweep::read(&arguments.file)?;
    let sweep = choose(sweep, false, &limit, false, terminal)?;
    let (reference, methods) = read_reference(&arguments.reference, &arguments.file, &sweep)?;
    let cases = cases_of(&sweep, &reference, &arguments.reference)?;
    let numbers: Vec<usize> = cases.keys().copied().collect();
    let axes = sweep.design.axes().to_vec();
    let weight_pushes = sweep.changes_string(Axis::WeightOnBitKn);
    let sweep = Sweep {
        methods,
        design: Design::List(List::new(
            axes,
            cases.into_values().collect(),
            weight_pushes,
        )),
        ..sweep
    };
    let survey = survey_cases(&arguments.reference, &sweep)?;
    let setting = sweep.setting.for_labels();
    let memory = admit(&sweep, &setting, &survey, Purpose::Labels, &limit)?;
    let systems = build_systems(&arguments.file, &sweep, &setting, survey.longest)?;
    warn_of_unstable(&systems, terminal);
    let found = run_all(&sweep, &systems, &numbers, memory.strings_at_once, terminal)?;
    let compared = compare(&sweep, &systems, &reference, &found);
    let told = Told {
        reference: &arguments.reference,
        margin: margin_of(&arguments.reference)?,
        compared: &compared,
    };
    let text = told.in_format(arguments.told.format)?;
    match &arguments.told.output {
        Some(file) => {
            write_atomically(file, text.as_bytes())?;
            say(&told.for_people())?;
        }
        None => say(&text)?,
    }
    let differs = told.different().next().is_some();
    Ok(if differs {
        Status::LabelsDiffer
    } else {
        Status::Complete
    })
}

/// The rows of all cases, by the reference's numbers and by method.
fn run_all(
    sweep: &Sweep,
    systems: &[MethodSystem],
    numbers: &[usize],
    strings_at_once: usize,
    terminal: Terminal,
) -> Result<Found> {
    let found = Mutex::new(BTreeMap::new());
    let progress = Progress::new(numbers.len() * systems.len(), 0, false, terminal);
    let work = Work {
        sweep,
        shard: Shard::WHOLE,
        options: RunOptions {
            full: false,
            allow_unstable: true,
        },
        strings_at_once,
        is_open: &|_, _| true,
        stops: &|| false,
    };
    let keep = |record: Record| {
        if let Ok(mut found) = found.lock() {
            let method = sweep.methods[record.method].name();
            found.insert((numbers[record.case], method), record);
        }
        progress.tick();
        Ok(())
    };
    work.run(systems, &keep)?;
    progress.finish();
    Ok(found.into_inner().unwrap_or_default())
}
