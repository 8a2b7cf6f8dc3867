//! `sweep simulate --case K` is the case that `sweep run` ran: the same numbers, bit for
//! bit, or the same reason for none.

use std::path::Path;
use std::process::Command;

use crate::command_line::{
    by_two_methods, columns, complaints, labels, run, succeeds, table, text,
};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, small_with_design, with};

/// Between the nodes of the mesh, so that finite elements get another mesh where it is observed.
const WATCHED: &str = "distance_from_bit_m = 53.3";

fn watched(text: &str) -> String {
    with(text, "distance_from_bit_m = 50", WATCHED)
}

fn by_methods(text: &str, methods: &str) -> String {
    with(text, "methods = [\"quadrature\"]", methods)
}

/// Every row of a run is that of its case simulated, alone by its own method and, with all methods,
/// together with the others.
#[track_caller]
fn each_row_is_its_case(place: &Workplace, file: &str, terms: &[&str], by_accuracy: bool) {
    let answer = place.sweep(&[&["run", file, "--out", "run", "--quiet"], terms].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    let labels = text(place, "run/labels.csv");
    let (header, rows) = labels.split_once('\n').unwrap();
    for row in rows.lines() {
        let (case, rest) = row.split_once(',').unwrap();
        let method = rest.split(',').next().unwrap();
        let mut command = vec!["simulate", file, "--out", "case", "--case", case];
        command.extend(terms);
        if !by_accuracy {
            command.extend(["--methods", method]);
        }
        succeeds(place, &command);
        assert_eq!(text(place, "case/case.csv"), format!("{header}\n{row}\n"));
    }
    if by_accuracy {
        // The one method that was chosen is all.
        return;
    }
    let case = |row: &str| row.split(',').next().unwrap().to_owned();
    let last = case(rows.lines().last().unwrap());
    let command = ["simulate", file, "--out", "case", "--case", &last];
    succeeds(place, &[&command, terms].concat());
    let found = text(place, "case/case.csv");
    let expected = rows.lines().filter(|row| case(row) == last);
    assert!(found.lines().skip(1).eq(expected), "{found}");
}

#[test]
fn a_place_that_is_observed_changes_no_number() {
    let methods = "methods = [\"quadrature\", \"finite-element\"]";
    let place = Workplace::with_small(&by_methods(&watched(SMALL), methods));
    each_row_is_its_case(&place, "small.toml", &[], false);
    // It moves all the same.
    let history = table(&text(&place, "case/history.csv"));
    let speeds = columns(&history, ["53.3m_above_bit_speed_rpm", "bit_speed_rpm"]);
    let speeds = speeds
        .iter()
        .map(|row| row.each_ref().map(|speed| speed.parse::<f64>().unwrap()));
    let [mut above, mut bit] = [0.0, 0.0];
    for speed in speeds {
        above += speed[0].abs();
        bit += speed[1].abs();
    }
    assert!((above / bit - 1.0).abs() < 0.2, "{above} {bit}");
}

#[test]
fn every_kind_of_design_and_each_string_has_its_cases_again() {
    let list = "[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";
    let random = "[design]\nkind = \"monte-carlo\"\ncases = 4\nseed = 7\n[design.axes]\n\
                  surface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                  section_0_part_0_outer_radius_m = { from = 0.12, to = 0.13 }\n\
                  weight_on_bit_kn = { from = 30, to = 70 }\n";
    let timed_by_rule = |design: &str| with(&small_with_design(design), "time_s = 12\n", "");
    for design in [list, random] {
        let methods = "methods = [\"finite-element\"]";
        let text = by_methods(&watched(&timed_by_rule(design)), methods);
        let place = Workplace::with_small(&text);
        place.write(
            "cases.csv",
            "torsional_damping_nms_rad_m,surface_speed_rpm,weight_on_bit_kn\n\
             10,0.3,60\n12,0.02,60\n10,0.05,40\n",
        );
        each_row_is_its_case(&place, "small.toml", &[], false);
    }
}

/// Where `run` follows every case to its end, what it measures at its end counts.
#[test]
fn a_run_to_the_end_has_its_cases_again() {
    let place = Workplace::with_small(&watched(SMALL));
    each_row_is_its_case(&place, "small.toml", &["--full"], false);
}

#[test]
fn an_accuracy_chooses_for_one_case_what_it_chose_for_all() {
    let asked = "accuracy = \"30 %\"\n";
    let own = "sampling_frequency_hz = 100\nmethods = [\"quadrature\"]\n";
    let long = with(&watched(SMALL), "repeat = 10", "repeat = 60");
    let few = with(&long, "values = [30, 70]", "values = [70]");
    let few = with(&few, "to = 0.6, count = 3", "to = 0.6, count = 2");
    let place = Workplace::with_small(&with(&few, own, asked));
    each_row_is_its_case(&place, "small.toml", &[], true);
    std::fs::remove_dir_all(place.path("run")).unwrap();
    each_row_is_its_case(&place, "small.toml", &["--full"], true);
}

/// Whirl that has settled ends a run's case, and its measures are those of that
/// instant; the history continues, and its later values are reported next to them.
#[test]
fn whirl_that_a_run_ends_early_is_that_of_the_run_and_its_later_numbers_are_reported() {
    let base = format!("{}/../../sweeps/academic.toml", env!("CARGO_MANIFEST_DIR"));
    let sweep = format!(
        "base = \"{base}\"\nmethods = [\"quadrature\"]\n\
         [wall]\nclearance_mm = 40\nstiffness_gn_m15 = 1\n\
         [[sites]]\ndistance_from_bit_m = 0\n\
         [[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n\
         [design]\nkind = \"grid\"\n[design.axes]\nfriction = {{ values = [0.5, 2] }}\n"
    );
    let place = Workplace::with_small(&sweep);
    each_row_is_its_case(&place, "small.toml", &[], false);
    let ended = labels(&place, "run", ["ended"]).concat();
    assert_eq!(ended[1], "settled", "{ended:?}");
    let answer = succeeds(&place, &["simulate", "small.toml", "--case", "1"]);
    for words in ["a run stops at", "as settled; followed to 10 s:"] {
        assert!(answer.output.contains(words), "{answer:?}");
    }
    let answer = succeeds(&place, &["simulate", "small.toml", "--case", "1", "--full"]);
    assert!(!answer.output.contains("a run stops"), "{answer:?}");
}

/// Runs the command of every failure as its user would, through a shell.
#[track_caller]
fn each_failure_is_repeated(place: &Workplace, run: &[&str], failures: usize) {
    let answer = place.sweep(run);
    assert_eq!(answer.code, 3, "{answer:?}");
    let records = columns(
        &table(&text(place, "run/failures.csv")),
        ["case", "method", "reason", "repeat_with"],
    );
    assert_eq!(records.len(), failures);
    let program = Path::new(assert_cmd::cargo::cargo_bin!("sweep"));
    let known = std::env::var_os("PATH").unwrap();
    let folders = std::iter::once(program.parent().unwrap().to_owned());
    let path = std::env::join_paths(folders.chain(std::env::split_paths(&known))).unwrap();
    for [case, method, reason, command] in &records {
        let output = Command::new("sh")
            .args(["-c", command])
            .env("PATH", &path)
            .current_dir(place.path(""))
            .output()
            .unwrap();
        let errors = complaints(&String::from_utf8(output.stderr).unwrap());
        assert_eq!(output.status.code(), Some(3), "{command}: {errors}");
        let expected = format!("error: case {case} by {method} has no answer: {reason}\n");
        assert_eq!(errors, expected, "{command}");
        assert_eq!(output.stdout, b"", "{command}");
    }
}

/// With elements as long as the transform is short, one string chatters.
pub fn with_chattering_string() -> String {
    let filter = "[method.hilbert]\ntransform_s = 0.6\n[design]";
    let text = with(&by_two_methods("hilbert"), "[design]", filter);
    let axis = "[design.axes]\ntorsional_damping_nms_rad_m = { values = [2, 2000] }\n";
    with(&text, "[design.axes]\n", axis)
}

#[test]
fn the_command_of_a_failure_repeats_it_with_any_file_name() {
    let quoted = "it's a $HOME of \"sweeps\".toml";
    for name in ["-dash.toml", quoted, "plain.toml"] {
        let place = Workplace::new();
        place.write(name, with_chattering_string());
        let run = ["run", "--quiet", "--out", "run", "--", name];
        each_failure_is_repeated(&place, &run, 6);
    }
}

#[test]
fn the_command_of_a_failure_runs_on_the_terms_of_its_run() {
    let place = Workplace::with_small(&with_chattering_string());
    let run = ["run", "small.toml", "--quiet", "--out", "run", "--full"];
    each_failure_is_repeated(&place, &run, 6);
    assert_eq!(
        text(&place, "run/failures.csv")
            .matches(" --full\n")
            .count(),
        6
    );
    // What it could do is shown where that is allowed.
    let shown = ["simulate", "small.toml", "--case", "0", "--allow-unstable"];
    let answer = place.sweep(&shown);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(answer.errors.starts_with("warning: "), "{answer:?}");
}

#[test]
fn strings_that_cannot_be_fail_alike_under_an_accuracy_too() {
    let axis = "[design.axes]\nsection_0_part_0_inner_radius_m = { values = [0.04, 0.2] }\n";
    let impossible = with(SMALL, "[design.axes]\n", axis);
    let place = Workplace::with_small(&impossible);
    let run = ["run", "small.toml", "--quiet", "--out", "run"];
    each_failure_is_repeated(&place, &run, 6);
    let own = "sampling_frequency_hz = 100\nmethods = [\"quadrature\"]\n";
    let long = with(&impossible, "repeat = 10", "repeat = 60");
    let place = Workplace::with_small(&with(&long, own, "accuracy = \"30 %\"\n"));
    each_failure_is_repeated(&place, &run, 6);
}

/// An undamped string is nothing for the digital filter, and for no other method.
#[test]
fn what_one_method_cannot_treat_another_answers() {
    let methods = by_methods(SMALL, "methods = [\"hilbert\", \"quadrature\"]");
    let axis = "[design.axes]\ntorsional_damping_nms_rad_m = { values = [10, 0] }\n";
    let place = Workplace::with_small(&with(&methods, "[design.axes]\n", axis));
    let run = ["run", "small.toml", "--quiet", "--out", "run"];
    each_failure_is_repeated(&place, &[&run[..], &["--allow-unstable"]].concat(), 6);
    for [method, damping, status] in labels(
        &place,
        "run",
        ["method", "torsional_damping_nms_rad_m", "status"],
    ) {
        let fails = method == "hilbert" && damping == "0";
        assert_eq!(status, if fails { "failed" } else { "ok" });
    }
}

#[test]
fn what_the_sweep_does_not_depend_on_is_not_set() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    for (set, meant) in [
        ("friction=1.3", "--set friction: there is no wall"),
        (
            "impulse_ratio=2",
            "--set impulse_ratio: no impulse of this sweep",
        ),
    ] {
        let command = ["simulate", "small.toml", "--set", set];
        refused(&place, &command, &[meant]);
    }
}
