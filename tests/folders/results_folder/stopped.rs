//! Commands that are stopped in the middle of a file, by a limit of the size of files: they say so,
//! leave nothing half written, and the next does what they did not. (Killed without a word they are
//! in `interruption`.)

use std::process::Command;

use crate::results_folder::{FILES, RUN, copy, read, run_shards, succeeds, with_results};
use crate::support::Workplace;

/// Limits of file size, in bytes, that stop different files: the log's header, a table, the
/// manifest, a picture, a page.
const LIMITS: [usize; 6] = [512, 1024, 2048, 4096, 16 << 10, 64 << 10];

/// Whether a command was stopped when it wrote a file larger than the limit, with its reason.
fn is_stopped(place: &Workplace, limit: usize, arguments: &[&str]) -> bool {
    let output = Command::new("sh")
        .arg("-c")
        // POSIX counts blocks of 512 bytes.
        .arg(format!(
            "ulimit -c 0; ulimit -f {}; exec \"$0\" \"$@\"",
            limit / 512
        ))
        .arg(place.command(&[]).get_program())
        .args(arguments)
        .current_dir(place.path(""))
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    let is_reported = output.status.code() == Some(1) && errors.contains("File too large");
    assert!(output.status.success() || is_reported, "{output:?}");
    !output.status.success()
}

/// Names that no finished command leaves.
fn left(place: &Workplace, folder: &str) -> Vec<String> {
    let names = std::fs::read_dir(place.path(folder)).unwrap();
    names
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.starts_with('.'))
        .collect()
}

#[track_caller]
fn same(place: &Workplace, one: &str, other: &str) {
    for name in FILES {
        let [one, other] = [one, other].map(|folder| read(place, &format!("{folder}/{name}")));
        assert!(one == other, "{name}");
    }
    assert_eq!(left(place, other), [""; 0]);
}

/// A line of the log may be torn.
#[track_caller]
fn continues(place: &Workplace, run: &[&str]) {
    let answer = place.sweep(run);
    assert_eq!(answer.code, 0, "{answer:?}");
}

#[test]
fn a_run_stopped_in_any_file_leaves_nothing() {
    let place = with_results();
    for limit in LIMITS {
        let run = ["run", "small.toml", "--out", "other"];
        assert!(is_stopped(&place, limit, &run), "{limit}");
        assert_eq!(left(&place, "other"), [""; 0], "{limit}");
        continues(&place, &run);
        same(&place, "results", "other");
        // Stopped again, from nothing, over results.
        let fresh = [&run[..], &["--fresh"]].concat();
        assert!(is_stopped(&place, limit, &fresh), "{limit}");
        continues(&place, &run);
        same(&place, "results", "other");
        std::fs::remove_dir_all(place.path("other")).unwrap();
    }
}

#[test]
fn a_merge_stopped_in_any_file_can_be_done_again() {
    let place = with_results();
    run_shards(&place);
    for limit in LIMITS {
        let merge = ["merge", "0", "1", "--out", "other"];
        assert!(is_stopped(&place, limit, &merge), "{limit}");
        succeeds(&place, &merge);
        same(&place, "results", "other");
        std::fs::remove_dir_all(place.path("other")).unwrap();
    }
}

#[test]
fn a_stopped_plot_or_report_leaves_nothing() {
    let place = with_results();
    for stopped in ["plot", "report"] {
        for next in [&["plot", "results"][..], &["report", "results"], &RUN] {
            copy(&place, "results", "kept");
            assert!(is_stopped(&place, 4096, &[stopped, "results"]));
            assert_eq!(left(&place, "results"), [""; 0], "{stopped}");
            succeeds(&place, next);
            same(&place, "kept", "results");
            std::fs::remove_dir_all(place.path("kept")).unwrap();
        }
    }
    // As a command that is killed leaves it.
    place.write("results/.sweep-lock", "");
    succeeds(&place, &RUN);
    assert_eq!(left(&place, "results"), [""; 0]);
}

/// What a killed command was writing goes with the next file that is written there.
#[test]
fn what_a_killed_command_left_is_removed_by_any_that_writes() {
    let place = with_results();
    for command in [
        &["simulate", "small.toml", "--case", "0", "--out", "results"][..],
        &["inspect", "small.toml", "--out", "results"],
        &["plot", "results"],
    ] {
        place.write("results/.tmp-sweep-Ab12Cd", "half");
        succeeds(&place, command);
        assert_eq!(left(&place, "results"), [""; 0], "{command:?}");
    }
}
