//! Runs that are stopped, in any way, and continued: what was finished is kept,
//! and the end is the same to the byte.

#[cfg(unix)]
mod anywhere;
#[cfg(unix)]
mod disk;
mod failures;
mod log;
mod raised;
#[cfg(unix)]
mod shown;
#[cfg(unix)]
mod signals;
// Each of the tests uses a part of it.

use crate::support::{Answer, SMALL, Workplace, with};

/// The tables of results, which hold nothing of threads, times or machines.
const TABLES: [&str; 4] = [
    "labels.csv",
    "failures.csv",
    "boundary.csv",
    "records.jsonl.gz",
];

/// A sweep of 300 cases by two methods that takes a second or two, if each case is
/// simulated to its end.
fn long() -> String {
    let text = with(SMALL, "count = 3", "count = 30");
    let text = with(&text, "values = [30, 70]", "from = 10, to = 80, count = 10");
    let text = with(
        &text,
        "[\"quadrature\"]",
        "[\"quadrature\", \"finite-element\"]",
    );
    with(&text, "time_s = 12", "time_s = 1000")
}

#[track_caller]
fn finishes(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{answer:?}");
    answer
}

#[track_caller]
fn same_tables(place: &Workplace, one: &str, other: &str) {
    for table in TABLES {
        let read = |folder: &str| std::fs::read(place.path(&format!("{folder}/{table}"))).unwrap();
        assert!(read(one) == read(other), "{table} of {one} and {other}");
    }
}

/// Simulations that the log of a stopped run has.
fn logged(place: &Workplace, folder: &str) -> usize {
    let log = std::fs::read_to_string(place.path(&format!("{folder}/cases.log"))).unwrap();
    let is_case = |line: &&str| !line.contains("\tsweep-");
    log.lines().filter(is_case).count()
}
