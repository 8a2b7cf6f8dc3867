//! `sweep study stability`: where methods fail, and whether their margins predict it.

mod chart;
mod table;

use anyhow::{Result, bail};

use super::csv_table::csv_table;
use super::drawing::save_picture;
use super::folder::make_folder;
use super::progress::Progress;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::StabilityArguments;
use chart::chart;
use results::files::write_atomically;
use studies::scenes::Loss;
use studies::stability::{Cell, Family, cells, run};
use table::{columns, summary};

/// Computes the atlas and writes its table and chart.
pub fn stability(arguments: &StabilityArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    make_folder(&arguments.out)?;
    let loss = Loss::in_mud(arguments.in_mud);
    let has_loss = |family: &Family| loss == Loss::Constants || *family != Family::Sections;
    if !arguments.family.iter().all(has_loss) {
        bail!(UsageError(
            "--in-mud: the strings of `sections` have no mud: leave that family out".to_owned()
        ));
    }
    let is_wanted = |family: &Family| {
        has_loss(family) && (arguments.family.is_empty() || arguments.family.contains(family))
    };
    let cells: Vec<Cell> = (Family::all().iter().copied())
        .filter(is_wanted)
        .flat_map(cells)
        .collect();
    let progress = Progress::new(cells.len(), 0, arguments.quiet, terminal);
    let entries = run(&cells, loss, &|| progress.tick());
    progress.finish();
    let entries = entries?;
    let table = csv_table(entries.iter().map(columns))?;
    write_atomically(&arguments.out.join("stability.csv"), &table)?;
    save_picture(&arguments.out, "stability", &chart(&entries))?;
    if !arguments.quiet {
        say(&summary(&entries))?;
    }
    Ok(Status::Complete)
}
