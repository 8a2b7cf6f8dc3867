//! `sweep completions` and `sweep man`: what a shell and `man` want to know of
//! the command line, made from its definition.

use anyhow::{Context, Result};
use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;

use super::status::{Status, UsageError};
use super::terminal::say;
use crate::cli::Cli;

/// Prints a script that completes the command line.
pub fn completions(shell: Shell) -> Result<Status> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "sweep", &mut script);
    print(script)
}

/// Prints the manual page of the program, or of one of its commands.
pub fn man(command: Option<&str>) -> Result<Status> {
    let mut program = Cli::command();
    program.build();
    let page = match command {
        None => &program,
        Some(name) => program
            .find_subcommand(name)
            .ok_or_else(|| UsageError(format!("there is no command `{name}`")))?,
    };
    let mut text = Vec::new();
    Man::new(page.clone())
        .source(crate::program::PROGRAM)
        .render(&mut text)?;
    print(text)
}

fn print(text: Vec<u8>) -> Result<Status> {
    say(&String::from_utf8(text).context("the text is not UTF-8")?)?;
    Ok(Status::Complete)
}
