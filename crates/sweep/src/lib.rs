//! `sweep`: parameter sweeps of drillstring dynamics.
//!
//! ```text
//! my-sweep.toml ──> crate `campaign`  its keys, its cases, and the answer to each
//!                    │
//!                   log      each kept as done
//!                    │
//!                  output    labels.csv, boundary.csv, manifest.json, failures.csv
//!                    │
//!                map         map.svg, map.png, by the crate `plot`; `report` tells what is in the folder,
//!                           `analysis` counts how often and how surely, `window` says
//!                           where no limit is near
//! ```
//!
//! There is no equation here: the string is the business of `linear`, its motion that of
//! `sim`. `studies` hold methods against one another, and choose one where a sweep asks for
//! an accuracy; `histories` shows single cases to their end. `files` writes whole files or
//! none, in folders that are locked meanwhile.
//! `commands` has one file or folder for each thing a user can ask, calls all of the rest,
//! and is called by nothing; `cli` are their arguments. To see it at work:
//!
//! ```sh
//! sweep new my-sweep.toml        # a commented sweep file
//! sweep run my-sweep.toml        # its cases, its map
//! sweep help                     # everything else
//! ```

mod cli;
mod commands;
mod explore;
mod histories;
mod map;
mod program;
mod report;

use std::process::ExitCode;

use cli::{Cli, Command};
use commands::status::Status;
use commands::terminal::Terminal;

/// Does what the arguments of this process ask for.
pub fn main() -> ExitCode {
    let arguments = Cli::of_program();
    let terminal = Terminal::of(&arguments.command);
    let result = commands::stop::listen(terminal).and_then(|()| match arguments.command {
        Command::New {
            file,
            schema,
            force,
        } => commands::new::new(&file, schema, force),
        Command::Run(arguments) => commands::run::run(&arguments, terminal),
        Command::Check(arguments) => commands::check::check(&arguments, terminal),
        Command::Reference(arguments) => commands::reference::reference(&arguments, terminal),
        Command::Simulate(arguments) => commands::simulate::simulate(&arguments, terminal),
        Command::Inspect(arguments) => commands::inspect::inspect(&arguments, terminal),
        Command::Plot(arguments) => commands::plot::plot(&arguments, terminal),
        Command::Merge {
            folders,
            out,
            document,
        } => commands::merge::merge(&folders, &out, document.json, terminal),
        Command::Report(arguments) => commands::report::report(&arguments, terminal),
        Command::Explore(arguments) => commands::explore::explore(&arguments, terminal),
        Command::Summary { folder, document } => {
            commands::report::summary(&folder, document.json, terminal)
        }
        Command::Export(arguments) => commands::export::export(&arguments, terminal),
        Command::Analyse(arguments) => commands::analyse::analyse(&arguments, terminal),
        Command::Window(arguments) => commands::window::window(&arguments, terminal),
        Command::Study(study) => commands::study::study(&study, terminal),
        Command::Schema => commands::schema::schema(),
        Command::Completions { shell } => commands::shell::completions(shell),
        Command::Man { command } => commands::shell::man(&command),
    });
    let status = result.unwrap_or_else(|error| {
        terminal.complain(&format!("error: {error:#}"));
        Status::of(&error)
    });
    status.into()
}
