//! The `labels.csv` of a run as a list of cases: what is to be run again.

use crate::refusals::refused;
use crate::support::{SMALL, Workplace, small_with_design, with};

/// The small sweep over the cases of a file.
fn listing(file: &str) -> String {
    small_with_design(&format!("[design]\nkind = \"list\"\nfile = \"{file}\"\n"))
}

#[track_caller]
fn done(place: &Workplace, arguments: &[&str]) -> String {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {answer:?}");
    answer.output
}

fn read(place: &Workplace, name: &str) -> String {
    std::fs::read_to_string(place.path(name)).unwrap()
}

/// Without the numbers of the cases.
fn without_numbers(labels: &str) -> Vec<&str> {
    let rows = labels.lines().map(|line| line.split_once(',').unwrap().1);
    rows.collect()
}

/// By two methods: two rows are one case, and T_d follows from the weight.
#[test]
fn the_labels_of_a_run_are_its_cases_again() {
    let two = with(SMALL, "[\"quadrature\"]", "[\"quadrature\", \"held\"]");
    let place = Workplace::with_small(&two);
    done(&place, &["run", "small.toml", "--quiet", "--out", "first"]);
    let labels = read(&place, "first/labels.csv");
    assert!(
        labels.starts_with("case,method,surface_speed_rpm,weight_on_bit_kn,torque_dynamic_nm,")
    );
    place.write("again.toml", listing("first/labels.csv"));
    let by = ["--methods", "quadrature,held"];
    done(
        &place,
        &[
            &["run", "again.toml", "--quiet", "--out", "second"],
            &by[..],
        ]
        .concat(),
    );
    assert_eq!(read(&place, "second/labels.csv"), labels);
}

/// Rows that any tool has chosen, in its order: cases are numbered as they first appear.
#[test]
fn chosen_rows_are_run_in_their_order() {
    let place = Workplace::with_small(SMALL);
    done(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "first"],
    );
    let labels = read(&place, "first/labels.csv");
    let mut lines = labels.lines();
    let header = lines.next().unwrap();
    let rows: Vec<&str> = lines.collect();
    let chosen = [rows[5], rows[1], rows[5]];
    place.write("chosen.csv", format!("{header}\n{}\n", chosen.join("\n")));
    place.write("again.toml", listing("chosen.csv"));
    done(
        &place,
        &["run", "again.toml", "--full", "--quiet", "--out", "second"],
    );
    let found = read(&place, "second/labels.csv");
    let found = without_numbers(&found);
    assert_eq!(
        found[1..],
        [rows[5], rows[1]].map(|row| row.split_once(',').unwrap().1)
    );
    // The columns of the cases alone, where a tool has dropped the others, and repeats stay.
    place.write(
        "plain.csv",
        "surface_speed_rpm,weight_on_bit_kn\n0.1,50\n0.1,50\n",
    );
    place.write("plain.toml", listing("plain.csv"));
    assert!(done(&place, &["run", "plain.toml", "--dry-run"]).contains("2 cases"));
}

/// An axis of T_d is one: nothing else says what the torque is.
#[test]
fn a_torque_that_follows_from_nothing_is_an_axis() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\nsurface_speed_rpm = { values = [0.1, 0.5] }\n\
                  torque_dynamic_nm = { values = [3000, 6000] }\n";
    let place = Workplace::with_small(&small_with_design(design));
    done(&place, &["run", "small.toml", "--quiet", "--out", "first"]);
    place.write("again.toml", listing("first/labels.csv"));
    done(&place, &["run", "again.toml", "--quiet", "--out", "second"]);
    assert_eq!(
        read(&place, "second/labels.csv"),
        read(&place, "first/labels.csv")
    );
    // With a weight in the file it is the same for all cases, and follows.
    let speeds =
        "[design]\nkind = \"grid\"\n[design.axes]\nsurface_speed_rpm = { values = [0.1, 0.5] }\n";
    let weight = |text: &str| {
        with(
            text,
            "rock = \"sandstone\"",
            "rock = \"sandstone\"\nweight_on_bit_kn = 50",
        )
    };
    place.write("weight.toml", weight(&small_with_design(speeds)));
    done(&place, &["run", "weight.toml", "--quiet", "--out", "third"]);
    place.write("again.toml", weight(&listing("third/labels.csv")));
    done(&place, &["run", "again.toml", "--quiet", "--out", "fourth"]);
    assert_eq!(
        read(&place, "fourth/labels.csv"),
        read(&place, "third/labels.csv")
    );
}

#[test]
fn an_unknown_column_is_refused_and_so_is_a_table_without_an_axis() {
    let place = Workplace::with_small(&listing("cases.csv"));
    let run = ["run", "small.toml"];
    place.write(
        "cases.csv",
        "case,method,surface_speed_rpm,smoothness,torsion\n0,held,0.1,2,smooth\n",
    );
    refused(&place, &run, &["cases.csv:1: unknown column `smoothness`"]);
    place.write("cases.csv", "case,method,torsion\n0,held,smooth\n");
    refused(&place, &run, &["cases.csv:1: no column is an axis"]);
    place.write(
        "cases.csv",
        "case,surface_speed_rpm,torsion\n0,fast,smooth\n",
    );
    refused(&place, &run, &["cases.csv:2: surface_speed_rpm: `fast`"]);
}

/// The recipe of the guide, as a shell runs it: the cases on whose label two methods differ.
#[cfg(unix)]
#[test]
fn the_guide_runs_the_cases_that_differ_again() {
    let guide = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/sweep-file.md");
    let guide = std::fs::read_to_string(guide).unwrap();
    let blocks = guide
        .split("```sh\n")
        .skip(1)
        .map(|it| it.split("```").next().unwrap());
    let script: Vec<&str> = blocks.filter(|it| it.contains("differing.csv")).collect();
    assert_eq!(script.len(), 1);
    let place = Workplace::new();
    place.write("my-sweep.toml", with(SMALL, "count = 3", "count = 25"));
    let program = std::path::PathBuf::from(place.command(&[]).get_program());
    let path = std::env::var("PATH").unwrap();
    let path = format!("{}:{path}", program.parent().unwrap().display());
    let output = std::process::Command::new("sh")
        .args(["-e", "-c", script[0]])
        .current_dir(place.path(""))
        .env("PATH", path)
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    let labels = read(&place, "results/my-sweep/labels.csv");
    // Case, method, speed, weight, T_d, label.
    let rows: Vec<Vec<&str>> = (labels.lines().skip(1))
        .map(|row| row.split(',').collect())
        .collect();
    let differing = rows.chunks(2).filter(|case| case[0][5] != case[1][5]);
    let expected: Vec<&[&str]> = differing.map(|case| &case[0][2..5]).collect();
    let found = read(&place, "results/differing/labels.csv");
    let found: Vec<Vec<&str>> = (found.lines().skip(1))
        .map(|row| row.split(',').collect())
        .collect();
    let found: Vec<&[&str]> = found.iter().map(|row| &row[2..5]).collect();
    assert!(!expected.is_empty());
    assert_eq!(found, expected);
}
