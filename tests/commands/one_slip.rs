//! The one-slip estimate of stick-slip (Eq. 74) against cases: it is no limit, to either side.

use serde_json::Value;

use crate::support::{SMALL, Workplace};

/// 1900 m of pipe with half-metre tool joints and one constant of damping: the echoes of many joints meet
/// in one deep dip, when a bit that was held is faster than the surface.
const JOINTED: &str = r#"
methods = ["held"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 0.03
[[string.sections]]
repeat = 200
parts = [
    { length_m = 9.05, inner_radius_m = 0.054, outer_radius_m = 0.0635 },
    { length_m = 0.45, inner_radius_m = 0.0413, outer_radius_m = 0.08415 },
]
[bit]
torque_dynamic_nm = 10000
torque_static_ratio = 1.2
[design]
kind = "grid"
[design.axes]
surface_speed_rpm = { values = [50, 60, 100] }
torque_dynamic_nm = { values = [10000] }
"#;

/// What `run` prints of a file, and `summary` of its folder; then rows with stick-slip, those of them
/// above Eq. 74, rows that turn smoothly and those of them below it, from its table.
fn counted(place: &Workplace, file: &str) -> (String, String, [usize; 4]) {
    let answer = |arguments: &[&str]| {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 0, "{}", answer.errors);
        answer
            .output
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    };
    let run = answer(&["run", file, "--out", "out"]);
    let summary = answer(&["summary", "out"]);
    let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let column = |name: &str| header.iter().position(|known| *known == name).unwrap();
    let (torsion, margin) = (column("torsion"), column("stick_slip_margin_rpm"));
    let mut counts = [0; 4];
    for row in lines {
        let is_above = row[margin].parse::<f64>().unwrap() >= 0.0;
        match row[torsion] {
            "stick_slip" => {
                counts[0] += 1;
                counts[1] += usize::from(is_above);
            }
            "smooth" => {
                counts[2] += 1;
                counts[3] += usize::from(!is_above);
            }
            label => panic!("{label}"),
        }
    }
    (run, summary, counts)
}

#[test]
fn stick_slip_above_eq_74_is_counted_and_no_limit_is_claimed() {
    let place = Workplace::new();
    assert_eq!(place.sweep(&["new", "sweep.toml"]).code, 0);
    let (run, summary, counts) = counted(&place, "sweep.toml");
    assert!(counts[1] > 20, "{counts:?}");
    let [sticks, above, smooth, below] = counts;
    let words = format!(
        "{above} of {sticks} cases with stick-slip are above and {below} of {smooth} cases that turn \
         smoothly are below the one-slip estimate (Eq. 74)"
    );
    assert!(run.contains(&format!("held: {words}")), "{run}");
    assert!(summary.contains(&format!("By held {words}.")), "{summary}");
    for claim in ["analytic limit", "limit of Eq. 74", "can sustain itself"] {
        assert!(!summary.contains(claim), "{summary}");
    }
}

#[test]
fn smooth_rotation_below_eq_74_is_counted_too() {
    let place = Workplace::new();
    place.write("sweep.toml", JOINTED);
    let (run, summary, counts) = counted(&place, "sweep.toml");
    assert_eq!(counts, [0, 0, 3, 2]);
    let words = "2 of 3 cases that turn smoothly are below the one-slip estimate (Eq. 74)";
    assert!(run.contains(words), "{run}");
    assert!(summary.contains(words), "{summary}");
    assert!(
        summary.contains("Smooth rotation is found from 0.7 times that estimate on."),
        "{summary}"
    );
}

#[test]
fn shards_that_are_merged_count_as_one_run() {
    let place = Workplace::with_small(SMALL);
    let done = |arguments: &[&str]| {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 0, "{}", answer.errors);
    };
    done(&["run", "small.toml", "--quiet", "--out", "whole"]);
    done(&[
        "run",
        "small.toml",
        "--quiet",
        "--shard",
        "0/2",
        "--out",
        "a",
    ]);
    done(&[
        "run",
        "small.toml",
        "--quiet",
        "--shard",
        "1/2",
        "--out",
        "b",
    ]);
    done(&["merge", "a", "b", "--out", "merged"]);
    let [whole, merged] = ["whole", "merged"].map(|folder| {
        let text = std::fs::read_to_string(place.path(folder).join("manifest.json")).unwrap();
        let manifest: Value = serde_json::from_str(&text).unwrap();
        manifest["one_slip_estimate"].clone()
    });
    assert_eq!(merged, whole);
    let count = |what: &str| whole["quadrature"][what].as_u64().unwrap();
    assert_eq!(count("stick_slip") + count("smooth"), 6);
}
