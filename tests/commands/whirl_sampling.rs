//! Sampling frequencies by method, where whirl at a wall is fast.

use serde_json::Value;

use crate::support::{Answer, Workplace};

/// A collar with one stabiliser in a vertical hole, hit at its end.
const COLLAR: &str = r#"
methods = ["held", "quadrature", "finite-element"]
time_s = 4
surface_speed_rpm = 120
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 200
[string.bending]
youngs_modulus_gpa = 206
damping_ns_m2 = 400
surface = "clamped"
[[string.sections]]
repeat = 1
parts = [{ length_m = 20, inner_radius_m = 0.038, outer_radius_m = 0.115, contact_radius_m = 0.154 }]
[wall]
clearance_mm = 0.4
stiffness_gn_m15 = 10
[[sites]]
distance_from_bit_m = 0
[[impulses]]
distance_from_bit_m = 0
amount_ns = 3000
[design]
kind = "grid"
[design.axes]
friction = { values = [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55] }
"#;

fn answered(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.answer(arguments);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    answer
}

/// Of each method its name, sampling frequency and steps in a turn of whirl.
fn methods(place: &Workplace, file: &str) -> Vec<(String, f64, f64)> {
    let answer = answered(place, &["inspect", file, "--json"]);
    let found: Value = serde_json::from_str(&answer.output).unwrap();
    let number = |method: &Value, key: &str| method[key].as_f64().unwrap();
    let of = |method: &Value| {
        let name = method["method"].as_str().unwrap().to_owned();
        let [frequency, steps] =
            ["sampling_frequency_hz", "steps_of_whirl"].map(|key| number(method, key));
        (name, frequency, steps)
    };
    found["methods"]
        .as_array()
        .unwrap()
        .iter()
        .map(of)
        .collect()
}

#[test]
fn each_method_is_sampled_as_often_as_whirl_at_its_walls_needs() {
    let place = Workplace::new();
    place.write("collar.toml", COLLAR);
    let found = methods(&place, "collar.toml");
    let names: Vec<&str> = found.iter().map(|method| method.0.as_str()).collect();
    assert_eq!(names, ["held", "quadrature", "finite-element"]);
    for ((_, frequency, steps), needed) in found.iter().zip([7.0, 28.0, 21.0]) {
        assert!((steps / needed - 1.0).abs() < 1e-9, "{found:?}");
        // All look at the same whirl.
        assert!((frequency / steps / (found[0].1 / found[0].2) - 1.0).abs() < 1e-9);
    }
    // A soft wall with much clearance lets it go round slowly, and then waves decide.
    let slow = COLLAR.replace("clearance_mm = 0.4", "clearance_mm = 40");
    place.write("slow.toml", slow);
    let slow = methods(&place, "slow.toml");
    assert!(slow.iter().all(|method| method.1 == slow[0].1), "{slow:?}");
}

#[test]
fn what_a_given_frequency_damps_is_said_before_a_run_and_after_it() {
    let place = Workplace::new();
    place.write(
        "given.toml",
        format!("sampling_frequency_hz = 800\n{COLLAR}"),
    );
    let found = methods(&place, "given.toml");
    assert!(found.iter().all(|method| method.1 == 800.0), "{found:?}");
    let answer = answered(&place, &["run", "given.toml"]);
    for words in [
        "of the steps that a turn needs held at 800 Hz has ",
        "finite-element at 800 Hz has ",
        "leave `sampling_frequency_hz` out, or raise it",
    ] {
        assert!(answer.errors.contains(words), "{}", answer.errors);
    }
    let answer = answered(&place, &["summary", "results/given"]);
    let output = answer
        .output
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    for words in [
        "whirl at another rate or with another force",
        "steps in a turn at 800 Hz, and needs 21",
    ] {
        assert!(output.contains(words), "{output}");
    }
    // By rule there is nothing to say beforehand.
    place.write("rule.toml", COLLAR);
    let answer = answered(&place, &["run", "rule.toml", "--dry-run"]);
    assert!(
        !answer.errors.contains("steps that a turn needs"),
        "{}",
        answer.errors
    );
}
