//! Help, pipes that close and disks that fill.

use std::io::Read;
use std::process::Stdio;

use crate::command_line::check::with_reference;
use crate::command_line::{run, succeeds, text};
use crate::support::{SMALL, Workplace, with, without_coarse_sampling};

#[test]
fn every_command_shows_an_example() {
    let place = Workplace::new();
    let help = succeeds(&place, &["--help"]).output;
    for command in [
        "new",
        "run",
        "check",
        "simulate",
        "inspect",
        "plot",
        "merge",
        "man",
        "completions",
        "report",
        "summary",
        "study",
    ] {
        assert!(help.contains(&format!("\n  {command} ")), "{help}");
        let help = succeeds(&place, &[command, "--help"]).output;
        let example = format!("sweep {command} ");
        let after = help
            .split("Example")
            .nth(1)
            .unwrap_or_else(|| panic!("{help}"));
        assert!(after.contains(&example), "{help}");
    }
    assert!(
        succeeds(&place, &["--version"])
            .output
            .starts_with("sweep ")
    );
}

/// `sweep inspect FILE | head -1` closes the pipe while there is more to say.
#[test]
fn a_reader_who_leaves_early_is_no_error() {
    let place = with_reference();
    let wrong = text(&place, "reference.csv")
        .replace("smooth", "stuck")
        .replace("stick_slip", "stuck");
    place.write("wrong.csv", wrong);
    for (arguments, code) in [
        (&["inspect", "small.toml"][..], 0),
        (&["simulate", "small.toml"], 0),
        (&["run", "small.toml"], 0),
        (&["run", "small.toml", "--dry-run"], 0),
        (&["plot", "results"], 0),
        (&["check", "small.toml", "wrong.csv"], 5),
        (&["--help"], 0),
    ] {
        let mut child = place
            .command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut errors = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut errors)
            .unwrap();
        assert_eq!(
            child.wait().unwrap().code(),
            Some(code),
            "{arguments:?}: {errors}"
        );
        let errors = without_coarse_sampling(&errors);
        assert_eq!(errors, "", "{arguments:?}");
    }
    assert!(place.path("results/small/inspect.png").exists());
}

#[test]
fn a_closed_error_stream_changes_no_exit_code() {
    let place = Workplace::with_small(&with(SMALL, "time_s = 12", "time_s = -12"));
    let mut child = place
        .command(&["run", "small.toml"])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stderr.take());
    assert_eq!(child.wait().unwrap().code(), Some(2));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let place = Workplace::with_small(SMALL);
    let full = std::fs::File::options()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let output = place
        .command(&["inspect", "small.toml"])
        .stdout(full)
        .output()
        .unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(
        errors.contains("standard output cannot be written"),
        "{errors}"
    );
    assert!(errors.contains("No space left"), "{errors}");
}

/// Titles, labels and methods of a folder that somebody else made.
#[test]
fn nothing_of_a_foreign_folder_steers_the_terminal() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    let evil = "\u{1b}[2J\u{9b}31m\u{7}\u{202e}gnp";
    let mut manifest = crate::command_line::manifest(&place, "results");
    manifest["title"] = evil.into();
    // A user who changes labels may leave out their checksums.
    manifest.as_object_mut().unwrap().remove("files").unwrap();
    place.write("results/manifest.json", manifest.to_string());
    place.write(
        &format!("{evil}.toml"),
        with(SMALL, "kind = \"grid\"", "kind = \"x\""),
    );
    let summary = place.sweep(&["summary", "results"]).output;
    assert!(
        summary.contains("\\u{1b}[2J\\u{9b}31m\\u{7}\\u{202e}gnp"),
        "{summary}"
    );
    // A word that is no regime is named with its line.
    let labels = text(&place, "results/labels.csv").replace("stick_slip", evil);
    place.write("results/labels.csv", labels);
    let errors = place.sweep(&["summary", "results"]).errors;
    assert!(
        errors.contains("labels.csv:") && errors.contains("gnp` is no torsion regime"),
        "{errors}"
    );
    let strange = format!("{evil}.toml");
    for arguments in [
        &["summary", "results"][..],
        &["report", "results"],
        &["plot", "results"],
        &["run", &strange],
        &["run", "small.toml", "--out", "results", "--log", "json"],
        &["summary", evil],
    ] {
        let answer = place.sweep(arguments);
        let shown = answer.output + &answer.errors;
        let steers = |letter: char| (letter.is_control() && letter != '\n') || letter == '\u{202e}';
        assert!(!shown.contains(steers), "{arguments:?}: {shown:?}");
    }
}
