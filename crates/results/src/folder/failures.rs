//! `failures.csv`: the cases without an answer, each with its reason and the command
//! that repeats it.

use anyhow::Result;

use super::about::About;
use super::manifest::Manifest;
use campaign::words::file_word;

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

/// The command that reproduces the row of the run, quoted for a POSIX shell.
pub fn repeat_command(about: &About, case: usize, method: &str) -> String {
    let Manifest {
        accuracy, options, ..
    } = &about.manifest;
    let file = file_word(&about.sweep_file);
    let mut command = format!("sweep simulate {file} --case {case}");
    // The accuracy chooses the method, the same again.
    if accuracy.is_none() {
        command += &format!(" --methods {method}");
    }
    for (given, option) in [
        (options.full, " --full"),
        (options.allow_unstable, " --allow-unstable"),
    ] {
        command += if given { option } else { "" };
    }
    command
}
