//! `sweep promises` on a few strings.

use super::support::Workplace;
use super::{columns, table, text};

/// A uniform string and one with a collar: what is promised there is kept, whoever asks.
#[test]
fn promises_are_put_to_the_test_alike_by_any_number_of_threads() {
    let place = Workplace::new();
    let run = |out: &str, jobs: &str| {
        let study = ["promises", "--strings", "2", "--motion", "stick-slip"];
        place.sweep(&[&study[..], &["--out", out, "--jobs", jobs]].concat())
    };
    let told = run("one", "1");
    assert_eq!(told.code, 0, "{told:?}");
    assert_eq!(run("two", "2").code, 0);
    let csv = text(&place, "one/promises.csv");
    assert_eq!(csv, text(&place, "two/promises.csv"));
    let rows = columns(&table(&csv), ["asked", "broken_by", "note"]);
    assert_eq!(rows.len(), 6);
    let kept: Vec<f64> = (rows.iter())
        .filter(|row| row[2].is_empty())
        .map(|row| row[1].parse().unwrap())
        .collect();
    assert!(kept.len() >= 3, "{csv}");
    assert!(kept.iter().all(|broken_by| *broken_by < 1.0), "{csv}");
    let line = format!("stick_slip: {} promises tested, 0 broken", kept.len());
    assert!(told.output.starts_with(&line), "{}", told.output);
}

#[test]
fn no_strings_are_refused() {
    let place = Workplace::new();
    let answer = place.sweep(&["promises", "--strings", "0"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("--strings"), "{answer:?}");
}
