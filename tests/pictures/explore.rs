//! `sweep explore`: its page is played with in headless Chromium, and the history that it shows
//! at last held against `sweep simulate`.

use std::path::Path;
use std::process::Command;

use crate::support::{CUTTING, SMALL, Workplace, with};
use serde_json::Value;

/// Most bytes of a page.
const LARGEST: u64 = 3 << 20;

#[test]
fn a_page_is_one_small_file_with_the_case_in_it() {
    let place = Workplace::new();
    // A name that a terminal would take for two.
    std::fs::write(place.path("a small one.toml"), SMALL).unwrap();
    let done = place.sweep(&["explore", "a small one.toml", "--case", "2"]);
    assert_eq!(
        (done.code, &*done.output),
        (0, "explore.html\n"),
        "{}",
        done.errors
    );
    let html = std::fs::read_to_string(place.path("explore.html")).unwrap();
    assert!(html.len() as u64 <= LARGEST, "{} bytes", html.len());
    assert!(html.contains("sweep simulate 'a small one.toml' --case 2"));
    // A browser runs no other script, and lets the page fetch nothing.
    let script = html.split("<script>").nth(1).unwrap();
    let script = script.split("</script>").next().unwrap();
    let digest = <sha2::Sha256 as sha2::Digest>::digest(script);
    let hash = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, digest);
    let policy = html.split("Content-Security-Policy\" content=\"").nth(1);
    let policy = policy.unwrap().split('"').next().unwrap();
    assert!(policy.starts_with("default-src 'none';"), "{policy}");
    let own = format!("script-src 'sha256-{hash}' 'wasm-unsafe-eval' blob:;");
    assert!(policy.contains(&own), "{policy}");
    // What is seen without scripts.
    assert!(html.contains("Greatest bit speed (rpm)</td>"));
    let refused = place.sweep(&["explore", "a small one.toml", "--case", "6"]);
    assert_eq!(refused.code, 2, "{}", refused.errors);
    assert!(
        refused.errors.contains("case 6: there are cases 0 to 5"),
        "{}",
        refused.errors
    );
}

/// With friction all along the string, what `held` builds takes minutes in a browser.
#[test]
fn a_page_simulates_by_a_method_that_is_built_within_seconds() {
    let friction = "[well]\nsurvey = \"survey.csv\"\n[string_friction]\nstatic_coefficient = 0.3\n\
        dynamic_ratio = 0.7\nstribeck_rpm = 5\npressed_by = \"weight\"\n[design]";
    let small = with(SMALL, "[design]", friction);
    let method_of = |methods: &str| {
        let place = Workplace::new();
        place.write(
            "survey.csv",
            "md_m,inc_deg,azi_deg\n0,0,0\n200,40,0\n9000,40,0\n",
        );
        let sweep = with(
            &small,
            "methods = [\"quadrature\"]",
            &format!("methods = {methods}"),
        );
        place.write("sweep.toml", &sweep);
        let done = place.sweep(&["explore", "sweep.toml"]);
        assert_eq!(done.code, 0, "{}", done.errors);
        let html = std::fs::read_to_string(place.path("explore.html")).unwrap();
        let data = html.split("id=\"data\">").nth(1).unwrap();
        let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
        let why = data["why"].as_str().unwrap();
        assert!(why.contains("the string is stepped in "), "{why}");
        for control in data["controls"].as_array().unwrap() {
            let of_string = control["axis"] == "torsional_damping_nms_rad_m";
            assert_eq!(control["of_string"], of_string, "{control}");
        }
        [data["method"].clone(), data["slow"].clone()]
    };
    assert_eq!(
        method_of("[\"held\", \"quadrature\"]"),
        ["quadrature", "held"]
    );
    assert_eq!(method_of("[\"held\"]"), ["held", "held"]);
    assert_eq!(
        method_of("[\"quadrature\"]"),
        [Value::from("quadrature"), Value::Null]
    );
}

#[test]
#[ignore = "needs Node and Chromium"]
fn what_a_page_shows_at_last_is_what_its_command_simulates() {
    held_to_its_command(SMALL);
}

