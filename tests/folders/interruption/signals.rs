//! SIGKILL, SIGTERM, Ctrl-C, and two runs at once.

use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::interruption::{finishes, logged, long, same_tables, short};
use crate::support::{Workplace, without_coarse_sampling};

pub const RUN: [&str; 6] = ["run", "small.toml", "--full", "--quiet", "--out", "stopped"];

pub fn start(place: &Workplace, arguments: &[&str]) -> Child {
    place
        .command(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Waits until a run has done something.
pub fn wait_for_rows(place: &Workplace, folder: &str, rows: usize) {
    let start = Instant::now();
    while !place.path(&format!("{folder}/cases.log")).exists() || logged(place, folder) < rows {
        assert!(start.elapsed() < Duration::from_secs(60), "nothing is done");
        sleep(Duration::from_millis(5));
    }
}

pub fn signal(child: &Child, name: &str) {
    let status = std::process::Command::new("kill")
        .args([&format!("-{name}"), &child.id().to_string()])
        .status()
        .unwrap();
    assert!(status.success());
}

#[test]
fn a_run_killed_twenty_times_ends_with_the_same_bytes() {
    let place = Workplace::with_small(&long());
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "whole"],
    );
    let mut killed = 0;
    let mut before = 0;
    for attempt in 0..20u64 {
        let jobs = ["1", "2", "7"][attempt as usize % 3];
        let mut child = start(&place, &[&RUN[..], &["--jobs", jobs]].concat());
        // Moments all over a run: while it builds, while it writes.
        sleep(Duration::from_millis(10 + attempt * attempt * 61 % 180));
        child.kill().unwrap();
        child.wait().unwrap();
        if place.path("stopped/manifest.json").exists() {
            break;
        }
        killed += 1;
        if place.path("stopped/cases.log").exists() {
            // A line that a kill has torn, as it may where a page ends, counts as not there.
            let log = std::fs::read_to_string(place.path("stopped/cases.log")).unwrap();
            let rows = log.matches('\n').count();
            assert!(rows >= before, "{rows} whole lines, but {before} before");
            before = rows;
        }
    }
    assert!(killed >= 8, "only {killed} kills before the end");
    finishes(&place, &RUN);
    assert!(!place.path("stopped/cases.log").exists());
    same_tables(&place, "whole", "stopped");
}

#[test]
fn the_same_bytes_on_one_two_and_seven_threads() {
    let place = Workplace::with_small(&short());
    for jobs in ["1", "2", "7"] {
        let arguments = [
            "run",
            "small.toml",
            "--quiet",
            "--out",
            jobs,
            "--jobs",
            jobs,
        ];
        finishes(&place, &arguments);
    }
    same_tables(&place, "1", "2");
    same_tables(&place, "1", "7");
}

#[test]
fn asked_to_stop_a_run_keeps_what_is_done_and_says_how_to_continue() {
    let place = Workplace::with_small(&long());
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let before = match place.path("stopped/cases.log").exists() {
            true => logged(&place, "stopped"),
            false => 0,
        };
        let child = start(&place, &RUN);
        wait_for_rows(&place, "stopped", before + 5);
        signal(&child, name);
        let output = child.wait_with_output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{errors}");
        let errors = without_coarse_sampling(&errors);
        assert!(errors.starts_with("stopped: "), "{errors}");
        assert!(errors.contains("the same command continues"), "{errors}");
        let done = logged(&place, "stopped");
        assert!(errors.contains(&format!("{done} of 600")), "{errors}");
        // What the run is shown by does not change, and is said once.
        let log = std::fs::read_to_string(place.path("stopped/cases.log")).unwrap();
        assert_eq!(log.matches("\tsweep-run\t").count(), 1);
        let dry = finishes(&place, &[&RUN[..], &["--dry-run"]].concat());
        let left = format!(
            "{} of 600 simulations left: a stopped run continues",
            600 - done
        );
        assert!(dry.output.contains(&left), "{dry:?}");
    }
    let answer = finishes(&place, &[&RUN[..], &["--log", "json"]].concat());
    let first: serde_json::Value =
        serde_json::from_str(answer.errors.lines().next().unwrap()).unwrap();
    assert_eq!(first["event"], "start");
    assert!(first["done"].as_u64().unwrap() >= 10);
    let again = finishes(&place, &["run", "small.toml", "--full", "--out", "stopped"]);
    assert!(again.output.starts_with("complete already"), "{again:?}");
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "whole"],
    );
    same_tables(&place, "whole", "stopped");
}

#[test]
fn two_runs_never_write_one_folder() {
    let place = Workplace::with_small(&long());
    let mut first = start(&place, &RUN);
    wait_for_rows(&place, "stopped", 1);
    for more in [&[][..], &["--fresh"]] {
        let answer = place.sweep(&[&RUN[..], more].concat());
        assert_eq!(answer.code, 1, "{answer:?}");
        assert!(
            answer
                .errors
                .contains("another run is writing stopped/cases.log"),
            "{answer:?}"
        );
    }
    assert!(first.wait().unwrap().success());
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "whole"],
    );
    same_tables(&place, "whole", "stopped");
}
