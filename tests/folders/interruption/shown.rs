//! `summary`, `report` and `plot` of a run that is stopped, or still under way.

use std::collections::BTreeMap;

use crate::interruption::signals::{RUN, start, wait_for_rows};
use crate::interruption::{finishes, logged, long, same_tables};
use crate::support::Workplace;

/// Cases of which both methods are in the log of a stopped run.
fn whole_cases(place: &Workplace) -> usize {
    let log = std::fs::read_to_string(place.path("stopped/cases.log")).unwrap();
    let mut rows: BTreeMap<u64, usize> = BTreeMap::new();
    for line in log.lines() {
        let (_, text) = line.split_once('\t').unwrap();
        if let Ok(record) = serde_json::from_str::<serde_json::Value>(text) {
            let case = record["case"].as_u64().unwrap();
            *rows.entry(case).or_default() += 1;
        }
    }
    rows.values().filter(|&&rows| rows == 2).count()
}

/// Rows of a method that a summary counts, over all regimes.
#[track_caller]
fn counted(summary: &str, method: &str) -> usize {
    let table = summary.split("Cases of each regime").nth(1).unwrap();
    let mut rows = table.lines().map(str::split_whitespace);
    let row = rows.find_map(|mut row| (row.next() == Some(method)).then_some(row));
    row.unwrap()
        .map(|cell| cell.parse::<usize>().unwrap())
        .sum()
}

#[test]
fn a_stopped_run_is_shown_as_far_as_it_is_and_continues() {
    let place = Workplace::with_small(&long());
    let mut child = start(&place, &RUN);
    wait_for_rows(&place, "stopped", 60);
    // While it is under way.
    let summary = finishes(&place, &["summary", "stopped"]).output;
    assert!(summary.contains("unfinished: "), "{summary}");
    child.kill().unwrap();
    child.wait().unwrap();

    let log = std::fs::read(place.path("stopped/cases.log")).unwrap();
    let done = logged(&place, "stopped");
    assert!((60..600).contains(&done), "{done}");
    let so_far = format!("unfinished: {done} of 600 simulations");
    let summary = finishes(&place, &["summary", "stopped"]).output;
    assert!(summary.starts_with(&format!("small: A small sweep ({so_far})\n")));
    let words: Vec<&str> = summary.split_whitespace().collect();
    let reported = format!("It is {so_far} are done");
    assert!(words.join(" ").contains(&reported), "{summary}");
    for method in ["quadrature", "finite-element"] {
        assert_eq!(counted(&summary, method), whole_cases(&place), "{summary}");
    }
    finishes(&place, &["report", "stopped"]);
    let page = std::fs::read_to_string(place.path("stopped/report.html")).unwrap();
    assert!(page.contains(&so_far) && page.contains("<svg"), "{page}");
    finishes(&place, &["plot", "stopped"]);
    let map = std::fs::read_to_string(place.path("stopped/map.svg")).unwrap();
    assert!(map.contains(&so_far), "{map}");
    let is_untouched = log == std::fs::read(place.path("stopped/cases.log")).unwrap();
    assert!(is_untouched, "the log was written");

    finishes(&place, &RUN);
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "whole"],
    );
    same_tables(&place, "whole", "stopped");
    let names = |folder: &str| -> Vec<String> {
        let files = place.files().into_keys();
        let in_folder = |name: String| name.strip_prefix(&format!("{folder}/")).map(str::to_owned);
        files.filter_map(in_folder).collect()
    };
    // The report of an unfinished run does not outlive it.
    assert_eq!(names("stopped"), names("whole"));
    for picture in ["map.svg", "map.png"] {
        let read =
            |folder: &str| std::fs::read(place.path(&format!("{folder}/{picture}"))).unwrap();
        assert!(read("whole") == read("stopped"), "{picture}");
    }
}

#[test]
fn a_run_that_has_only_just_begun_has_nothing_to_show() {
    let place = Workplace::with_small(&long());
    let mut child = start(&place, &RUN);
    wait_for_rows(&place, "stopped", 1);
    child.kill().unwrap();
    child.wait().unwrap();
    let log = std::fs::read_to_string(place.path("stopped/cases.log")).unwrap();
    let lines: Vec<&str> = log.split_inclusive('\n').collect();
    place.write("stopped/cases.log", lines[0]);
    for command in ["summary", "report", "plot"] {
        let answer = place.sweep(&[command, "stopped"]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains("has only just begun"), "{answer:?}");
    }
    // With a word about itself, and no case.
    place.write("stopped/cases.log", lines[..2].concat());
    let summary = finishes(&place, &["summary", "stopped"]).output;
    assert!(
        summary.contains("unfinished: 0 of 600 simulations"),
        "{summary}"
    );
    let answer = place.sweep(&["plot", "stopped"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("no case to draw yet"), "{answer:?}");
}
