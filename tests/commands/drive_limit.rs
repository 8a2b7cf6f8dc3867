//! A top drive that gives no more than its greatest torque: what the commands say of it, its labels,
//! and what is refused.

use serde_json::Value;

use super::cutting::{columns, done};
use crate::support::{CUTTING, SMALL, Workplace, with};

/// The small string below a drive, without the place that is only observed, and other keys before
/// all tables.
fn below(drive: &str, keys: &str) -> String {
    let alone = with(SMALL, "[[sites]]\ndistance_from_bit_m = 50\n", "");
    let drive =
        format!("[top_drive]\ninertia_kg_m2 = 2000\ncontroller = \"stiff\"\n{drive}\n[design]\n");
    format!("{keys}{}", with(&alone, "[design]\n", &drive))
}

fn limited(torque_kn_m: f64) -> String {
    format!("torque_limit_kn_m = {torque_kn_m}\nsaturates = true\n")
}

/// A column of `labels.csv` after a run.
fn column(text: &str, name: &str) -> Vec<String> {
    let place = Workplace::with_small(text);
    let run = place.answer(&["run", "small.toml", "--out", "out"]);
    assert_eq!(run.code, 0, "{}", run.errors);
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let rows: Vec<Vec<String>> = (labels.lines())
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect();
    let at = rows[0].iter().position(|it| it == name).unwrap();
    rows[1..].iter().map(|row| row[at].clone()).collect()
}

#[test]
fn a_limit_that_only_warns_leaves_every_byte() {
    let labels = |drive: &str| {
        let place = Workplace::with_small(&below(drive, ""));
        let run = place.answer(&["run", "small.toml", "--out", "out"]);
        assert_eq!(run.code, 0, "{}", run.errors);
        std::fs::read(place.path("out/labels.csv")).unwrap()
    };
    assert_eq!(labels(""), labels("torque_limit_kn_m = 0.5\n"));
}

/// Far above all torques it changes no label, below that of the bit everything is stuck.
#[test]
fn a_drive_without_the_torque_for_the_bit_stalls() {
    let linear = column(&below("", ""), "torsion");
    assert_eq!(column(&below(&limited(1e4), ""), "torsion"), linear);
    let stalled = column(&below(&limited(0.5), ""), "torsion");
    assert!(stalled.iter().all(|label| label == "stuck"), "{stalled:?}");
    assert_ne!(stalled, linear);
}

/// A string of 300 m below a motor of 4 kN m and a rotor of 2000 kg m², simulated from both starts at a speed
/// under some torque: all it needs but for 0.1 N m s/m of damping is that.
fn nearly_stalling(keys: &str, [rpm, torque_nm]: [f64; 2]) -> String {
    format!(
        "methods = [\"held\"]\nsampling_frequency_hz = 400\nstart = \"both\"\n{keys}surface_speed_rpm = {rpm}\n\
         [string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7840\ntorsional_damping_nms_rad_m = 0.1\n\
         sections = [{{ repeat = 1, parts = [{{ length_m = 300, inner_radius_m = 0.05, outer_radius_m = 0.07 }}] }}]\n\
         [bit]\ntorque_static_ratio = 1.3\n[top_drive]\ninertia_kg_m2 = 2000\ncontroller = \"stiff\"\n{}\
         [design]\nkind = \"grid\"\n[design.axes]\ntorque_dynamic_nm = {{ values = [{torque_nm}] }}\n",
        limited(4.0)
    )
}

/// A bit that takes 50 N m more than the drive gives slows down for minutes: that is no smooth rotation.
#[test]
fn a_bit_that_slows_down_is_followed_until_it_stalls() {
    assert_eq!(
        column(&nearly_stalling("", [30.0, 4050.0]), "torsion"),
        ["stuck"]
    );
    let place = Workplace::with_small(&nearly_stalling("time_s = 40\n", [30.0, 4050.0]));
    let run = done(&place, &["run", "small.toml", "--out", "out"]);
    let said = run.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("in 1 of 1 row"), "{said}");
    assert!(said.contains("the bit still changed its speed"), "{said}");
}

