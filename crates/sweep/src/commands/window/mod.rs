//! `sweep window`: where, over weight on bit and surface speed, no limit is near, and the best
//! point there.

mod lateral;
mod simulated;
mod tables;
mod words;

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use super::drawing::save_picture;
use super::folder::{make_folder, results_folder, tables_of};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::WindowArguments;
use crate::map::{WindowView, window_picture};
use campaign::plan::Sweep;
use campaign::text_file::read_text;
use results::files::write_atomically;
use results::folder::{ResultTables, differences};
use results::window::{AXES, Chart};

/// Draws the window, and says what came out.
pub fn window(arguments: &WindowArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    let sweep = Sweep::read_from(&arguments.file, &[], &read_text)?;
    let own = results_folder(None, &sweep);
    let folders = match &arguments.folders[..] {
        [] => vec![own],
        folders => folders.to_vec(),
    };
    let mut all = Vec::with_capacity(folders.len());
    for folder in folders {
        let tables = tables_of(&folder, terminal)?;
        reject_foreign_folders(&sweep, &arguments.file, &folder, &tables)?;
        all.push((folder, tables));
    }
    let (ranges, mut sources) = simulated::limits(&sweep, &all, arguments)?;
    sources.extend(lateral::limits(&sweep, ranges, arguments)?);
    let chart = Chart::new(ranges, sources);
    let view = WindowView {
        title: title(&sweep, &all),
        units: sweep.content.units,
        regions: chart.safe_regions(),
        best: chart.best(arguments.clearance),
        clearance: arguments.clearance,
        not_examined: lateral::not_examined(&sweep, arguments),
        chart: &chart,
    };
    let folder = arguments.out.clone().unwrap_or_else(|| all[0].0.clone());
    make_folder(&folder)?;
    write_atomically(&folder.join("window.csv"), &tables::window(&chart)?)?;
    save_picture(&folder, "window", &window_picture(&view))?;
    say(&words::describe(&view, &folder))?;
    Ok(Status::Complete)
}

fn title(sweep: &Sweep, all: &[(PathBuf, ResultTables)]) -> String {
    let so_far = all.iter().find_map(|(_, tables)| tables.so_far);
    let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
    format!("{}: operating window{so_far}", sweep.title)
}

/// Keys of what turns, bends and surrounds the string: limits for other values do not apply.
const OF_STRING: [&str; 8] = [
    "string",
    "top_drive",
    "well",
    "mud",
    "axial_force",
    "string_friction",
    "bit",
    "wall",
];

/// Refuses results of another string, and those that do not cover weight and speed.
fn reject_foreign_folders(
    sweep: &Sweep,
    file: &Path,
    folder: &Path,
    tables: &ResultTables,
) -> Result<()> {
    let name = folder.display();
    let manifest = &tables.manifest;
    let [own, its] = [&sweep.content, &manifest.sweep].map(serde_json::to_value);
    let (mut own, mut its) = (own?, its?);
    // A part that the other has not is not modelled there.
    for content in [&mut own, &mut its] {
        if let Some(sections) = content["string"]["sections"].as_array_mut() {
            for section in sections.iter_mut().filter_map(|it| it.as_object_mut()) {
                section.remove("name");
            }
        }
    }
    for key in OF_STRING {
        let (one, other) = (&its[key], &own[key]);
        if one.is_null() || other.is_null() {
            continue;
        }
        if let Some(difference) = differences(one, other).first() {
            bail!(UsageError(format!(
                "{name} and {} are not of one string: {key}.{difference}",
                file.display()
            )));
        }
    }
    if let Some(axis) = AXES.iter().find(|axis| !manifest.axes.contains(axis)) {
        bail!(UsageError(format!(
            "{name}: its cases do not differ in {}, and a window is over that and {}",
            axis.name(),
            AXES.iter()
                .find(|other| other != &axis)
                .map_or_else(String::new, |it| it.name())
        )));
    }
    if manifest.tally.rows == 0 {
        bail!(UsageError(format!("{name} has no case to draw yet")));
    }
    Ok(())
}
