//! `sweep analyse`: how often each regime occurs in a results folder, how sure that is, and which
//! axis decides.

mod picture;
mod table;

use anyhow::{Result, bail};

use super::folder::tables_of;
use super::outputs::{Output, refuse_to_lose};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::cli::{AnalyseArguments, PictureFile};
use crate::report::{analysed_sections, text};
use campaign::quantities::Axis;
use picture::{draw, refuse_absent, refuse_several};
use results::analysis::{blocks, count_cases, size_of_blocks};
use results::files::write_atomically;
use results::folder::ResultTables;
use table::{COUNTS, INDICES, counts_csv, indices_csv};

/// Refuses to write over what this command has not written.
fn refuse_to_lose_any(arguments: &AnalyseArguments) -> Result<()> {
    let force = arguments.overwrite.force;
    let picture = arguments.picture.as_ref().map(|picture| match picture {
        PictureFile::Svg(path) => (path, Output::Beginning(&[b"<svg"])),
        PictureFile::Png(path) => (path, Output::Beginning(&[b"\x89PNG"])),
    });
    let counts = arguments.out.as_ref();
    let indices = arguments.indices.as_ref();
    let (of_counts, of_indices) = ([COUNTS.as_bytes()], [INDICES.as_bytes()]);
    let files = [
        counts.map(|path| (path, Output::Beginning(&of_counts))),
        indices.map(|path| (path, Output::Beginning(&of_indices))),
        picture,
    ];
    for (path, output) in files.into_iter().flatten() {
        refuse_to_lose(path, output, force)?;
    }
    Ok(())
}

/// Counts, and says what came out.
pub fn analyse(arguments: &AnalyseArguments, terminal: Terminal) -> Result<Status> {
    refuse_to_lose_any(arguments)?;
    let tables = (arguments.folders.iter())
        .map(|folder| tables_of(folder, terminal))
        .collect::<Result<Vec<_>>>()?;
    reject_foreign_folders(arguments, &tables)?;
    let manifest = &tables[0].manifest;
    if manifest.is_trace() {
        let name = arguments.folders[0].display();
        bail!(UsageError(format!(
            "{name} holds a trace: its cases lie along limits, and their fractions say nothing of \
             the map; limits.csv and bands.csv do"
        )));
    }
    if tables.iter().all(|tables| tables.manifest.tally.rows == 0) {
        let name = arguments.folders[0].display();
        bail!(UsageError(format!("{name} has no case to count yet")));
    }
    if arguments.indices.is_some() && size_of_blocks(manifest).is_none() {
        bail!(UsageError(
            "--indices: they need cases in blocks; `kind = \"sensitivity\"` makes \
             such"
                .to_owned()
        ));
    }
    refuse_several(arguments)?;
    let sets = sets_of_axes(arguments, &manifest.axes)?;
    let counted = count_cases(&tables, &sets, usize::from(arguments.bins))?;
    let blocks = blocks(&tables)?;
    let width = arguments.width;
    let so_far = tables.iter().find_map(|tables| tables.so_far);
    let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
    let title = format!("{}: {}{so_far}", manifest.name, manifest.title);
    // Counts over the axes of `--by` are the last.
    let drawn = arguments.picture.as_ref().zip(counted.last());
    if let Some((_, counts)) = drawn {
        refuse_absent(arguments.regime, counts)?;
    }
    let sections = analysed_sections(manifest, &counted, &blocks, width);
    say(&text(&title, &sections))?;
    if let Some(path) = &arguments.out {
        write_atomically(path, counts_csv(&counted).as_bytes())?;
        say(&format!("{}\n", path.display()))?;
    }
    if let Some(path) = &arguments.indices {
        write_atomically(path, indices_csv(&manifest.axes, &blocks).as_bytes())?;
        say(&format!("{}\n", path.display()))?;
    }
    if let Some((file, counts)) = drawn {
        draw(file, arguments.regime, manifest, &so_far, counts)?;
    }
    Ok(Status::Complete)
}

/// Folders are counted together if they are different parts of one sweep.
fn reject_foreign_folders(arguments: &AnalyseArguments, tables: &[ResultTables]) -> Result<()> {
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
        if let Some(unknown) = axes.0.iter().find(|axis| !known.contains(axis)) {
            let names: Vec<String> = known.iter().map(|axis| axis.name()).collect();
            bail!(UsageError(format!(
                "--by: the cases do not differ in {}; they do in {}",
                unknown.name(),
                names.join(", ")
            )));
        }
        sets.push(axes.0.clone());
    }
    Ok(sets)
}
