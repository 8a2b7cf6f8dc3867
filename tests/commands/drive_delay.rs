//! A top drive whose controller answers late: what `inspect` says of it, and what is refused.

use serde_json::Value;

use crate::support::{SMALL, Workplace, with};

/// The small string below a drive.
fn below(drive: &str) -> String {
    with(
        SMALL,
        "[design]\n",
        &format!("[top_drive]\n{drive}\n[design]\n"),
    )
}

const STIFF: &str = "inertia_kg_m2 = 2000\ncontroller = \"stiff\"\n";

#[test]
fn inspect_says_how_late_a_drive_may_answer() {
    let longest_in = |text: &str| {
        let place = Workplace::with_small(text);
        let found = place.answer(&["inspect", "small.toml", "--json"]);
        assert_eq!(found.code, 0, "{}", found.errors);
        let found: Value = serde_json::from_str(&found.output).unwrap();
        found["top_drive"]["longest_delay_ms"].as_f64().unwrap()
    };
    let longest = |drive: &str| longest_in(&below(drive));
    let stiff = longest(STIFF);
    let soft = longest("inertia_kg_m2 = 2000\ncontroller = \"soft-torque\"\n");
    // The softer the controller, the later it may answer.
    assert!(stiff > 1.0 && soft > 2.0 * stiff, "{stiff} {soft}");
    // The delay that it has changes nothing of that.
    let late = longest(&format!("{STIFF}delay_ms = {}\n", 0.5 * stiff));
    assert!((late / stiff - 1.0).abs() < 1e-6);
    // Acceleration is as old as speed: the first mode of 2 km of pipe grows from 22 ms on.
    let compensated = |delay: &str| {
        let drive = "inertia_kg_m2 = 2900\ncontroller = \"impedance-matched\"\ninertia_compensation = 0.9\n";
        let string = "surface_speed_rpm = 60\nmethods = [\"held\"]\n[string]\nshear_modulus_gpa = 80\n\
             density_kg_m3 = 7840\ntorsional_damping_nms_rad_m = 0.03\n[[string.sections]]\nrepeat = 200\n\
             parts = [{ length_m = 10, inner_radius_m = 0.054, outer_radius_m = 0.0635 }]\n[bit]\n\
             torque_dynamic_nm = 10000\n[top_drive]\n";
        longest_in(&format!("{string}{drive}{delay}"))
    };
    assert!((compensated("") - 22.4).abs() < 0.1);
    assert!((compensated("delay_ms = 1\n") - 22.4).abs() < 0.1);
    for (part, code) in [(0.9, 0), (1.1, 2)] {
        let place = Workplace::with_small(&below(&format!("{STIFF}delay_ms = {}\n", part * stiff)));
        let run = place.answer(&["run", "small.toml", "--dry-run"]);
        assert_eq!(run.code, code, "{part}: {}", run.errors);
        let says = run
            .errors
            .contains("`top_drive.delay_ms`: the string grows unstable");
        assert_eq!(says, code != 0, "{}", run.errors);
    }
}

#[test]
fn a_delay_of_what_measures_no_speed_is_refused() {
    for (drive, words) in [
        (
            "inertia_kg_m2 = 2000\ncontroller = \"prescribed\"\ndelay_ms = 20\n",
            "turns as prescribed has none",
        ),
        (
            "inertia_kg_m2 = 2000\ncontroller = \"impedance-matched\"\ndelay_ms = 20\n",
            "needs an inertia",
        ),
        (
            "inertia_kg_m2 = 2000\ncontroller = \"stiff\"\ndelay_ms = -1\n",
            "delay_ms",
        ),
    ] {
        let place = Workplace::with_small(&below(drive));
        let refused = place.answer(&["run", "small.toml", "--dry-run"]);
        assert_ne!(refused.code, 0, "{drive}");
        assert!(
            refused.errors.contains("`top_drive.delay_ms`"),
            "{}",
            refused.errors
        );
        assert!(refused.errors.contains(words), "{}", refused.errors);
    }
}