/// Held it stalls, and turning it turns on.
#[test]
fn where_a_drive_stalls_by_the_start_the_case_is_bistable() {
    let text = nearly_stalling("", [10.0, 3980.0]);
    let [case, stuck, smooth] =
        ["torsion", "torsion_from_stuck", "torsion_from_smooth"].map(|name| column(&text, name));
    let found = [&case[0], &stuck[0], &smooth[0]];
    assert_eq!(found, ["bistable", "stuck", "smooth"]);
}

/// What turns the surface is in the rows and in the history, and never more than the limit.
#[test]
fn the_torque_is_recorded_and_within_its_limit() {
    let text = below(&limited(3.0), "start = \"ramp\"\n");
    let peaks = column(&text, "surface_torque_peak_nm");
    // The slowest asks for less.
    assert!(peaks[1..].iter().all(|peak| peak == "3000"), "{peaks:?}");
    assert!(peaks[0].parse::<f64>().unwrap() < 3000.0, "{peaks:?}");
    let place = Workplace::with_small(&text);
    let simulated = place.answer(&["simulate", "small.toml", "--case", "5", "--out", "out"]);
    assert_eq!(simulated.code, 0, "{}", simulated.errors);
    let history = std::fs::read_to_string(place.path("out/history.csv")).unwrap();
    let heading: Vec<&str> = history.lines().next().unwrap().split(',').collect();
    let at = (heading.iter()).position(|name| *name == "motor_torque_nm");
    let torques: Vec<f64> = (history.lines().skip(1))
        .map(|line| line.split(',').nth(at.unwrap()).unwrap().parse().unwrap())
        .collect();
    assert!(torques.iter().all(|torque| torque.abs() <= 3000.0));
    assert!(torques.contains(&3000.0));
}

#[test]
fn inspect_says_that_the_torque_is_limited_and_what_follows() {
    let place = Workplace::with_small(&below(&limited(0.5), ""));
    let found = place.answer(&["inspect", "small.toml"]);
    assert_eq!(found.code, 0, "{}", found.errors);
    let says = "torque                     limited to 500 N m";
    assert!(found.output.contains(says), "{}", found.output);
    for words in [
        "there the string turns more slowly",
        "only a rotor that swings",
    ] {
        assert!(found.errors.contains(words), "{}", found.errors);
    }
    let found = place.answer(&["inspect", "small.toml", "--json"]);
    let found: Value = serde_json::from_str(&found.output).unwrap();
    assert_eq!(found["top_drive"]["limited_to_kn_m"], 0.5);
    let linear = Workplace::with_small(&below("torque_limit_kn_m = 0.5\n", ""));
    let found = linear.answer(&["inspect", "small.toml"]);
    assert!(!found.output.contains("limited to"), "{}", found.output);
}

