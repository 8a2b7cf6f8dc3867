//! What the names of tests say, and what keeps tests from being left out.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::{root, rust_files};

/// A test: the file that it is in, its name, and why it is ignored, if it is.
struct Test {
    file: PathBuf,
    name: String,
    ignored: Option<String>,
}

/// The tests of a file, within macros too.
fn tests_of(file: &Path) -> Vec<Test> {
    let text = std::fs::read_to_string(file).unwrap();
    let pieces = text.split("#[test]\n").skip(1);
    pieces
        .map(|piece| {
            let (before, after) = piece.split_once("fn ").expect("a function");
            let reason = before.split_once("#[ignore");
            Test {
                file: file.strip_prefix(root()).unwrap().to_owned(),
                name: after.split('(').next().unwrap().to_owned(),
                ignored: reason.map(|(_, rest)| {
                    let text = rest.split_once("= \"").expect("a reason").1;
                    text.split('"').next().unwrap().to_owned()
                }),
            }
        })
        .collect()
}

fn all_tests() -> Vec<Test> {
    let mut all = Vec::new();
    for folder in ["tests", "crates"] {
        all.extend(
            rust_files(&root().join(folder))
                .iter()
                .flat_map(|it| tests_of(it)),
        );
    }
    assert!(all.len() > 1000, "{}", all.len());
    all
}

/// What cannot run everywhere is ignored with what it needs, in a program whose ignored tests
/// `.ci/run` runs; nothing else is ignored.
#[test]
fn ignored_tests_say_what_they_need_and_ci_runs_them() {
    let ci = std::fs::read_to_string(root().join(".ci/run")).unwrap();
    let ignored: Vec<Test> = (all_tests().into_iter())
        .filter(|test| test.ignored.is_some())
        .collect();
    assert!(ignored.len() > 8, "{}", ignored.len());
    for Test {
        file,
        name,
        ignored,
    } in ignored
    {
        let reason = ignored.unwrap();
        assert!(
            [
                "needs Slurm",
                "needs Node",
                "needs Node and Chromium",
                "needs valgrind"
            ]
            .contains(&&*reason),
            "{name}: {reason}"
        );
        // tests/PROGRAM/…, of the program or of a library.
        let mut parts = file.components().map(|part| part.as_os_str());
        parts.find(|part| *part == "tests");
        let program = parts.next().unwrap();
        let call = format!("\nignored {} ", program.to_str().unwrap());
        assert!(ci.contains(&call), "{name} is not run by .ci/run: {call:?}");
    }
}

/// Tests in the folders of validation that hold the program to no number: what is refused, what is
/// said and kept.
const BEHAVIOUR: [&str; 21] = [
    "a_case_that_does_not_end_is_kept_aside",
    "an_invalid_hole_is_reported_by_its_key",
    "an_invalid_ladder_or_measure_is_refused",
    "a_position_beyond_all_numbers_is_an_error",
    "a_recorded_surface_and_a_set_speed_replace_one_another",
    "a_run_continues_from_what_is_written_of_it",
    "clearances_are_listed_by_site_and_of_many_sites_the_ends",
    "inspect_says_what_pulls_and_when_it_buckles",
    "inspect_shows_the_reflection_coefficient_and_how_modes_die_away",
    "it_changes_nothing_else_and_does_not_depend_on_how_it_was_run",
    "parameters_that_could_grow_without_bound_are_refused",
    "results_depend_on_what_the_files_say",
    "the_greatest_torque_along_the_string_has_columns",
    "the_same_is_found_on_however_many_threads",
    "what_cannot_be_stepped_is_an_error",
    "what_is_wrong_is_refused_with_its_place",
    "what_is_wrong_is_reported_by_its_key",
    "what_never_decays_is_refused_at_once_where_it_is_simulated_for_too_long",
    "what_no_axial_force_can_be_is_refused",
    "what_no_drive_can_be_is_refused",
    "what_was_found_is_reported_for_the_whole_sweep",
];

/// Where answers are held to numbers, a name says to whose: `val_` to a closed form, the paper, another
/// program or another way to the same; `reg_` to our own earlier answer.
#[test]
fn names_say_validation_or_regression() {
    let mut behaviour: BTreeSet<&str> = BEHAVIOUR.into();
    let all = all_tests();
    for Test { file, name, .. } in &all {
        let is_validation = file
            .components()
            .any(|part| part.as_os_str() == "validation");
        let says = name.starts_with("val_") || name.starts_with("reg_");
        let is_behaviour = is_validation && behaviour.remove(name.as_str());
        assert!(
            says == (is_validation && !is_behaviour),
            "{}: {name} is to begin with val_ or reg_, or to be among BEHAVIOUR",
            file.display()
        );
        let is_regression = file.file_stem().is_some_and(|stem| stem == "regression");
        assert!(!is_regression || name.starts_with("reg_"), "{name}");
    }
    assert!(behaviour.is_empty(), "no longer there: {behaviour:?}");
}