/// Sliders, numbers and the command are in these units then.
#[test]
#[ignore = "needs Node and Chromium"]
fn so_it_is_in_field_units() {
    let html = held_to_its_command(&format!("units = \"field\"\n{SMALL}"));
    assert!(html.contains("Weight on bit W (klbf)") && html.contains("klbf ft"));
    assert!(html.contains("\"name\":\"weight_on_bit_klbf\""));
    assert!(html.contains("Dynamic torque T_d (lbf ft)</td>"));
}

/// Weight, depth of cut and depth of the bit are among what is held to the command.
#[test]
#[ignore = "needs Node and Chromium"]
fn so_it_is_of_a_bit_that_cuts() {
    let html = held_to_its_command(&with(CUTTING, "time_s = 20", "time_s = 12"));
    assert!(html.contains("penetration in the closing window (m/h)</td>"));
}

/// No limit of a torque that is not given; a place to drag the case to; why a case takes long.
#[test]
fn a_page_of_a_bit_that_cuts_has_its_own_sliders_and_no_limit() {
    let data_of = |text: &str| -> Value {
        let place = Workplace::with_small(text);
        let done = place.sweep(&["explore", "small.toml"]);
        assert_eq!(done.code, 0, "{}", done.errors);
        let html = std::fs::read_to_string(place.path("explore.html")).unwrap();
        let data = html.split("id=\"data\">").nth(1).unwrap();
        serde_json::from_str(data.split("</script>").next().unwrap()).unwrap()
    };
    let data = data_of(CUTTING);
    let axes = serde_json::json!(["weight_on_bit_kn", "surface_speed_rpm"]);
    let map = serde_json::json!({ "of": "drilling", "axes": axes, "lines": [] });
    assert_eq!(data["map"], map);
    assert_eq!(data["why"], Value::Null);
    let long = data_of(&with(CUTTING, "time_s = 20", "time_s = 2000"));
    let why = long["why"].as_str().unwrap();
    assert!(
        why.contains("to the end of its 2000 s, 400 thousand steps"),
        "{why}"
    );
    let controls = data["controls"].as_array().unwrap().iter();
    let controls: Vec<&str> = controls.map(|it| it["axis"].as_str().unwrap()).collect();
    for axis in [
        "rock_specific_energy_mpa",
        "rock_wear_flat_mm",
        "weight_on_bit_kn",
    ] {
        assert!(controls.contains(&axis), "{axis} in {controls:?}");
    }
    assert!(!controls.contains(&"torque_static_ratio"), "{controls:?}");
}

/// A case sticks and slips above the line of Eq. 74, which asks what one slip does: its page says what
/// it is, and from the line alone no smooth rotation, in words or shades.
#[test]
#[ignore = "needs Node"]
fn a_case_that_sticks_above_eq_74_is_nowhere_called_smooth() {
    let place = Workplace::new();
    assert_eq!(place.sweep(&["new", "sweep.toml"]).code, 0);
    let page_of = |case: &str| -> Value {
        let done = place.sweep(&["explore", "sweep.toml", "--case", case]);
        assert_eq!(done.code, 0, "{}", done.errors);
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/page/shown.mjs");
        let shown = Command::new("node")
            .arg(script)
            .arg(place.path("explore.html"))
            .output()
            .expect("Node");
        let errors = String::from_utf8_lossy(&shown.stderr);
        assert!(shown.status.success(), "{errors}");
        serde_json::from_slice(&shown.stdout).unwrap()
    };
    // 5 rpm at 20 kN, where the line is at 4 rpm; and 5 rpm at 120 kN, below it.
    for (case, side) in [("1", "above"), ("11", "below")] {
        let page = page_of(case);
        let text = |key: &str| page[key].as_str().unwrap();
        assert_eq!(text("regime"), "stick slip", "{page}");
        let expected = format!(" rpm {side} the one-slip estimate (Eq. 74), ");
        assert!(text("side").contains(&expected), "{page}");
        for words in ["side", "map"] {
            assert!(!text(words).contains("smooth"), "{page}");
            assert!(!text(words).contains("limit"), "{page}");
        }
        assert_eq!((&page["areas"], &page["lines"]), (&0.into(), &1.into()));
    }
}

