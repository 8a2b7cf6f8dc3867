//! The axial force and the hole as a user meets them: a grid over the weight on bit, strings that
//! buckle, a hole in sections, and files that are wrong.

use crate::support::Workplace;

/// Collars below pipe, with a wall near the bit.
const HANGING: &str = r#"
time_s = 4
sampling_frequency_hz = 200
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 200, surface = "pinned" }
[[string.sections]]
repeat = 30
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.065 }]
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.04, outer_radius_m = 0.1 }]
[axial_force]
[bit]
rock = "table"
table_kn_nm = [[0, 0], [100, 2000], [300, 6000]]
[wall]
clearance_mm = 30
friction = 0.3
[[sites]]
distance_from_bit_m = 20
[[sites]]
distance_from_bit_m = 0
[[impulses]]
distance_from_bit_m = 20
amount_ns = 300
start_s = 1
[design]
kind = "grid"
[design.axes]
surface_speed_rpm = { values = [60, 90] }
weight_on_bit_kn = { values = [0, 10, 20, 200] }
"#;

fn written(place: &Workplace, text: &str) {
    std::fs::write(place.path("hanging.toml"), text).unwrap();
}

#[test]
fn val_every_weight_has_its_own_string_and_one_that_buckles_is_reported() {
    let place = Workplace::new();
    written(&place, HANGING);
    let output = place.sweep(&["run", "hanging.toml", "--out", "out"]);
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let header = labels.lines().next().unwrap();
    assert!(
        header.starts_with("case,method,weight_on_bit_kn,surface_speed_rpm"),
        "{header}"
    );
    assert_eq!(labels.lines().count(), 1 + 8, "{}", output.errors);
    let failures = std::fs::read_to_string(place.path("out/failures.csv")).unwrap();
    assert_eq!(failures.lines().count(), 1 + 2, "{failures}");
    assert!(
        failures.contains("buckles under 200 kN on the bit"),
        "{failures}"
    );
    // By shares of it as in one run, and one case as among the others.
    for share in ["0/2", "1/2"] {
        let out = format!("share-{}", &share[..1]);
        place.sweep(&["run", "hanging.toml", "--shard", share, "--out", &out]);
    }
    place.sweep(&["merge", "share-0", "share-1", "--out", "merged"]);
    let merged = std::fs::read_to_string(place.path("merged/labels.csv")).unwrap();
    assert_eq!(merged, labels);
    let output = place.sweep(&["simulate", "hanging.toml", "--case", "3", "--out", "case"]);
    assert_eq!(output.code, 0, "{}", output.errors);
    let case = std::fs::read_to_string(place.path("case/case.csv")).unwrap();
    assert_eq!(
        case.lines().nth(1),
        labels.lines().find(|line| line.starts_with("3,"))
    );
    // No weight is another string than some.
    let measures = |case: &str| {
        let row = labels.lines().find(|line| line.starts_with(case)).unwrap();
        row.rsplit(',')
            .take(11)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_ne!(measures("0,"), measures("2,"));
}

#[test]
fn inspect_says_what_pulls_and_when_it_buckles() {
    let place = Workplace::new();
    let file = HANGING.replace("rock =", "weight_on_bit_kn = 15\nrock =");
    written(
        &place,
        &file
            .split("[design]")
            .next()
            .unwrap()
            .replace("time_s", "surface_speed_rpm = 60\ntime_s"),
    );
    let output = place.sweep(&["inspect", "hanging.toml", "--out", "out"]);
    assert_eq!(output.code, 0, "{}", output.errors);
    for words in [
        "axial force",
        "kN, of which 15.0 kN on the bit",
        "m above the bit",
        "kN on the bit on",
    ] {
        assert!(output.output.contains(words), "{words}: {}", output.output);
    }
}

#[test]
fn what_is_wrong_is_reported_by_its_key() {
    let place = Workplace::new();
    let without_wall = &HANGING[..HANGING.find("[wall]").unwrap()];
    let design = &HANGING[HANGING.find("[design]").unwrap()..];
    for (text, key, words) in [
        (
            format!("{without_wall}{design}"),
            "axial_force",
            "needs a [wall]",
        ),
        (
            HANGING.replace("[axial_force]", "[axial_force]\ntolerance = 0.5"),
            "axial_force.tolerance",
            "0.1",
        ),
        (
            HANGING.replace("[axial_force]", "[axial_force]\ntolerence = 0.01"),
            "axial_force",
            "tolerance",
        ),
        (
            HANGING
                .replace(
                    "rock = \"table\"\ntable_kn_nm = [[0, 0], [100, 2000], [300, 6000]]",
                    "torque_dynamic_nm = 500",
                )
                .replace("weight_on_bit_kn = { values = [0, 10, 20, 200] }", ""),
            "axial_force",
            "the weight on bit is not known",
        ),
        (
            HANGING.replace(
                "weight_on_bit_kn = { values",
                "torque_dynamic_nm = { values",
            ),
            "axial_force",
            "the weight on bit is not known",
        ),
        (
            HANGING.replace("values = [0, 10, 20, 200]", "values = [-1, 10]"),
            "weight_on_bit_kn",
            "-1",
        ),
        (
            HANGING
                .replace("weight_on_bit_kn = { values = [0, 10, 20, 200] }", "")
                .replace("rock =", "weight_on_bit_kn = 150\nrock ="),
            "axial_force",
            "buckles under 150 kN on the bit",
        ),
    ] {
        written(&place, &text);
        let output = place.sweep(&["run", "hanging.toml", "--out", "out"]);
        assert_eq!(output.code, 2, "{key}: {}", output.errors);
        for part in ["hanging.toml:", key, words] {
            assert!(output.errors.contains(part), "{part}: {}", output.errors);
        }
    }
}

/// The same string in mud, in a hole of these sections.
fn in_holes(sections: &str) -> String {
    let mud = format!("[mud]\ndensity_kg_m3 = 1500\n[well]\nholes = [{sections}]\n[wall]");
    HANGING
        .replace("[axial_force]\n", "")
        .replace("[wall]", &mud)
}

#[test]
fn val_sections_of_hole_are_those_that_the_string_is_in() {
    let place = Workplace::new();
    let labels = |text: &str| {
        written(&place, text);
        let output = place.sweep(&["simulate", "hanging.toml", "--case", "2", "--out", "out"]);
        assert_eq!(output.code, 0, "{}", output.errors);
        std::fs::read_to_string(place.path("out/case.csv")).unwrap()
    };
    let whole = labels(&in_holes(
        "{ from_m = 0, to_m = 400, hole_radius_m = 0.127 }",
    ));
    let more = "{ from_m = 0, to_ft = 2000, hole_diameter_in = 10 }";
    assert_eq!(labels(&in_holes(more)), whole);
    let washed_out = "{ from_m = 0, to_m = 350, hole_radius_m = 0.127 }, \
                      { from_m = 350, to_m = 400, hole_radius_m = 0.2 }";
    assert_ne!(labels(&in_holes(washed_out)), whole);
}

#[test]
fn an_invalid_hole_is_reported_by_its_key() {
    let place = Workplace::new();
    let upper = "{ from_m = 0, to_m = 200, hole_radius_m = 0.2 }";
    for (sections, key, words) in [
        (
            format!("{upper}, {{ from_m = 190, to_m = 400, hole_radius_m = 0.15 }}"),
            "well.holes[1].from_m",
            "overlaps the section above, which ends at 200 m",
        ),
        (
            format!("{upper}, {{ from_m = 210, to_m = 400, hole_radius_m = 0.15 }}"),
            "well.holes[1].from_m",
            "no hole from 200 m to 210 m",
        ),
        (
            "{ from_m = 0, to_m = 400, hole_radius_m = 0.2 }]\nhole_radius_m = 0.2 #".to_owned(),
            "hole_radius_m",
            "conflicts with `holes`: give only one",
        ),
        (
            upper.to_owned(),
            "well.holes",
            "ends at 200 m, and the string at 400 m",
        ),
        (
            format!("{upper}, {{ from_m = 200, to_m = 400, hole_radius_m = 0.09 }}"),
            "string.sections[1].parts[0].outer_radius_m",
            "0.09",
        ),
    ] {
        written(&place, &in_holes(&sections));
        let output = place.sweep(&["run", "hanging.toml", "--out", "out"]);
        assert_eq!(output.code, 2, "{key}: {}", output.errors);
        for part in ["hanging.toml:", key, words] {
            assert!(output.errors.contains(part), "{part}: {}", output.errors);
        }
    }
}