/// Below a drive that could give any torque labels are those below the linear one, with walls, friction along
/// the string, a motor, a bit that cuts and places that are only observed; one that has little gives no
/// more, in rows and histories.
#[test]
fn it_turns_a_string_with_all_that_acts_on_it() {
    const SITES: &str = "[[sites]]\ndistance_from_bit_m = 0\n[[sites]]\ndistance_from_bit_m = 50\n";
    const FRICTION: &str = "[well]\ninclination_deg = 60\n[string_friction]\nstatic_coefficient = 0.1\n\
                            pieces = 4\n";
    const MOTOR: &str = "[motor]\nspeed_rpm = 100\nstall_torque_kn_m = 10\n";
    let walls = format!(
        "[string.bending]\nyoungs_modulus_gpa = 206\ndamping_ns_m2 = 100\n[wall]\nclearance_mm = 20\n\
         friction = 0.3\n{SITES}[[impulses]]\ndistance_from_bit_m = 0\namount_ns = 3000\nstart_s = 1\n"
    );
    let rises = "surface_speed_rise_s = 2\ntime_s = 12\n";
    let small = |more: &str, drive: &str| {
        let text = with(&below(drive, ""), "time_s = 12\n", rises);
        format!("{text}\n{more}")
    };
    let labels = |text: &str| {
        let place = Workplace::with_small(text);
        done(&place, &["run", "small.toml", "--out", "out"]);
        columns(&place, "out/labels.csv", ["torsion", "lateral"])
    };
    for (more, method) in [
        (SITES.to_owned(), "quadrature"),
        (walls.clone(), "finite-element"),
        (format!("{walls}{MOTOR}"), "quadrature"),
        (FRICTION.to_owned(), "held"),
        (format!("{MOTOR}{FRICTION}"), "quadrature"),
    ] {
        let by_method = format!("\"{method}\"");
        let text = |drive: &str| small(&more, drive).replace("\"quadrature\"", &by_method);
        assert_eq!(labels(&text(&limited(1e5))), labels(&text("")), "{more}");
        within_its_limit(&text(&limited(2.0)), 2000.0);
    }
    let cutting = |drive: &str| {
        let drive = format!(
            "[top_drive]\ninertia_kg_m2 = 2000\ncontroller = \"stiff\"\n{drive}\n[design]\n"
        );
        let rises = "surface_speed_rise_s = 2\ntime_s = 20\n";
        with(&with(CUTTING, "[design]\n", &drive), "time_s = 20\n", rises)
    };
    let steady = |drive: &str| column(&cutting(drive), "axial");
    assert_eq!(steady(&limited(1e5)), steady(""));
    within_its_limit(&cutting(&limited(2.0)), 2000.0);
    // Steady drilling is where the drive has the torque for it.
    let drills = |drive: &str| {
        let place = Workplace::with_small(&cutting(drive));
        let said = done(&place, &["inspect", "small.toml", "--modes"]);
        said.contains("steady drilling, by the roots of D(s)")
    };
    assert!(drills("") && drills(&limited(1e5)) && !drills(&limited(0.5)));
}

/// The drive meets its limit (N m), and gives no more.
fn within_its_limit(text: &str, limit: f64) {
    let number = |text: &String| text.parse::<f64>().unwrap();
    let peaks = column(text, "surface_torque_peak_nm");
    assert!(peaks.iter().all(|peak| number(peak) <= limit), "{peaks:?}");
    assert!(
        peaks.iter().any(|peak| number(peak) == limit),
        "{peaks:?}\n{text}"
    );
    let place = Workplace::with_small(text);
    let simulated = place.answer(&["simulate", "small.toml", "--case", "3", "--out", "out"]);
    assert_eq!(simulated.code, 0, "{}", simulated.errors);
    let history = columns(&place, "out/history.csv", ["motor_torque_nm"]).concat();
    assert!(history.iter().all(|torque| number(torque).abs() <= limit));
}

#[test]
fn what_does_not_go_with_it_is_refused_by_its_key() {
    let limit = limited(20.0);
    for (drive, keys, end, key) in [
        ("saturates = true\n", "", "", "top_drive.saturates"),
        (
            &*format!("{limit}delay_ms = 1\n"),
            "",
            "",
            "top_drive.delay_ms",
        ),
        (&limit, "methods = [\"hilbert\"]\n", "", "methods"),
        (&limit, "accuracy = \"1 %\"\n", "", "accuracy"),
        (
            &limit,
            "methods = [\"held\", \"finite-element\"]\ncertify = true\n",
            "",
            "certify",
        ),
        (
            &limit,
            "",
            "[string_friction]\nstatic_coefficient = 0.3\ntorque_along_string = true\n[well]\ninclination_deg = 60\n",
            "string_friction.torque_along_string",
        ),
    ] {
        let mut text = below(drive, keys);
        if keys.contains("methods") || keys.contains("accuracy") {
            text = text.replace("\nmethods = [\"quadrature\"]", "");
        }
        let place = Workplace::with_small(&format!("{text}\n{end}"));
        let refused = place.answer(&["run", "small.toml", "--dry-run"]);
        assert_eq!(refused.code, 2, "{key}: {}", refused.errors);
        let named = format!("`{key}`");
        assert!(refused.errors.contains(&named), "{key}: {}", refused.errors);
    }
    let prescribed = below(&limit, "").replace("\"stiff\"", "\"prescribed\"");
    let place = Workplace::with_small(&prescribed);
    let refused = place.answer(&["run", "small.toml", "--dry-run"]);
    assert!(refused.errors.contains("`top_drive."), "{}", refused.errors);
}