/// Between walls the lines of the map come with the page.
#[test]
fn the_limit_of_whirl_is_that_of_the_sweeps_map() {
    let place = Workplace::new();
    let base = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig12.toml");
    let axes = "surface_speed_rpm = { from = 60, to = 120, count = 2 }\n\
                friction = { from = 0.5, to = 2, count = 2 }";
    let text = format!("base = '{base}'\n[design]\nkind = 'grid'\n[design.axes]\n{axes}\n");
    std::fs::write(place.path("wall.toml"), text).unwrap();
    let done = place.sweep(&["explore", "wall.toml"]);
    assert_eq!(done.code, 0, "{}", done.errors);
    let html = std::fs::read_to_string(place.path("explore.html")).unwrap();
    let data = html.split("id=\"data\">").nth(1).unwrap();
    let data: Value = serde_json::from_str(data.split("</script>").next().unwrap()).unwrap();
    assert_eq!(
        data["map"]["axes"],
        serde_json::json!(["surface_speed_rpm", "friction"])
    );
    let piece = data["map"]["lines"][0]["pieces"][0].as_array().unwrap();

    let done = place.sweep(&["run", "wall.toml", "--out", "out"]);
    assert_eq!(done.code, 0, "{}", done.errors);
    let boundary = std::fs::read_to_string(place.path("out/boundary.csv")).unwrap();
    assert!(piece.len() > 10, "{piece:?}");
    for point in piece {
        let row = format!("\n{},{},", point[0], point[1]).replace(".0,", ",");
        assert!(boundary.contains(&row), "{row} is not in {boundary}");
    }
}

/// Plays with the page of a sweep, which it gives, and simulates what it shows at last.
fn held_to_its_command(text: &str) -> String {
    let place = Workplace::new();
    std::fs::write(place.path("small.toml"), text).unwrap();
    let done = place.sweep(&["explore", "small.toml"]);
    assert_eq!(done.code, 0, "{}", done.errors);
    let html = std::fs::read_to_string(place.path("explore.html")).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/look-at-explore.mjs");
    let looked = Command::new("node")
        .arg(script)
        .args([place.path("explore.html"), place.path("look")])
        .output()
        .expect("Node");
    let errors = String::from_utf8_lossy(&looked.stderr);
    assert!(looked.status.success(), "{errors}");
    println!("{}", String::from_utf8_lossy(&looked.stdout));

    let shown = std::fs::read_to_string(place.path("look").join("history.json")).unwrap();
    let shown: Value = serde_json::from_str(&shown).unwrap();
    let command = shown["command"]
        .as_str()
        .unwrap()
        .strip_prefix("sweep ")
        .unwrap();
    assert!(command.contains(" --set "), "{command}");
    let arguments: Vec<&str> = command.split(' ').chain(["--out", "one"]).collect();
    let done = place.sweep(&arguments);
    assert_eq!(done.code, 0, "{}", done.errors);
    let mut table = csv::Reader::from_path(place.path("one").join("history.csv")).unwrap();
    let names = table.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let history = shown["history"].as_object().unwrap();
    assert_eq!(history.len() + 2, names.len());
    for (name, values) in history {
        let place = names.iter().position(|other| other == name).unwrap();
        let expected = rows.iter().map(|row| row[place].parse::<f64>().unwrap());
        let size = expected
            .clone()
            .fold(0.0, |size: f64, value| size.max(value.abs()));
        let found = values
            .as_array()
            .unwrap()
            .iter()
            .map(|value| value.as_f64().unwrap());
        assert_eq!(found.len(), rows.len());
        let off = found
            .zip(expected)
            .fold(0.0, |off: f64, (one, other)| off.max((one - other).abs()));
        assert!(off <= 1e-9 * size, "{name} is off by {off} of {size}");
    }
    html
}
