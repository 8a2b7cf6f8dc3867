//! `sweep reference`: cases whose labels are far from changing.

use std::collections::BTreeSet;

use crate::command_line::{columns, run, succeeds, table, text};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

/// Close enough to one another that some are next to the limit.
fn fine() -> String {
    with(SMALL, "to = 0.6, count = 3", "to = 0.6, count = 12")
}

const AXES: [&str; 2] = ["surface_speed_rpm", "weight_on_bit_kn"];

/// Without its comments.
fn cases(reference: &str) -> BTreeSet<usize> {
    let rows = reference.lines().filter(|line| !line.starts_with('#'));
    let numbers = rows.skip(1).map(|row| row.split(',').next().unwrap());
    numbers.map(|number| number.parse().unwrap()).collect()
}

/// Every case is run again by hand, with each axis 10 % lower and higher.
#[test]
fn a_case_next_to_a_limit_is_dropped_and_no_other() {
    let place = Workplace::with_small(&fine());
    run(&place, "small.toml", "results");
    let rows = columns(
        &table(&text(&place, "results/labels.csv")),
        ["torsion", AXES[0], AXES[1]],
    );
    let number = |text: &String| text.parse::<f64>().unwrap();
    let mut list = format!("{}\n", AXES.join(","));
    for [_, speed, weight] in &rows {
        let (speed, weight) = (number(speed), number(weight));
        for (speed_times, weight_times) in [(0.9, 1.0), (1.1, 1.0), (1.0, 0.9), (1.0, 1.1)] {
            list += &format!("{},{}\n", speed * speed_times, weight * weight_times);
        }
    }
    place.write("neighbours.csv", list);
    let design = "base = \"small.toml\"\n[design]\nkind = \"list\"\nfile = \"neighbours.csv\"\n";
    place.write("neighbours.toml", design);
    run(&place, "neighbours.toml", "neighbours");
    let neighbours = columns(&table(&text(&place, "neighbours/labels.csv")), ["torsion"]);
    let expected: BTreeSet<usize> = (0..rows.len())
        .filter(|&case| (0..4).all(|side| neighbours[4 * case + side][0] == rows[case][0]))
        .collect();
    let answer = succeeds(&place, &["reference", "results", "--margin", "10%"]);
    let reference = text(&place, "results/reference.csv");
    assert_eq!(cases(&reference), expected);
    let labels: BTreeSet<&str> = expected
        .iter()
        .map(|&case| rows[case][0].as_str())
        .collect();
    assert!(
        labels.len() == 2 && expected.len() < rows.len(),
        "{expected:?}"
    );
    let counts = format!("{} of {} cases kept", expected.len(), rows.len());
    assert!(answer.output.starts_with(&counts), "{answer:?}");
    assert!(reference.contains(&counts), "{reference}");

    // It is a reference of the sweep, and says its margin.
    let answer = succeeds(&place, &["check", "small.toml", "results/reference.csv"]);
    let of = expected.len();
    assert_eq!(
        answer.output,
        format!(
            "results/reference.csv: {of} of {of} labels as expected; its cases keep 10 % in \
             surface_speed_rpm, weight_on_bit_kn from where a label changes\n"
        )
    );
}

/// The same bytes on any number of threads, of a folder without its log, elsewhere.
#[test]
fn a_reference_is_the_same_on_any_number_of_threads() {
    let place = Workplace::with_small(&fine());
    run(&place, "small.toml", "results");
    let along = ["--along", "surface_speed_rpm", "--margin", "0.02"];
    let made = ["1", "3"].map(|jobs| {
        let reference = ["reference", "results", "--jobs", jobs, "--out", "made.csv"];
        succeeds(&place, &[&reference[..], &along].concat());
        text(&place, "made.csv")
    });
    assert_eq!(made[0], made[1]);
    assert!(
        made[0].contains("# margin: 2 % in surface_speed_rpm\n"),
        "{}",
        made[0]
    );
    let rows = made[0].lines().filter(|line| !line.starts_with('#'));
    assert_eq!(
        rows.take(1).collect::<Vec<_>>(),
        ["case,method,surface_speed_rpm,weight_on_bit_kn,torsion,lateral"]
    );
}

#[test]
fn a_reference_is_made_with_the_sweep_of_its_results_alone() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    place.write("small.toml", with(SMALL, "time_s = 12", "time_s = 13"));
    let reference = ["reference", "results"];
    refused(
        &place,
        &reference,
        &["another sweep", "small.toml", "time_s: "],
    );
    place.write("as_it_was.toml", SMALL);
    succeeds(
        &place,
        &[&reference[..], &["--sweep", "as_it_was.toml"]].concat(),
    );
    std::fs::remove_file(place.path("small.toml")).unwrap();
    refused(&place, &reference, &["small.toml", "--sweep FILE"]);
    let strange = ["--sweep", "as_it_was.toml", "--along", "friction"];
    refused(&place, &[&reference[..], &strange].concat(), &["friction"]);
    let answer = place.sweep(&[&reference[..], &["--margin", "80%"]].concat());
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("up to 50%"), "{answer:?}");
}
