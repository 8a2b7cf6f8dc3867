//! Logs that are torn, damaged, or of something else.

use crate::crc32::crc32;
#[cfg(unix)]
use crate::interruption::long;
#[cfg(unix)]
use crate::interruption::signals::{self, start, wait_for_rows};
use crate::interruption::{finishes, same_tables, short};
use crate::support::{Workplace, with};

const RUN: [&str; 6] = ["run", "small.toml", "--full", "--quiet", "--out", "results"];

/// A place with a whole run, and a stopped one whose log has its first lines.
fn stopped(lines: usize) -> (Workplace, String) {
    let place = Workplace::with_small(&failing_last(&short()));
    let answer = place.sweep(&["run", "small.toml", "--full", "--out", "whole"]);
    assert_eq!(answer.code, 3, "{answer:?}");
    // A run that stops at its last cases, whose strings are invalid.
    let answer = place.sweep(&[&RUN[..], &["--fail-fast", "--jobs", "1"]].concat());
    assert_eq!(answer.code, 1, "{answer:?}");
    let log = std::fs::read_to_string(place.path("results/cases.log")).unwrap();
    let kept: String = log.split_inclusive('\n').take(lines).collect();
    (place, kept)
}

/// An axis of the string whose last value makes no tube.
fn failing_last(text: &str) -> String {
    let text = with(
        text,
        "from = 0.02, to = 0.6, count = 30",
        "values = [0.1, 0.5]",
    );
    with(
        &text,
        "[design.axes]\n",
        "[design.axes]\nsection_0_part_0_inner_radius_m = { values = [0.04, 0.05, 0.126] }\n",
    )
}

#[track_caller]
fn continues(place: &Workplace, log: &[u8], warns: bool) {
    place.write("results/cases.log", log);
    let answer = place.sweep(&RUN);
    assert_eq!(answer.code, 3, "{answer:?}");
    assert_eq!(answer.errors.contains("not whole"), warns, "{answer:?}");
    same_tables(place, "whole", "results");
    for file in ["manifest.json", "labels.csv"] {
        std::fs::remove_file(place.path(&format!("results/{file}"))).unwrap();
    }
}

#[test]
fn a_torn_log_continues_from_its_last_whole_line() {
    let (place, log) = stopped(20);
    continues(&place, log.as_bytes(), false);
    let last = log.trim_end().rfind('\n').unwrap() + 1;
    for cut in [last + 1, last + 9, log.len() - 2, log.len() - 1] {
        continues(&place, &log.as_bytes()[..cut], true);
    }
    // Torn in the header: nothing is done yet.
    let header = log.find('\n').unwrap();
    for cut in [0, 1, header / 2, header] {
        continues(&place, &log.as_bytes()[..cut], false);
    }
}

#[test]
fn damaged_lines_are_run_again() {
    let (place, log) = stopped(20);
    let lines: Vec<&str> = log.split_inclusive('\n').collect();
    let damaged = lines[7].replace("\"Ok\":", "\"OK\":");
    assert_ne!(damaged, lines[7]);
    let mut text = lines.clone();
    text[7] = &damaged;
    continues(&place, text.concat().as_bytes(), true);
    // What a disk may leave after the power went.
    let zeros = [log.as_bytes(), &[0; 512]].concat();
    continues(&place, &zeros, true);
    let noise: Vec<u8> = (0..2000u32).map(|n| (n * n % 251) as u8).collect();
    continues(&place, &[log.as_bytes(), &noise].concat(), true);
    // The same line twice is one case.
    continues(&place, (log.clone() + lines[5]).as_bytes(), false);
}

#[test]
fn a_log_of_another_program_is_refused() {
    let (place, log) = stopped(20);
    place.write("results/cases.log", "something else\nand more\n");
    let answer = place.sweep(&RUN);
    assert_eq!(answer.code, 1, "{answer:?}");
    assert!(
        answer.errors.contains("is not a log of this program"),
        "{answer:?}"
    );
    let header = log.lines().next().unwrap();
    let (_, text) = header.split_once('\t').unwrap();
    for (piece, instead, meant) in [
        (
            "\"program\":\"sweep ",
            "\"program\":\"sweep 0.0.1 ",
            "another program, sweep 0.0.1 ",
        ),
        (
            "\"index\":0",
            "\"index\":1",
            "shard 1/1 of this sweep, not 0/1",
        ),
        (
            "\"time_s\":20.0",
            "\"time_s\":100.0",
            "another sweep (time_s: 100.0 → 20.0)",
        ),
        (
            "\"format\":3",
            "\"format\":4",
            "results/cases.log is a log of format 4",
        ),
        (
            "\"format\":3",
            "\"format\":2",
            "results/cases.log is a log of format 2",
        ),
    ] {
        let other = with(text, piece, instead);
        let line = format!("{:08x}\t{other}\n", crc32(other.as_bytes()));
        place.write("results/cases.log", &line);
        let answer = place.sweep(&RUN);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(meant), "{answer:?}");
        assert!(answer.errors.contains("--fresh"), "{answer:?}");
        assert_eq!(
            std::fs::read_to_string(place.path("results/cases.log")).unwrap(),
            line
        );
    }
    let answer = place.sweep(&[&RUN[..], &["--fresh"]].concat());
    assert_eq!(answer.code, 3, "{answer:?}");
    same_tables(&place, "whole", "results");
}

#[test]
fn a_changed_sweep_does_not_continue_and_a_changed_title_does() {
    let place = Workplace::with_small(&short());
    finishes(&place, &RUN);
    let before = std::fs::read(place.path("results/labels.csv")).unwrap();
    place.write("small.toml", with(&short(), "rad_m = 10\n", "rad_m = 11\n"));
    let answer = place.sweep(&RUN);
    assert_eq!(answer.code, 2, "{answer:?}");
    let meant = "(string.torsional_damping_nms_rad_m: 10.0 → 11.0)";
    assert!(answer.errors.contains(meant), "{answer:?}");
    place.write(
        "small.toml",
        with(&short(), "\"A small sweep\"", "\"Renamed\""),
    );
    finishes(&place, &RUN);
    assert!(before == std::fs::read(place.path("results/labels.csv")).unwrap());
    let map = std::fs::read_to_string(place.path("results/map.svg")).unwrap();
    assert!(map.contains("Renamed"));
}

/// It ended as complete, with the rows that came later.
#[test]
#[cfg(unix)]
fn a_log_that_is_emptied_under_a_run_is_noticed() {
    let place = Workplace::with_small(&long());
    let run = start(&place, &signals::RUN);
    wait_for_rows(&place, "stopped", 6);
    place.write("stopped/cases.log", "");
    let output = run.wait_with_output().unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(errors.contains("cases.log was emptied"), "{errors}");
    assert!(errors.contains("nothing is kept in stopped"), "{errors}");
    assert!(!place.path("stopped/manifest.json").exists());
    std::fs::remove_file(place.path("stopped/cases.log")).unwrap();
    let again = finishes(&place, &[&signals::RUN[..], &["--dry-run"]].concat());
    assert!(
        again.output.contains("600 of 600 simulations left"),
        "{again:?}"
    );
}
