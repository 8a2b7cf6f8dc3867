//! `--methods` stands in place of what the file says of methods.

use crate::command_line::{labels, succeeds};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

const OWN: &str = "methods = [\"quadrature\"]";

fn undamped(text: &str) -> String {
    with(text, "rad_m = 10\n", "rad_m = 0\n")
}

#[test]
fn other_methods_replace_those_of_the_file() {
    let unknown = with(SMALL, OWN, "methods = [\"quadratur\"]");
    let none = with(SMALL, OWN, "methods = []");
    let no_list = with(SMALL, OWN, "methods = \"quadrature\"");
    let impossible = undamped(&with(SMALL, OWN, "methods = [\"hilbert\"]"));
    for file in [unknown, none, no_list, impossible] {
        let place = Workplace::with_small(&file);
        refused(&place, &["run", "small.toml"], &["small.toml:", "`: "]);
        for command in ["run", "simulate", "inspect"] {
            let arguments = [command, "small.toml", "--methods", "quadrature"];
            succeeds(&place, &arguments);
        }
        let methods = labels(&place, "results/small", ["method"]).concat();
        assert_eq!(methods, ["quadrature"; 6]);
    }
}

#[test]
fn the_methods_asked_for_are_checked_as_the_file_s_are() {
    let place = Workplace::with_small(&undamped(SMALL));
    for command in ["run", "simulate", "inspect"] {
        refused(
            &place,
            &[command, "small.toml", "--methods", "hilbert"],
            &[
                "small.toml:11: `string.torsional_damping_nms_rad_m`: ",
                "hilbert",
            ],
        );
    }
}

/// Also of methods that do not run: finite elements draw the whole string, and all of them are
/// written down with the results.
#[test]
fn the_parameters_of_every_method_are_checked() {
    for (parameter, key) in [
        (
            "[method.finite-element]\ngamma = 2.0",
            "method.finite-element.gamma",
        ),
        (
            "[method.finite-element]\nbeta = nan",
            "method.finite-element.beta",
        ),
        (
            "[method.hilbert]\ntransform_s = inf",
            "method.hilbert.transform_s",
        ),
    ] {
        let text = with(SMALL, "[design]\n", &format!("{parameter}\n[design]\n"));
        let place = Workplace::with_small(&text);
        for method in ["quadrature", "finite-element"] {
            let arguments = ["simulate", "small.toml", "--methods", method];
            refused(
                &place,
                &arguments,
                &["small.toml:28: ", &format!("`{key}`: ")],
            );
        }
    }
}

#[test]
fn fronts_that_overshoot_are_warned_of_with_how_far() {
    let parts = "{ length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.125 },\n    \
                 { length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.15 },";
    let tube = "{ length_m = 1000, inner_radius_m = 0.05, outer_radius_m = 0.15 },";
    let uniform = with(&with(SMALL, parts, tube), "repeat = 10", "repeat = 1");
    let uniform = with(&uniform, "frequency_hz = 100", "frequency_hz = 640");
    let place = Workplace::with_small(&uniform);
    for (method, overshoot) in [("quadrature", Some("47 %")), ("held", None)] {
        for command in ["run", "inspect"] {
            let folder = format!("{command}-{method}");
            let answer =
                place.sweep(&[command, "small.toml", "--methods", method, "--out", &folder]);
            let warning = format!("warning: fronts overshoot by {method}: ");
            assert_eq!(answer.errors.contains(&warning), overshoot.is_some());
            assert!(
                overshoot.is_none_or(|part| answer.errors.contains(part)),
                "{answer:?}"
            );
        }
    }
    let manifest = std::fs::read_to_string(place.path("run-held/manifest.json")).unwrap();
    assert!(
        manifest.contains("\"exact_undershoot_rad_s_per_nm\": 0.0000285"),
        "{manifest}"
    );
}
