//! The hole decides the clearance, and candidates are sites: the same labels as of a file in which
//! both are written by hand, and what `inspect` tells.

use crate::support::{Workplace, with};

/// Pipe with joints above collars, with a stabiliser near the bit, after an impulse.
const IN_HOLE: &str = r#"
time_s = 4
sampling_frequency_hz = 200
methods = ["quadrature", "finite-element"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 500 }
[[string.sections]]
repeat = 3
parts = [
    { length_m = 9.5, inner_diameter_in = 4.276, outer_diameter_in = 5 },
    { length_m = 0.45, inner_diameter_in = 3.25, outer_diameter_in = 6.625 },
]
[[string.sections]]
repeat = 2
parts = [{ length_m = 9.3, inner_diameter_in = 2.8125, outer_diameter_in = 8 }]
[[string.sections]]
repeat = 1
parts = [{ length_m = 1.7, inner_diameter_in = 2.8125, outer_diameter_in = 8, contact_diameter_in = 12.125 }]
[[string.sections]]
repeat = 1
parts = [{ length_m = 2.1, inner_diameter_in = 2.8125, outer_diameter_in = 8 }]
[well]
holes = [
    { from_m = 0, to_m = 30, hole_diameter_in = 12.415 },
    { from_m = 30, to_m = 60, hole_diameter_in = 12.25 },
]
[wall]
clearance = "hole"
stiffness_gn_m15 = 1
friction = 0.6
sites = "all"
[[impulses]]
distance_from_bit_m = 17.75
[design]
kind = "grid"
[design.axes]
surface_speed_rpm = { values = [40, 90] }
impulse_ratio = { values = [2, 5] }
"#;

/// The same by hand: sites in no order, clearances by subtraction.
const BY_HAND: &str = "clearance_mm = 1.5875 # of the blades
stiffness_gn_m15 = 1
friction = 0.6
[[sites]]
distance_from_bit_m = 17.75
clearance_mm = 53.975
[[sites]]
distance_from_bit_m = 42.525
clearance_mm = 73.533
[[sites]]
distance_from_bit_m = 2.95
[[sites]]
distance_from_bit_m = 22.625
clearance_mm = 73.533
[[sites]]
distance_from_bit_m = 32.575
clearance_mm = 73.533
";

fn labels(place: &Workplace, text: &str) -> String {
    place.write("in_hole.toml", text);
    let answer = place.sweep(&["run", "in_hole.toml", "--out", "out", "--fresh"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    std::fs::read_to_string(place.path("out/labels.csv")).unwrap()
}

/// The file with sites and clearances by hand.
fn by_hand() -> String {
    let well = &IN_HOLE[IN_HOLE.find("[well]").unwrap()..IN_HOLE.find("[wall]").unwrap()];
    let wall =
        &IN_HOLE[IN_HOLE.find("clearance =").unwrap()..IN_HOLE.find("[[impulses]]").unwrap()];
    with(&with(IN_HOLE, well, ""), wall, BY_HAND)
}

#[test]
fn val_labels_are_those_of_sites_and_clearances_by_hand() {
    let place = Workplace::new();
    let found = labels(&place, IN_HOLE);
    assert_eq!(found.lines().count(), 1 + 8);
    assert!(found.contains("whirl"), "{found}");
    assert_eq!(found, labels(&place, &by_hand()));
    // They are not those of another clearance.
    let wider = with(
        IN_HOLE,
        "hole_diameter_in = 12.25 }",
        "hole_diameter_in = 12.5 }",
    );
    assert_ne!(found, labels(&place, &wider));
}

/// What is written of a sweep is read again as the same.
#[test]
fn a_run_continues_from_what_is_written_of_it() {
    let place = Workplace::new();
    let found = labels(&place, IN_HOLE);
    let manifest = std::fs::read_to_string(place.path("out/manifest.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    assert_eq!(manifest["sweep"]["sites"], serde_json::json!([]));
    assert_eq!(manifest["sweep"]["wall"]["sites"], "all");
    let answer = place.sweep(&["run", "in_hole.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let again = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    assert_eq!(found, again);
}

#[test]
fn clearances_are_listed_by_site_and_of_many_sites_the_ends() {
    let place = Workplace::new();
    let inspect = |text: &str| {
        place.write("in_hole.toml", text);
        let answer = place.sweep(&["inspect", "in_hole.toml", "--out", "out"]);
        assert_eq!(answer.code, 0, "{answer:?}");
        let words: Vec<&str> = answer.output.split_whitespace().collect();
        words.join(" ")
    };
    let few = inspect(IN_HOLE);
    for reported in [
        "clearance that the hole leaves",
        "2.950 311.1 12.250 308.0 12.125 1.59 0.0625 17.750",
        "42.525 315.3 12.415 168.3 6.625 73.53 2.8950 least 1.59 mm (0.0625 in), 2.950 m from",
        "greatest 73.53 mm (2.8950 in), 42.525 m from the bit",
    ] {
        assert!(few.contains(reported), "{reported}\n{few}");
    }
    assert!(!inspect(&by_hand()).contains("clearance that"));
    let many = with(
        IN_HOLE,
        "sites = \"all\"",
        "sites = \"all\"\nsites_every_m = 1",
    );
    let many = inspect(&with(
        &many,
        "distance_from_bit_m = 17.75",
        "distance_from_bit_m = 17",
    ));
    // The bit, and every metre of 52.25.
    assert!(many.contains("and 33 more sites above least"), "{many}");
}

/// A sheet that says the blades is the string by hand.
#[test]
fn val_blades_of_a_sheet_touch() {
    let place = Workplace::new();
    let sections =
        &IN_HOLE[IN_HOLE.find("[[string.sections]]").unwrap()..IN_HOLE.find("[well]").unwrap()];
    let sheet = "element,joints,od_in,id_in,blade_od_in,length_m,tool_joint_od_in,tool_joint_id_in,\
                 tool_joint_length_m\n\
                 Drillpipe,3,5,4.276,,29.85,6.625,3.25,0.45\nCollar,2,8,2.8125,,18.6,,,\n\
                 Stabiliser,1,8,2.8125,12.125,1.7,,,\nBit,1,8,2.8125,,2.1,,,\n";
    place.write("bha.csv", sheet);
    let found = labels(&place, &with(IN_HOLE, sections, "file = \"bha.csv\"\n"));
    let by_hand = labels(&place, IN_HOLE);
    // Lengths of joints are divided, and so off by a rounding.
    let places = |labels: &str| {
        let rows = labels.lines().map(|row| row.split(',').collect::<Vec<_>>());
        rows.map(|row| (row[5].to_owned(), row[14].to_owned()))
            .collect::<Vec<_>>()
    };
    assert_eq!(places(&found), places(&by_hand));
}
