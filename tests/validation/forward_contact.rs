//! The surface speed from which on an eccentric mass brings the string to its wall, through the
//! binary: compared with simulated cases, on maps, in reports and in the output of `inspect`.

use std::collections::BTreeMap;

use crate::support::Workplace;

/// The string and the mass of Fig. 15 in a design.
fn sweep(axes: &str) -> String {
    let base = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig15.toml");
    format!(
        "base = \"{base}\"\ntime_s = 12\nmethods = [\"quadrature\"]\n\
         [design]\nkind = \"grid\"\n[design.axes]\n{axes}"
    )
}

/// A finished run in `results`, and the points of its manifest: the value, and the speed (rpm).
fn run(axes: &str) -> (Workplace, Option<Vec<[f64; 2]>>) {
    let place = Workplace::with_small(&sweep(axes));
    let answer = place.sweep(&["run", "small.toml", "--out", "results", "--quiet"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let manifest = std::fs::read_to_string(place.path("results/manifest.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    let points = manifest["forward_contact"]["points"].as_array();
    let number = |point: &serde_json::Value, key: &str| point[key].as_f64().unwrap();
    let points = points.map(|points| {
        let points = points.iter();
        points
            .map(|point| ["value", "surface_speed_rpm"].map(|key| number(point, key)))
            .collect()
    });
    (place, points)
}

/// Over the offset of the mass: no case below the line is in contact in the end, and all that are a
/// little above it are.
#[test]
fn val_simulated_cases_touch_above_the_line_and_not_below() {
    let (place, points) = run("surface_speed_rpm = { from = 10, to = 70, count = 9 }\n\
         eccentric_mass_0_offset_m = { from = 0.02, to = 0.2, count = 6 }\n");
    let points = points.unwrap();
    assert!(points.is_sorted_by(|one, next| one[0] < next[0] && one[1] > next[1]));
    let line = |offset: f64| {
        let mut sides = points.windows(2);
        // Numbers of the grid are rounded.
        let side = sides.find(|side| side[0][0] <= offset + 1e-9 && offset <= side[1][0] + 1e-9);
        side.map_or(f64::INFINITY, |side| {
            let part = (offset - side[0][0]) / (side[1][0] - side[0][0]);
            side[0][1] + part * (side[1][1] - side[0][1])
        })
    };
    let rows = csv::Reader::from_path(place.path("results/labels.csv")).unwrap();
    let (mut below, mut above) = (0, 0);
    for row in rows.into_deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        let place = number("surface_speed_rpm") / line(number("eccentric_mass_0_offset_m"));
        let touches = row["lateral"] == "forward_whirl";
        below += usize::from(place < 1.0);
        above += usize::from(place > 1.1);
        assert!(touches || place < 1.1, "{row:?} {place}");
        assert!(!touches || place > 0.999, "{row:?} {place}");
    }
    assert!(below > 10 && above > 20, "{below} {above}");
    let map = std::fs::read_to_string(place.path("results/map.svg")).unwrap();
    assert!(map.contains("eccentric mass brings"));
    let answer = place.sweep(&["report", "results", "--out", "report.html"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let report = std::fs::read_to_string(place.path("report.html")).unwrap();
    assert!(report.contains("Forward whirl: in steady motion the eccentric mass brings"));
}

/// Friction plays no part, so the speed is the same next to a limit of friction; where the
/// clearance differs no speed is given; and where the mass is small the output says that nothing
/// touches.
#[test]
fn val_it_is_given_for_any_friction_and_only_where_it_is_unique() {
    let friction = "friction = { values = [0.3, 1.5] }\n";
    let (place, points) =
        run(&(friction.to_owned() + "surface_speed_rpm = { values = [10, 70] }\n"));
    let [[offset, speed]] = points.unwrap()[..] else {
        panic!("one point");
    };
    assert_eq!(offset, 0.1);
    assert!((speed / 22.59 - 1.0).abs() < 2e-3, "{speed}");
    let map = std::fs::read_to_string(place.path("results/map.svg")).unwrap();
    assert!(map.contains("eccentric mass brings") && map.contains("rolling whirl"));
    let answer = place.sweep(&["inspect", "small.toml", "--out", "look"]);
    let reported = answer
        .output
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(
        reported.contains("brings the string to its wall from 22.59 rpm on"),
        "{reported}"
    );
    let summary = place.sweep(&["summary", "results"]);
    assert!(summary.output.contains("eccentric mass"), "{summary:?}");

    let (_, points) = run(&(friction.to_owned() + "clearance_mm = { values = [10, 20] }\n"));
    assert_eq!(points, None);

    let light = "eccentric_mass_0_mass_kg = { values = [1, 2] }\n";
    let (place, points) = run(&(friction.to_owned() + light));
    assert_eq!(points, Some(vec![]));
    let summary = place.sweep(&["summary", "results"]);
    assert!(summary.output.contains("brings no site"), "{summary:?}");
}
