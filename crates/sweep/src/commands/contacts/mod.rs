//! `sweep study contacts`: how much friction whirl needs where a string may touch at more and more
//! places.

mod chart;
mod subjects;
mod table;

use anyhow::{Result, bail};

use super::csv_table::csv_table;
use super::drawing::save_picture;
use super::folder::make_folder;
use super::progress::Progress;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::ContactsArguments;
use campaign::memory::Size;
use chart::chart;
use results::files::write_atomically;
use studies::contacts::{LimitRow, StudiedString, memory, simulations, study};
use subjects::subjects;
use table::{columns, summary};

/// Studies the strings and writes table and chart.
pub fn contacts(arguments: &ContactsArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.work.jobs, terminal)?;
    let subjects = subjects(arguments, terminal)?;
    for subject in &subjects {
        admit(subject, arguments)?;
    }
    make_folder(&arguments.out)?;
    let total = subjects.iter().map(simulations).sum();
    let progress = Progress::new(total, 0, arguments.quiet, terminal);
    let studied: Result<Vec<_>> = (subjects.iter())
        .map(|subject| study(subject, &|| progress.tick()))
        .collect();
    progress.finish();
    let rows: Vec<LimitRow> = studied?.into_iter().flatten().collect();
    write_atomically(
        &arguments.out.join("contacts.csv"),
        &csv_table(rows.iter().map(columns))?,
    )?;
    let lowest = arguments.from_m;
    save_picture(&arguments.out, "contacts_limit", &chart(&rows, lowest))?;
    if !arguments.quiet {
        let place = format!(
            "\ncontacts.csv, contacts_limit.svg and contacts_limit.png are in {}\n",
            arguments.out.display()
        );
        say(&(summary(&rows, lowest) + &place))?;
    }
    if rows.iter().any(|row| row.limit.is_err()) {
        return Ok(Status::SomeFailed);
    }
    Ok(Status::Complete)
}

/// Refuses what takes more memory than there may be.
fn admit(subject: &StudiedString, arguments: &ContactsArguments) -> Result<()> {
    let bytes = memory(subject, linear::parallel::threads())?;
    let limit = arguments.work.memory.limit();
    if bytes > limit.bytes {
        bail!(UsageError(format!(
            "--counts: this number of contacts and samples would take {} of memory by these \
             methods; limit: {limit}",
            Size(bytes)
        )));
    }
    Ok(())
}
