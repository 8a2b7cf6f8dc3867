//! Methods that chatter in sticking: refused by `run`, warned of elsewhere.

use crate::command_line::same_case::with_chattering_string;
use crate::command_line::{by_two_methods, columns, labels, run, table};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

const CHATTERING: &str = "small.toml:6: `methods[1]`: the responses in torsion by direct-idft \
                          are not positive-real";

fn with_direct() -> String {
    by_two_methods("direct-idft")
}

const ALLOWED: [&str; 5] = ["run", "small.toml", "--out", "results", "--allow-unstable"];

#[test]
fn an_unstable_method_is_refused_before_anything_is_simulated() {
    let place = Workplace::with_small(&with_direct());
    refused(
        &place,
        &ALLOWED[..4],
        &[CHATTERING, "margin -", "--allow-unstable"],
    );
    let place = Workplace::with_small(SMALL);
    let chosen = ["run", "small.toml", "--methods", "direct-idft"];
    let words = ["--methods: ", "direct-idft", "another method"];
    refused(&place, &chosen, &words);
    let undamped = with(
        SMALL,
        "[design]",
        "[method.finite-element]\ngamma = 0.5\n[design]",
    );
    let place = Workplace::with_small(&with(&undamped, "\"quadrature\"", "\"finite-element\""));
    refused(&place, &ALLOWED[..4], &["`methods[0]`", "a larger gamma"]);
}

#[test]
fn an_unstable_method_that_is_allowed_is_warned_of() {
    let place = Workplace::with_small(&with_direct());
    let answer = place.sweep(&ALLOWED);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(
        answer
            .errors
            .starts_with("warning: the responses in torsion by direct-idft")
    );
    assert_eq!(labels(&place, "results", ["status"]).len(), 12);
    // A folder with doubtful labels is not one without.
    refused(&place, &ALLOWED[..4], &["--allow-unstable: true → null"]);
}

#[test]
fn other_commands_only_warn() {
    let place = Workplace::with_small(&with_direct());
    for command in [["simulate", "small.toml"], ["check", "small.toml"]] {
        place.write(
            "labels.csv",
            "case,method,surface_speed_rpm,weight_on_bit_kn,torsion\n\
                                   0,direct-idft,0.6,30,smooth\n",
        );
        let reference = (command[0] == "check").then_some("labels.csv");
        let answer = place.sweep(&command.into_iter().chain(reference).collect::<Vec<_>>());
        assert!([0, 5].contains(&answer.code), "{answer:?}");
        assert!(answer.errors.starts_with("warning: "), "{answer:?}");
    }
    let answer = place.sweep(&["inspect", "small.toml"]);
    assert!(
        answer.output.contains("a stuck site chatters"),
        "{answer:?}"
    );
}

#[test]
fn where_strings_differ_each_has_its_own_margin() {
    let place = Workplace::with_small(&with_chattering_string());
    let answer = place.sweep(&ALLOWED[..4]);
    assert_eq!(answer.code, 3, "{answer:?}");
    let failures = table(&crate::command_line::text(&place, "results/failures.csv"));
    let failed = columns(&failures, ["case", "method", "reason", "repeat_with"]);
    assert_eq!(failed.len(), 6);
    for (case, [index, method, reason, repeat]) in failed.iter().enumerate() {
        assert_eq!((index, method.as_str()), (&case.to_string(), "hilbert"));
        assert!(reason.contains("not positive-real"), "{reason}");
        assert!(reason.contains("--allow-unstable"), "{reason}");
        let answer = place.sweep(&repeat.split(' ').skip(1).collect::<Vec<_>>());
        assert_eq!(answer.code, 3, "{answer:?}");
        assert!(answer.errors.contains(reason), "{answer:?}");
    }
    let answer = place.sweep(&[&ALLOWED[..], &["--fresh"]].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
}

/// Its responses never decay, and are cut where the simulation ends.
#[test]
fn a_string_without_damping_is_no_false_alarm() {
    let undamped = with(SMALL, "rad_m = 10\n", "rad_m = 0\n");
    run(&Workplace::with_small(&undamped), "small.toml", "results");
    let elements = with(&undamped, "\"quadrature\"", "\"finite-element\"");
    run(&Workplace::with_small(&elements), "small.toml", "results");
    let chattering = with(
        &elements,
        "[design]",
        "[method.finite-element]\ngamma = 0.5\n[design]",
    );
    let place = Workplace::with_small(&chattering);
    refused(
        &place,
        &["run", "small.toml"],
        &["finite-element", "not positive-real"],
    );
}
