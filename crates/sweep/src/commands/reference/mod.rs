//! `sweep reference`: of a results folder the cases whose labels are far from changing, as a
//! reference for `check`.

mod neighbours;
mod table;

use sim::Outcome;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result, bail};

use super::choosing::choose;
use super::folder::tables_of;
use super::input::read_text;
use super::listed::Listed;
use super::outputs::{Output, refuse_to_lose};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::warn_of_memory;
use crate::cli::ReferenceArguments;
use campaign::Campaign;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::Record;
use campaign::sweep_file::per_cent;
use campaign::text_file::is_standard_input;
use campaign::words::counted;
use neighbours::{Neighbours, neighbours};
use results::files::write_atomically;
use results::folder::{CaseRows, Manifest, differences, fingerprint, read_cases};
use table::{BEGINNING, reference_table};

/// Makes a reference.
pub fn reference(arguments: &ReferenceArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    warn_of_memory(&arguments.memory, terminal);
    let out = (arguments.out.clone()).unwrap_or_else(|| arguments.folder.join("reference.csv"));
    refuse_to_lose(
        &out,
        Output::Beginning(&[BEGINNING.as_bytes()]),
        arguments.overwrite.force,
    )?;
    let tables = tables_of(&arguments.folder, terminal)?;
    let manifest = &tables.manifest;
    let sweep = sweep_of(manifest, arguments, terminal)?;
    let axes = axes_changed(&sweep, &arguments.along, &arguments.folder)?;
    let labels = tables.folder.join("labels.csv");
    let cases = read_cases(&labels, &manifest.axes)?.collect::<Result<Vec<_>>>()?;
    let of = cases.len();
    let cases: Vec<CaseRows> = cases.into_iter().filter(is_answered).collect();
    let moved = neighbours(&sweep, &cases, &axes, arguments.margin);
    let kept = keeping_their_labels(sweep, cases, moved, arguments, terminal)?;
    let names: Vec<String> = axes.iter().map(|axis| axis.name()).collect();
    let margin = format!("{} % in {}", per_cent(arguments.margin), names.join(", "));
    if kept.is_empty() {
        bail!(UsageError(format!(
            "{}: no case keeps its labels within {margin}: try a smaller --margin",
            arguments.folder.display()
        )));
    }
    let counts = format!(
        "{} of {} kept, {} dropped",
        kept.len(),
        counted(of, "case"),
        of - kept.len()
    );
    let table = reference_table(manifest, &kept, &margin, &counts)?;
    write_atomically(&out, &table)?;
    say(&format!(
        "{counts}: no label of those kept changes within {margin}\n{}\n",
        out.display()
    ))?;
    Ok(Status::Complete)
}

/// The sweep that a folder has results of.
///
/// # Errors
/// Where its file is not there, or says something else by now.
fn sweep_of(
    manifest: &Manifest,
    arguments: &ReferenceArguments,
    terminal: Terminal,
) -> Result<Sweep> {
    let folder = arguments.folder.display();
    let Some(file) = arguments.sweep.as_ref().or(manifest.sweep_file.as_ref()) else {
        bail!(UsageError(format!(
            "{folder}: its manifest.json does not name the sweep file: give --sweep FILE"
        )));
    };
    if is_standard_input(file) && arguments.sweep.is_none() {
        bail!(UsageError(format!(
            "{folder}: its sweep file was read from standard input: give --sweep FILE, or \
             --sweep - for the same text again"
        )));
    }
    if !file.is_file() && !is_standard_input(file) {
        bail!(UsageError(format!(
            "{folder}: its sweep file is not at {}: give --sweep FILE",
            file.display()
        )));
    }
    let sweep = read_as_run(manifest, file, arguments, terminal)?;
    let (before, now) = (
        manifest.fingerprint()?,
        fingerprint(&sweep, manifest.options)?,
    );
    if let Some(difference) = differences(&before, &now).first() {
        bail!(UsageError(format!(
            "{folder} holds results of another sweep than {} has now: {difference}",
            file.display()
        )));
    }
    Ok(sweep)
}

fn read_as_run(
    manifest: &Manifest,
    file: &Path,
    arguments: &ReferenceArguments,
    terminal: Terminal,
) -> Result<Sweep> {
    if manifest.accuracy.is_none() {
        // With the methods of the command, if it named any.
        return Ok(Sweep::read_from(file, &manifest.sweep.methods, &read_text)?);
    }
    let limit = arguments.memory.limit();
    let campaign = Campaign::open(file, &[], &read_text)?;
    Ok(choose(campaign, manifest.options.full, &limit, false, terminal)?.sweep)
}

/// The axes that are changed: of those asked for, or of all, the ones that are no counts.
fn axes_changed(sweep: &Sweep, along: &[Axis], folder: &Path) -> Result<Vec<Axis>> {
    let axes = sweep.design.axes();
    if let Some(unknown) = along.iter().find(|axis| !axes.contains(axis)) {
        bail!(UsageError(format!(
            "{}: its cases do not differ in {}",
            folder.display(),
            unknown.name()
        )));
    }
    let is_wanted = |axis: &&Axis| along.is_empty() || along.contains(axis);
    let wanted = axes.iter().filter(is_wanted).copied();
    let changed: Vec<Axis> = wanted.filter(|axis| !axis.is_counted()).collect();
    if changed.is_empty() {
        bail!(UsageError(format!(
            "{}: no axis of it can be changed by a fraction of its value",
            folder.display()
        )));
    }
    Ok(changed)
}

fn is_answered(case: &CaseRows) -> bool {
    case.rows.iter().all(|row| row.labels.is_answer())
}

/// The cases that have the same labels by every method as their neighbours.
fn keeping_their_labels(
    sweep: Sweep,
    cases: Vec<CaseRows>,
    moved: Neighbours,
    arguments: &ReferenceArguments,
    terminal: Terminal,
) -> Result<Vec<CaseRows>> {
    let Neighbours { of, values } = moved;
    if values.is_empty() {
        return Ok(Vec::new());
    }
    let limit = arguments.memory.limit();
    let listed = Listed::new(sweep, values, &arguments.folder, &limit, terminal)?;
    let changes: Vec<AtomicBool> = cases.iter().map(|_| AtomicBool::new(false)).collect();
    // Of a case that is dropped already nothing more has to be known.
    let is_open = |place: usize, _| !changes[of[place]].load(Ordering::Relaxed);
    let keep = |record: Record| {
        let case = of[record.case];
        let method = listed.sweep.methods[record.method].name();
        let row = cases[case].rows.iter().find(|row| row.method == method);
        let row =
            row.with_context(|| format!("case {} has no row of {method}", cases[case].case))?;
        let found = record.outcome.as_ref().map(Outcome::labels);
        if !found.is_ok_and(|found| found == row.labels) {
            changes[case].store(true, Ordering::Relaxed);
        }
        Ok(())
    };
    listed.run(&is_open, &keep, terminal)?;
    let stays = changes.iter().map(|change| !change.load(Ordering::Relaxed));
    let kept = cases.iter().zip(stays).filter(|(_, stays)| *stays);
    Ok(kept.map(|(case, _)| case.clone()).collect())
}
