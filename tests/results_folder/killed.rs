//! Commands that are killed in the middle of a file, by a limit of the size of files:
//! what they left is gone after the next, which does what they did not.

use std::os::unix::process::ExitStatusExt;
use std::process::Command;

use crate::support::Workplace;
use crate::{FILES, RUN, copy, read, run_shards, succeeds, with_results};

/// What files of so many bytes stop: the log's header, a table, the manifest, a
/// picture, a page.
const LIMITS: [usize; 6] = [512, 1024, 2048, 4096, 16 << 10, 64 << 10];

/// Whether a command was killed when it wrote a file larger than the limit.
fn is_killed(place: &Workplace, limit: usize, arguments: &[&str]) -> bool {
    let status = Command::new("sh")
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
        .unwrap()
        .status;
    assert!(status.success() || status.signal().is_some(), "{status:?}");
    !status.success()
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
fn goes_on(place: &Workplace, run: &[&str]) {
    let answer = place.sweep(run);
    assert_eq!(answer.code, 0, "{answer:?}");
}

#[test]
fn a_run_killed_in_any_file_leaves_nothing_after_the_next() {
    let place = with_results();
    let mut has_left = 0;
    for limit in LIMITS {
        let run = ["run", "small.toml", "--out", "other"];
        assert!(is_killed(&place, limit, &run), "{limit}");
        has_left += left(&place, "other")
            .iter()
            .filter(|name| name.contains("tmp"))
            .count();
        goes_on(&place, &run);
        same(&place, "results", "other");
        // Killed again, from nothing, over results.
        let fresh = [&run[..], &["--fresh"]].concat();
        assert!(is_killed(&place, limit, &fresh), "{limit}");
        goes_on(&place, &run);
        same(&place, "results", "other");
        std::fs::remove_dir_all(place.path("other")).unwrap();
    }
    // Where the log or the manifest is cut off, there may be nothing else.
    assert!(has_left >= LIMITS.len() / 2, "{has_left}");
}

#[test]
fn a_merge_killed_in_any_file_can_be_done_again() {
    let place = with_results();
    run_shards(&place);
    for limit in LIMITS {
        let merge = ["merge", "0", "1", "--out", "other"];
        assert!(is_killed(&place, limit, &merge), "{limit}");
        succeeds(&place, &merge);
        same(&place, "results", "other");
        std::fs::remove_dir_all(place.path("other")).unwrap();
    }
}

#[test]
fn a_killed_plot_or_report_leaves_nothing_after_any_other() {
    let place = with_results();
    for killed in ["plot", "report"] {
        for next in [&["plot", "results"][..], &["report", "results"], &RUN] {
            copy(&place, "results", "kept");
            assert!(is_killed(&place, 4096, &[killed, "results"]));
            assert_eq!(left(&place, "results").len(), 2, "{killed}");
            succeeds(&place, next);
            same(&place, "kept", "results");
            std::fs::remove_dir_all(place.path("kept")).unwrap();
        }
    }
    // Killed before it began a file.
    place.write("results/.sweep-lock", "");
    succeeds(&place, &RUN);
    assert_eq!(left(&place, "results"), [""; 0]);
}
