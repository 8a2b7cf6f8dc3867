//! Command lines that make no sense, and folders that cannot be made.

use crate::refusals::{fails, refused};
use crate::support::{SMALL, Workplace};

#[test]
fn a_command_line_that_makes_no_sense_is_refused() {
    let place = Workplace::with_small(SMALL);
    for (arguments, words) in [
        (
            &["run", "small.toml", "--jobs", "0"][..],
            &["--jobs 0", "at least one"][..],
        ),
        (
            &["run", "small.toml", "--jobs", "100000"],
            &["--jobs 100000: more than", "8 for each of"],
        ),
        (
            &["study", "tradeoff", "--jobs", "100000"],
            &["--jobs 100000"],
        ),
        (
            &["simulate", "small.toml", "--case", "6"],
            &["--case 6", "cases 0 to 5"],
        ),
        (
            &["simulate", "small.toml", "--set", "surface_speed_rpm=0"],
            &["surface_speed_rpm", "the surface must turn"],
        ),
        (
            &["simulate", "small.toml", "--set", "weight_on_bit_kn=nan"],
            &["weight_on_bit_kn", "is not between"],
        ),
    ] {
        refused(&place, arguments, words);
    }
}

#[test]
fn an_impossible_number_of_cores_is_ignored_with_a_warning() {
    let place = Workplace::with_small(SMALL);
    for (name, value) in [
        ("SLURM_CPUS_PER_TASK", "many"),
        ("SLURM_CPUS_PER_TASK", "0"),
        ("SLURM_CPUS_ON_NODE", "-1"),
        ("SLURM_CPUS_ON_NODE", "100000"),
    ] {
        let mut command = place.command(&["run", "small.toml", "--dry-run"]);
        let output = command.env(name, value).output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{errors}");
        let meant = format!("warning: {name}=\"{value}\" is ignored: ");
        assert!(errors.starts_with(&meant), "{errors}");
    }
    // As many as asked for leave no question to the cluster.
    let mut command = place.command(&["run", "small.toml", "--dry-run", "--jobs", "1"]);
    let output = command.env("SLURM_CPUS_PER_TASK", "many").output().unwrap();
    assert_eq!(output.stderr, b"");
}

#[test]
fn an_impossible_amount_of_memory_is_ignored_with_a_warning() {
    let place = Workplace::with_small(SMALL);
    let errors = |value: &str, more: &[&str]| {
        let arguments = [&["run", "small.toml", "--dry-run"], more].concat();
        let mut command = place.command(&arguments);
        let output = command.env("SLURM_MEM_PER_NODE", value).output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(0), "{errors}");
        errors
    };
    for value in ["8G", "-1", "nan", "inf", "1e308"] {
        let meant = format!("warning: SLURM_MEM_PER_NODE=\"{value}\" is ignored: ");
        let errors = errors(value, &[]);
        assert!(errors.starts_with(&meant), "{errors}");
        assert_eq!(errors.lines().count(), 1, "{errors}");
    }
    // All of the node, and what is given instead.
    assert_eq!(errors("0", &[]) + &errors("8G", &["--memory", "1G"]), "");
}

/// What the parser of the command line finds; it adds its own hint.
#[test]
fn an_argument_that_cannot_be_read_is_named() {
    let place = Workplace::with_small(SMALL);
    let before = place.files();
    for (arguments, words) in [
        (
            &["run", "small.toml", "--methods", "magic"][..],
            &["'magic'", "quadrature"][..],
        ),
        (&["run", "small.toml", "--jobs=-1"], &["--jobs", "'-1'"]),
        (
            &["run", "small.toml", "--jobs", "many"],
            &["--jobs", "'many'"],
        ),
        (&["run", "small.toml", "--quite"], &["--quite", "'--quiet'"]),
        (&["run"], &["<FILE>"]),
        (&["rum", "small.toml"], &["rum", "'run'"]),
        (
            &["simulate", "small.toml", "--set", "speed=1"],
            &["unknown axis `speed`", "known: surface_speed_rpm"],
        ),
        (&["simulate", "small.toml", "--set", "1"], &["AXIS=VALUE"]),
        (
            &["simulate", "small.toml", "--set", "surface_speed_rpm=fast"],
            &["`fast` is not a number"],
        ),
    ] {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 2, "{answer:?}");
        for word in words {
            assert!(answer.errors.contains(word), "no {word:?} in {answer:?}");
        }
    }
    assert!(place.files() == before);
}

/// The machine's fault, not the file's. Permissions would not stop root.
#[test]
fn a_folder_that_cannot_be_made_is_a_separate_error() {
    let place = Workplace::with_small(SMALL);
    for command in ["run", "simulate", "inspect"] {
        let answer = fails(
            &place,
            &[command, "small.toml", "--out", "small.toml/results"],
        );
        assert_eq!(answer.code, 1, "{answer:?}");
        assert!(
            answer.errors.contains("small.toml/results cannot be made"),
            "{answer:?}"
        );
    }
}
