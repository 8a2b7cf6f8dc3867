//! `sweep`: parameter sweeps of drillstring dynamics.
//!
//! A sweep file (`spec`) names cases (`design`); the `engine` runs them on all
//! cores against linear systems built once; `output` and `plot` make the files of a
//! results folder, `report` tells what is in it. `accuracy` chooses a method where a
//! sweep asks for an accuracy, a `study` looks at the methods themselves. `commands`
//! has one file for each thing a user can ask.

mod accuracy;
mod cli;
mod commands;
mod design;
mod engine;
mod lines;
mod output;
mod plot;
mod report;
mod spec;
mod study;

use std::process::ExitCode;

use clap::Parser;

use cli::{Cli, Command};
use commands::Status;

/// This program: version and, where it is known, commit.
const PROGRAM: &str = concat!("sweep ", env!("SWEEP_VERSION"));

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        Command::Run(arguments) => commands::run::run(&arguments),
        Command::Check(arguments) => commands::check::check(&arguments),
        Command::Simulate(arguments) => commands::simulate::simulate(&arguments),
        Command::Inspect(arguments) => commands::inspect::inspect(&arguments),
        Command::Plot(arguments) => commands::plot::plot(&arguments),
        Command::Merge(arguments) => commands::merge::merge(&arguments),
        Command::Tradeoff(arguments) => commands::tradeoff::tradeoff(&arguments),
        Command::Stability(arguments) => commands::stability::stability(&arguments),
        Command::Report(arguments) => commands::report::report(&arguments),
        Command::Summary(arguments) => commands::report::summary(&arguments),
    };
    result
        .unwrap_or_else(|error| commands::report(&error))
        .into()
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status as u8)
    }
}
