//! `failures.csv`: the cases without an answer, each with its reason and the command
//! that repeats it.

use std::path::Path;

use anyhow::Result;

use crate::engine::RunOptions;

/// The first line of `failures.csv`.
pub const FAILURES_HEADER: &str = "case,method,reason,repeat_with";

/// A row of `failures.csv`.
///
/// # Errors
/// None that a string could cause.
pub fn failures_row(case: usize, method: &str, reason: &str, repeat_with: &str) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([&case.to_string(), method, reason, repeat_with])?;
    Ok(writer.into_inner()?)
}

/// What the command that repeats a case depends on, besides the case.
pub struct Repeat<'a> {
    /// The sweep file, as the run's command named it.
    pub sweep_file: &'a Path,
    /// Whether the sweep asks for an accuracy, which chooses the method, the same again.
    pub chooses_method: bool,
    /// The options of the run.
    pub options: RunOptions,
}

impl Repeat<'_> {
    /// The command that comes to the same row as the run, as a POSIX shell takes it.
    pub fn command(&self, case: usize, method: &str) -> String {
        let file = shell_word(self.sweep_file);
        let mut command = format!("sweep simulate {file} --case {case}");
        if !self.chooses_method {
            command += &format!(" --methods {method}");
        }
        for (given, option) in [
            (self.options.full, " --full"),
            (self.options.allow_unstable, " --allow-unstable"),
        ] {
            command += if given { option } else { "" };
        }
        command
    }
}

/// A path as a shell takes it, and then a command: one that begins with a dash is no
/// option.
fn shell_word(path: &Path) -> String {
    let path = path.display().to_string();
    let dash = if path.starts_with('-') { "./" } else { "" };
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/._-".contains(letter);
    if path.chars().all(is_plain) {
        format!("{dash}{path}")
    } else {
        format!("'{dash}{}'", path.replace('\'', r"'\''"))
    }
}
