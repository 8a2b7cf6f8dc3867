//! Cases without an answer are kept aside and stop nothing, unless asked to.

use crate::support::{SMALL, Workplace, with};

/// The middle one of three strings has an internal radius beyond the external
/// one.
fn with_impossible_string() -> String {
    with(
        SMALL,
        "[design.axes]\n",
        "[design.axes]\nsection_0_part_0_inner_radius_m = { values = [0.04, 0.2, 0.05] }\n",
    )
}

fn run(place: &Workplace, more: &[&str]) -> crate::interruption::Answer {
    place.sweep(&[&["run", "small.toml", "--out", "results"], more].concat())
}

#[test]
fn failed_cases_are_kept_aside_with_reason_and_command() {
    let place = Workplace::with_small(&with_impossible_string());
    for attempt in 0..2 {
        let answer = run(&place, &["--keep-going"]);
        assert_eq!(answer.code, 3, "{attempt}: {answer:?}");
        assert!(answer.output.contains("6 of 18 rows failed"), "{answer:?}");
    }
    let failures = std::fs::read_to_string(place.path("results/failures.csv")).unwrap();
    let mut reader = csv::Reader::from_reader(failures.as_bytes());
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), 6);
    for (index, record) in records.iter().enumerate() {
        let case = 6 + index;
        assert_eq!(record[0], case.to_string());
        assert!(
            record[2].contains("internal radius < external radius"),
            "{record:?}"
        );
        let repeat = format!("sweep simulate small.toml --case {case} --methods quadrature");
        assert_eq!(record[3], repeat);
        let answer = place.sweep(&record[3].split(' ').skip(1).collect::<Vec<_>>());
        assert_eq!(answer.code, 3, "{answer:?}");
        assert!(answer.errors.contains(&record[2]), "{answer:?}");
    }
    let labels = std::fs::read_to_string(place.path("results/labels.csv")).unwrap();
    assert_eq!(labels.matches(",failed\n").count(), 6);
    assert_eq!(labels.matches(",ok\n").count(), 12);
}

#[test]
fn fail_fast_stops_at_the_first_and_continues_without_it() {
    let place = Workplace::with_small(&with_impossible_string());
    for meant in [
        "case 6 by quadrature has no answer",
        "1 simulation without an answer already",
    ] {
        let answer = run(&place, &["--fail-fast", "--jobs", "1"]);
        assert_eq!(answer.code, 1, "{answer:?}");
        assert!(answer.errors.contains(meant), "{answer:?}");
        assert!(
            answer.errors.contains("7 of 18 simulations are done"),
            "{answer:?}"
        );
    }
    assert_eq!(run(&place, &[]).code, 3);
}

#[test]
fn a_dry_run_counts_the_strings_and_the_invalid_ones() {
    let place = Workplace::with_small(&with_impossible_string());
    let answer = run(&place, &["--dry-run"]);
    for words in [
        "18 of 18 simulations left: from the beginning",
        "3 distinct strings, each built once",
        "1 strings are invalid",
    ] {
        assert!(answer.output.contains(words), "{answer:?}");
    }
}

/// It was run into 100 % failed cases, in about inf days.
#[test]
fn a_sweep_whose_strings_are_all_invalid_is_refused() {
    let mud = "[mud]\ndensity_kg_m3 = 1200\n\n[design]\n";
    let text = with(SMALL, "[design]\n", mud);
    let axis = "[design.axes]\nmud_viscosity_cp = { values = [10, 20] }\n";
    let place = Workplace::with_small(&with(&text, "[design.axes]\n", axis));
    for more in [&[][..], &["--dry-run"]] {
        let answer = place.sweep(&[&["run", "small.toml"], more].concat());
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains("small.toml:"), "{answer:?}");
        assert!(answer.errors.contains("`mud.viscosity_cp`: "), "{answer:?}");
        assert!(!place.path("results").exists());
    }
}
