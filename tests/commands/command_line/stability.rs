//! `sweep study stability` on a part of the atlas.

use super::{columns, is_png, names, names_in, succeeds, table, text};
use crate::support::Workplace;

#[test]
fn a_part_of_the_atlas_is_written_the_same_by_any_number_of_threads() {
    let place = Workplace::new();
    let run = |out: &str, jobs: &str| {
        let study = ["study", "stability", "--quiet", "--family", "formulas"];
        succeeds(
            &place,
            &[&study[..], &["--out", out, "--jobs", jobs]].concat(),
        )
    };
    assert_eq!(run("one", "1").output, "");
    run("two", "2");
    let files = names(["stability.csv", "stability.png", "stability.svg"]);
    assert_eq!(names_in(&place, "one"), files);
    let csv = text(&place, "one/stability.csv");
    assert_eq!(csv, text(&place, "two/stability.csv"));
    let rows = columns(&table(&csv), ["method", "predicted", "outcome", "right"]);
    assert_eq!(rows.len(), 15);
    for row in rows {
        let verdict = match row[0].as_str() {
            "quadrature" | "held" => "stable",
            _ => "unstable",
        };
        assert_eq!(row[1..], [verdict, verdict, "yes"].map(str::to_owned));
    }
    is_png(&place, "one/stability.png");
}

/// Where joints meet collars steps that are longer than a joint smear its reflection: a step in
/// which fronts are exact has the limit, and with overshooting fronts no step has it.
#[test]
fn the_limit_of_a_string_with_joints_and_collars_takes_short_steps_of_exact_fronts() {
    let place = Workplace::new();
    let study = [
        "study",
        "stability",
        "--quiet",
        "--family",
        "joints",
        "--out",
        "atlas",
    ];
    succeeds(&place, &study);
    let table = table(&text(&place, "atlas/stability.csv"));
    let rows = columns(
        &table,
        ["method", "sampling_frequency_hz", "error", "outcome"],
    );
    assert_eq!(rows.len(), 28);
    let error = |method: &str, frequency: &str| {
        let row = rows
            .iter()
            .find(|row| row[0] == method && row[1] == frequency);
        row.unwrap()[2].parse::<f64>().unwrap()
    };
    assert!(error("held", "10240") < 0.02);
    assert!(error("held", "640") > 0.1);
    for frequency in ["640", "2560", "10240"] {
        for method in ["quadrature", "finite-element"] {
            let error = error(method, frequency);
            assert!(error > 0.1, "{method} {frequency}: {error}");
        }
    }
    for row in &rows {
        let is_wrong = row[2].parse::<f64>().unwrap() > 0.1;
        assert_eq!(row[3], if is_wrong { "wrong" } else { "accurate" });
    }
}

#[test]
fn the_atlas_tells_how_often_its_margins_were_right() {
    let place = Workplace::new();
    let arguments = [
        "study",
        "stability",
        "--family",
        "hilbert,tail",
        "--out",
        "atlas",
    ];
    // Progress may be reported on the other stream.
    let answer = place.sweep(&arguments);
    assert_eq!(answer.code, 0, "{answer:?}");
    let answer = answer.output;
    let line = |name: &str| {
        let found = answer.lines().find(|line| line.starts_with(name));
        found
            .unwrap_or_else(|| panic!("no {name} in {answer}"))
            .split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(line("hilbert")[1..4], ["45", "45", "45"].map(str::to_owned));
    // No margin is about accuracy.
    assert_eq!(line("tail")[1..4], ["8", "0", "0"].map(str::to_owned));
}

/// Mud takes energy at every frequency, where one constant leaves none of the margin, and it wears
/// down what short steps and exact fronts are needed for.
#[test]
fn in_mud_margins_are_truly_positive_and_every_method_has_the_limit_of_a_jointed_string() {
    let place = Workplace::new();
    let study = ["study", "stability", "--quiet", "--in-mud", "--family"];
    let rest = ["formulas,joints", "--out", "atlas"];
    succeeds(&place, &[&study[..], &rest].concat());
    let table = table(&text(&place, "atlas/stability.csv"));
    let names = ["family", "method", "margin_torsion", "error"];
    let (mut margins, mut errors) = (0, 0);
    for row in columns(&table, names) {
        if row[0] == "joints" {
            let error: f64 = row[3].parse().unwrap();
            assert!(error < 0.03, "{row:?}");
            errors += 1;
        } else if row[1] != "trapezoidal" {
            let margin: f64 = row[2].parse().unwrap();
            assert!(margin > 0.01, "{row:?}");
            margins += 1;
        }
    }
    assert_eq!((margins, errors), (10, 28));
    let refused = place.sweep(&["study", "stability", "--in-mud", "--family", "sections"]);
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(
        refused.errors.contains("leave that family out"),
        "{refused:?}"
    );
}
