//! Output on the standard and error streams. Control sequences are removed, from any file that the
//! text comes from.

use std::io::{ErrorKind, Write};

use anyhow::{Context, Result};
use serde_json::json;

use crate::cli::{Command, LogFormat};
use campaign::printable::{printable, printable_json};

/// A text in which no line is a command of a GitHub workflow, which follows those in the output of
/// any program, be it in the name of a file.
fn without_commands(text: &str) -> String {
    let lines = text.split_inclusive('\n');
    let plain = lines.map(|line| match line.trim_start().starts_with("::") {
        true => line.replacen("::", "\\u{3a}:", 1),
        false => line.to_owned(),
    });
    plain.collect()
}

/// Prints lines to standard output.
///
/// # Errors
/// Where it cannot be written.
pub fn say(text: &str) -> Result<()> {
    say_commands(&without_commands(text))
}

/// Prints lines, commands of a GitHub workflow among them, to standard output. A reader who has seen
/// enough (`sweep inspect FILE | head -1`) is no error, and no reason to panic.
///
/// # Errors
/// Where it cannot be written.
pub fn say_commands(text: &str) -> Result<()> {
    let mut output = std::io::stdout().lock();
    match output
        .write_all(printable(text).as_bytes())
        .and_then(|()| output.flush())
    {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("standard output cannot be written"),
    }
}

/// The error stream: lines for people, or one JSON object a line.
#[derive(Debug, Clone, Copy)]
pub struct Terminal {
    format: LogFormat,
}

impl Terminal {
    /// As a command wants it.
    pub fn of(command: &Command) -> Self {
        let format = match command {
            Command::Run(arguments) => arguments.log,
            _ => LogFormat::Text,
        };
        Self { format }
    }

    /// Whether programs read it.
    pub fn is_json(self) -> bool {
        self.format == LogFormat::Json
    }

    /// Prints a line, where anybody listens.
    pub fn complain(self, line: &str) {
        if self.is_json() {
            self.tell(&json!({ "event": "message", "text": line }));
        } else {
            let _ = writeln!(std::io::stderr(), "{}", printable(&without_commands(line)));
        }
    }

    /// Prints an event for programs.
    pub fn tell(self, event: &serde_json::Value) {
        let json = event.to_string();
        let _ = writeln!(std::io::stderr(), "{}", printable_json(&json));
    }
}
