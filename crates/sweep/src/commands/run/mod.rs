//! `sweep run`: every case, every method, a results folder; from where the last
//! run of the same sweep stopped.

mod cheaper;
mod complete;
mod plan;
mod session;
mod systems;
mod task;

use std::time::Instant;

use anyhow::Result;

use super::folder::{FolderState, LOG, hold, make_folder};
use super::status::Status;
use super::stop;
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::RunArguments;
use complete::show_again;
use session::Session;
use systems::Systems;
use task::Task;

/// Runs a sweep.
pub fn run(arguments: &RunArguments, terminal: Terminal) -> Result<Status> {
    let start = Instant::now();
    use_threads(arguments.work.jobs, terminal)?;
    let task = Task::read(arguments, terminal)?;
    match task.look(arguments.fresh)? {
        found if arguments.dry_run => tell_plan(&task, &found),
        FolderState::Complete(manifest) => show_again(&task, *manifest),
        _ => begin_or_continue(&task, start),
    }
}

fn tell_plan(task: &Task, found: &FolderState) -> Result<Status> {
    let text = plan::describe(task, found, &|| stop::asked().is_some())?;
    if let Some(status) = stop::asked() {
        return Ok(status);
    }
    say(&text)?;
    Ok(Status::Complete)
}

fn begin_or_continue(task: &Task, start: Instant) -> Result<Status> {
    let systems = Systems::build(task)?;
    make_folder(&task.folder)?;
    let lock = hold(&task.folder, LOG, task.terminal)?;
    if let Some(manifest) = task.prepare_log()? {
        drop(lock);
        return show_again(task, *manifest);
    }
    let session = Session::open(task, &systems, start)?;
    session.simulate()?;
    session.finish()
}
