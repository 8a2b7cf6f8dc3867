//! Files of others in the folder that a run is to write.

use crate::results_folder::{FILES, RUN, copy, read, refuses, run_shards, succeeds, with_results};
use crate::support::{SMALL, Workplace, small_with_design, with};

/// The command, from nothing too.
fn refuses_fresh_or_not(place: &Workplace, code: i32, words: &[&str]) {
    for more in [&[][..], &["--fresh"], &["--dry-run"]] {
        refuses(place, &[&RUN[..], more].concat(), code, words);
    }
}

#[test]
fn a_log_of_something_else_is_never_touched() {
    let place = Workplace::with_small(SMALL);
    std::fs::create_dir(place.path("results")).unwrap();
    for content in [
        &b"one line"[..],
        b"one line\n",
        b"two\nlines\n",
        b"\n",
        &[0; 4096],
    ] {
        place.write("results/cases.log", content);
        let words = [
            "results/cases.log is not a log of this program",
            "move it away",
        ];
        refuses_fresh_or_not(&place, 1, &words);
    }
}

#[cfg(unix)]
#[test]
fn a_log_that_is_a_link_is_refused() {
    let place = Workplace::with_small(SMALL);
    std::fs::create_dir(place.path("results")).unwrap();
    let log = place.path("results/cases.log");
    for content in ["", "a thesis\n"] {
        place.write("thesis", content);
        std::os::unix::fs::symlink("../thesis", &log).unwrap();
        refuses_fresh_or_not(&place, 1, &["results/cases.log", "a symbolic link"]);
        std::fs::remove_file(&log).unwrap();
    }
    // One that leads nowhere makes nothing there.
    std::os::unix::fs::symlink("../nothing", &log).unwrap();
    let answer = place.sweep(&RUN);
    assert_eq!(answer.code, 1, "{answer:?}");
    assert!(!place.path("nothing").exists());
}

#[cfg(unix)]
#[test]
fn a_table_that_is_a_link_leaves_what_it_leads_to() {
    let place = with_results();
    let labels = place.path("results/labels.csv");
    std::fs::rename(&labels, place.path("kept")).unwrap();
    std::os::unix::fs::symlink("../kept", &labels).unwrap();
    let kept = read(&place, "kept");
    succeeds(&place, &RUN);
    succeeds(&place, &[&RUN[..], &["--fresh"]].concat());
    assert!(!labels.is_symlink());
    assert_eq!(read(&place, "kept"), kept);
}

#[test]
fn a_folder_with_a_file_that_a_run_would_replace_is_refused() {
    for name in FILES {
        let place = Workplace::with_small(SMALL);
        std::fs::create_dir(place.path("results")).unwrap();
        place.write(&format!("results/{name}"), "mine\n");
        let words = [
            &format!("results holds {name}, and nothing"),
            "another --out",
        ];
        refuses_fresh_or_not(&place, 2, &words);
        let report = format!("results/{name}");
        std::fs::remove_file(place.path(&report)).unwrap();
        succeeds(&place, &RUN);
    }
    let place = Workplace::with_small(SMALL);
    std::fs::create_dir(place.path("results")).unwrap();
    place.write("results/manifest.json", "{ \"name\": \"of a web page\" }\n");
    refuses(
        &place,
        &RUN,
        1,
        &["results/manifest.json is not a manifest"],
    );
    let fresh = [&RUN[..], &["--fresh"]].concat();
    refuses(
        &place,
        &fresh,
        2,
        &["results holds manifest.json, and nothing"],
    );
}

#[test]
fn what_a_run_does_not_write_stays() {
    let place = Workplace::with_small(SMALL);
    std::fs::create_dir(place.path("results")).unwrap();
    let mine = ["notes.txt", ".tmpAbCdEf", "history.csv", "report.html"];
    for name in mine {
        place.write(&format!("results/{name}"), "mine\n");
    }
    succeeds(&place, &RUN);
    succeeds(&place, &[&RUN[..], &["--fresh"]].concat());
    let words = ["results/report.html is no page of this program", "--out"];
    refuses(&place, &["report", "results"], 2, &words);
    for name in mine {
        assert_eq!(
            read(&place, &format!("results/{name}")),
            b"mine\n",
            "{name}"
        );
    }
    // A sweep without a map writes none.
    let place = Workplace::with_small(&with(
        &small_with_design(""),
        "[bit]",
        "[bit]\nweight_on_bit_kn = 50",
    ));
    std::fs::create_dir(place.path("results")).unwrap();
    place.write("results/map.svg", "mine\n");
    succeeds(&place, &RUN);
    succeeds(&place, &[&RUN[..], &["--fresh"]].concat());
    assert_eq!(read(&place, "results/map.svg"), b"mine\n");
}

#[test]
fn a_merge_replaces_nothing_of_others() {
    let place = Workplace::with_small(SMALL);
    run_shards(&place);
    std::fs::create_dir(place.path("out")).unwrap();
    let merge = ["merge", "0", "1", "--out", "out"];
    for name in ["labels.csv", "map.png"] {
        let path = format!("out/{name}");
        place.write(&path, "mine\n");
        refuses(
            &place,
            &merge,
            2,
            &[&format!("out holds {name}, and nothing")],
        );
        std::fs::remove_file(place.path(&path)).unwrap();
    }
    place.write("out/cases.log", "mine\n");
    refuses(&place, &merge, 1, &["out/cases.log is not a log"]);
    std::fs::remove_file(place.path("out/cases.log")).unwrap();
    place.write("out/notes.txt", "mine\n");
    succeeds(&place, &merge);
    copy(&place, "out", "again");
    succeeds(&place, &merge);
    assert!(read(&place, "out/labels.csv") == read(&place, "again/labels.csv"));
}
