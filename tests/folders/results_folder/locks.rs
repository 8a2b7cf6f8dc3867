//! A file system without locks, played by a library that takes the place of the
//! system's call.

use std::path::PathBuf;
use std::process::Command;

use crate::results_folder::{read, succeeds};
use crate::support::{SMALL, Workplace, without_smeared_fronts};

/// A library whose locks all fail, made by the compiler that links Rust's programs.
fn library(place: &Workplace, error: &str) -> PathBuf {
    place.write(
        "flock.c",
        format!(
            "#include <errno.h>\n\
             int flock(int file, int operation) {{ errno = {error}; return -1; }}\n"
        ),
    );
    let library = place.path("flock.so");
    let status = Command::new("cc")
        .args(["-shared", "-fPIC", "-w", "-o"])
        .args([&library, &place.path("flock.c")])
        .status()
        .unwrap();
    assert!(status.success());
    library
}

#[test]
fn a_file_system_without_locks_is_warned_of_and_the_run_continues() {
    let place = Workplace::with_small(SMALL);
    succeeds(&place, &["run", "small.toml", "--out", "whole"]);
    // Of a kernel, of a network file system, of a file system.
    for error in ["ENOSYS", "ENOLCK", "EOPNOTSUPP"] {
        let library = library(&place, error);
        let sweep = |arguments: &[&str]| {
            let output = place
                .command(arguments)
                .env("LD_PRELOAD", &library)
                .output()
                .unwrap();
            let errors = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(0), "{errors}");
            errors
        };
        for arguments in [
            &["run", "small.toml", "--out", error][..],
            &["plot", error],
            &["report", error],
        ] {
            let errors = sweep(arguments);
            let warning = format!("warning: the file system of {error} has no locks (");
            assert!(errors.starts_with(&warning), "{errors}");
            let errors = without_smeared_fronts(&errors);
            assert_eq!(errors.lines().count(), 1, "{errors}");
        }
        // What is only read needs none.
        assert_eq!(sweep(&["summary", error]), "");
        let labels = |folder: &str| read(&place, &format!("{folder}/labels.csv"));
        assert!(labels("whole") == labels(error));
    }
}
