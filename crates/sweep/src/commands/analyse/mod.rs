//! `sweep analyse`: how often each regime occurs in a results folder, how sure that is, and which
//! axis decides.

mod description;
mod table;

use anyhow::{Result, bail};

use super::folder::tables_of;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::analysis::{Bins, Counts};
use crate::cli::AnalyseArguments;
use crate::files::write_atomically;
use crate::output::ResultTables;
use crate::quantities::Axis;
use crate::report::text;
use description::sections;
use table::counts_csv;

/// Counts, and says what came out.
pub fn analyse(arguments: &AnalyseArguments, terminal: Terminal) -> Result<Status> {
    let tables = (arguments.folders.iter())
        .map(|folder| tables_of(folder, terminal))
        .collect::<Result<Vec<_>>>()?;
    refuse_strangers(arguments, &tables)?;
    let manifest = &tables[0].manifest;
    if tables.iter().all(|tables| tables.manifest.tally.rows == 0) {
        let name = arguments.folders[0].display();
        bail!(UsageError(format!("{name} has no case to count yet")));
    }
    let sets = sets_of_axes(arguments, &manifest.axes)?;
    let counted = count(arguments, &tables, &sets)?;
    let width = arguments.width;
    let so_far = tables.iter().find_map(|tables| tables.so_far);
    let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
    let title = format!("{}: {}{so_far}", manifest.name, manifest.title);
    let rows = tables.iter().map(|tables| tables.manifest.tally.rows).sum();
    say(&text(&title, &sections(manifest, rows, &counted, width)))?;
    if let Some(path) = &arguments.out {
        write_atomically(path, counts_csv(&counted).as_bytes())?;
        say(&format!("{}\n", path.display()))?;
    }
    Ok(Status::Complete)
}

/// Folders are counted together if they are different parts of one sweep.
fn refuse_strangers(arguments: &AnalyseArguments, tables: &[ResultTables]) -> Result<()> {
    let folders = arguments.folders.iter().zip(tables);
    for (index, (folder, tables)) in folders.clone().enumerate() {
        let manifest = &tables.manifest;
        for (other, its_tables) in folders.clone().take(index) {
            let its = &its_tables.manifest;
            let why = if its.meaning_sha256 != manifest.meaning_sha256 || its.seed != manifest.seed
            {
                "are not of one sweep"
            } else if its.shard.is_none() || its.shard == manifest.shard {
                "hold the same cases"
            } else {
                continue;
            };
            bail!(UsageError(format!(
                "{} and {} {why}: they are not counted together",
                other.display(),
                folder.display()
            )));
        }
    }
    Ok(())
}

/// No axis, each that differs, and what was asked for instead.
fn sets_of_axes(arguments: &AnalyseArguments, known: &[Axis]) -> Result<Vec<Vec<Axis>>> {
    let mut sets = vec![Vec::new()];
    sets.extend(known.iter().map(|&axis| vec![axis]));
    for axes in &arguments.by {
        if let Some(stranger) = axes.0.iter().find(|axis| !known.contains(axis)) {
            let names: Vec<String> = known.iter().map(|axis| axis.name()).collect();
            bail!(UsageError(format!(
                "--by: the cases do not differ in {}; they do in {}",
                stranger.name(),
                names.join(", ")
            )));
        }
        sets.push(axes.0.clone());
    }
    Ok(sets)
}

/// The counts over each set of axes.
fn count(
    arguments: &AnalyseArguments,
    tables: &[ResultTables],
    sets: &[Vec<Axis>],
) -> Result<Vec<Counts>> {
    let manifest = &tables[0].manifest;
    let bins = Bins::along(
        tables,
        &manifest.sweep,
        &manifest.axes,
        usize::from(arguments.bins),
    )?;
    let of_axis = |axis: &Axis| bins.iter().find(|bins| bins.axis == *axis).cloned();
    let sets = sets
        .iter()
        .map(|axes| axes.iter().filter_map(of_axis).collect());
    Counts::of_each(tables, &manifest.method_names(), sets.collect())
}
