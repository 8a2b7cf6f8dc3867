//! `sweep completions` and `sweep man`: what a shell and `man` want to know of
//! the command line, made from its definition.

use anyhow::{Context, Result};
use clap::{CommandFactory, Subcommand};
use clap_complete::Shell;
use clap_mangen::Man;

use super::status::{Status, UsageError};
use super::terminal::say;
use crate::cli::{Cli, Study};

/// Prints a script that completes the command line.
pub fn completions(shell: Shell) -> Result<Status> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "sweep", &mut script);
    print(script)
}

/// Prints the manual page of the program, or of one of its commands, by its words: those of a
/// study may leave `study` out.
pub fn man(command: &[String]) -> Result<Status> {
    let mut program = Cli::command();
    program.build();
    let mut page = &program;
    if command
        .first()
        .is_some_and(|name| Study::has_subcommand(name))
    {
        page = page.find_subcommand("study").unwrap_or(page);
    }
    for name in command {
        page = page
            .find_subcommand(name)
            .ok_or_else(|| UsageError(format!("there is no command `{name}`")))?;
    }
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
