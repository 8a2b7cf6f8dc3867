//! Axes over quantities of bit, rock, drive, mud and masses: a value along an axis is what the same
//! number in the file is.

#[allow(dead_code, reason = "it has more than is needed here")]
mod support;

use support::{Workplace, with};

/// A bit with a law of its own rock below a drive.
const DRILLING: &str = r#"
surface_speed_rpm = 20
time_s = 30
sampling_frequency_hz = 100
methods = ["quadrature"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 5
[[string.sections]]
repeat = 30
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.07 }]
[top_drive]
controller = "gains"
inertia_kg_m2 = 2000
proportional_gain_knms_rad = 2
integral_gain_knm_rad = 1.5
[bit]
rock = "law"
weight_on_bit_kn = 90
torque_static_ratio = 1.5
torque_decay_rpm = 3
[bit.law]
bit_radius_m = 0.15
specific_energy_mpa = 60
cutting_ratio = 0.6
friction = 0.5
contact_strength_mpa = 60
contact_growth = 5
wear_flat_mm = 5
poor_cleaning_from_kn = 80
poor_cleaning_nm_per_kn = 100
"#;

/// A bit that whirls, driven by a mass, in mud.
const WHIRLING: &str = r#"
surface_speed_rpm = 90
time_s = 4
sampling_frequency_hz = 200
methods = ["quadrature"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
[well]
hole_radius_m = 0.12
[mud]
density_kg_m3 = 1200
[wall]
clearance_mm = 20
friction = 0.4
[[sites]]
distance_from_bit_m = 0
[[eccentric_masses]]
distance_from_bit_m = 0
mass_kg = 30
offset_m = 0.05
"#;

/// Rows of a run from the column `torsion` on, so that the axis is not among them.
fn measures(text: &str) -> Vec<String> {
    let place = Workplace::with_small(text);
    let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
    assert_eq!(answer.code, 0, "{}\n{text}", answer.errors);
    let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let mut lines = table.lines();
    let first = lines
        .next()
        .unwrap()
        .split(',')
        .position(|name| name == "torsion")
        .unwrap();
    lines
        .map(|line| line.split(',').skip(first).collect::<Vec<_>>().join(","))
        .collect()
}

/// An axis with two values gives what two files with the key at these values do, and the values
/// matter; the key itself may say a third.
fn holds(text: &str, axis: &str, key: &str, [file, other]: [f64; 2]) {
    let design = format!(
        "[design]\nkind = \"grid\"\n[design.axes]\n{axis} = {{ values = [{file}, {other}] }}\n"
    );
    let by_axis = measures(&format!("{text}{design}"));
    let from = format!("{key} = {file}");
    let by_file = [file, other]
        .map(|value| measures(&with(text, &from, &format!("{key} = {value}"))).remove(0));
    assert_eq!(by_axis, by_file, "{axis}");
    assert_ne!(by_file[0], by_file[1], "{axis} does not matter");
    let third = with(text, &from, &format!("{key} = {}", 0.5 * (file + other)));
    assert_eq!(measures(&format!("{third}{design}")), by_axis, "{axis}");
}

#[test]
fn a_value_along_an_axis_is_that_value_in_the_file() {
    for (axis, key, values) in [
        ("torque_static_ratio", "torque_static_ratio", [1.5, 2.0]),
        ("torque_decay_rpm", "torque_decay_rpm", [3.0, 40.0]),
        ("rock_bit_radius_m", "bit_radius_m", [0.15, 0.2]),
        ("rock_cutting_ratio", "cutting_ratio", [0.6, 0.8]),
        (
            "rock_contact_strength_mpa",
            "contact_strength_mpa",
            [60.0, 50.0],
        ),
        ("rock_wear_flat_mm", "wear_flat_mm", [5.0, 4.0]),
        (
            "rock_poor_cleaning_from_kn",
            "poor_cleaning_from_kn",
            [80.0, 70.0],
        ),
        (
            "rock_poor_cleaning_nm_per_kn",
            "poor_cleaning_nm_per_kn",
            [100.0, 60.0],
        ),
        ("rock_friction", "friction", [0.5, 0.7]),
        ("top_drive_inertia_kg_m2", "inertia_kg_m2", [2000.0, 900.0]),
        (
            "proportional_gain_knms_rad",
            "proportional_gain_knms_rad",
            [2.0, 0.7],
        ),
        ("integral_gain_knm_rad", "integral_gain_knm_rad", [1.5, 4.0]),
    ] {
        holds(DRILLING, axis, key, values);
    }
    // Where the wear flats are not yet in full contact.
    let light = with(DRILLING, "weight_on_bit_kn = 90", "weight_on_bit_kn = 10");
    for (axis, key, values) in [
        (
            "rock_specific_energy_mpa",
            "specific_energy_mpa",
            [60.0, 80.0],
        ),
        ("rock_contact_growth", "contact_growth", [5.0, 4.0]),
    ] {
        holds(&light, axis, key, values);
    }
    for (axis, key, values) in [
        (
            "mud_density_kg_m3",
            "[mud]\ndensity_kg_m3",
            [1200.0, 1800.0],
        ),
        ("eccentric_mass_0_mass_kg", "mass_kg", [30.0, 50.0]),
        ("eccentric_mass_0_offset_m", "offset_m", [0.05, 0.1]),
    ] {
        holds(WHIRLING, axis, key, values);
    }
}

/// A limit of stick-slip holds for one law of the bit: over several there is none.
#[test]
fn over_laws_of_the_bit_there_is_no_one_limit() {
    let axes = |more: &str| {
        format!(
            "{DRILLING}[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = \
             {{ values = [40, 60] }}\n{more}"
        )
    };
    let points = |text: &str| {
        let place = Workplace::with_small(text);
        let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
        assert_eq!(answer.code, 0, "{}", answer.errors);
        let boundary = std::fs::read_to_string(place.path("out/boundary.csv"));
        boundary.map_or(0, |table| table.lines().count() - 1)
    };
    let text = axes("").replace("weight_on_bit_kn = 90\n", "");
    assert!(points(&text) > 10);
    let of_ratio = "torque_static_ratio = { values = [1.2, 1.5] }\n";
    let text = axes(of_ratio).replace("weight_on_bit_kn = 90\n", "");
    assert_eq!(points(&text), 0);
}

/// An axis of what is not there is refused by its key.
#[test]
fn an_axis_of_what_is_not_there_is_refused() {
    let bare = DRILLING.split("[top_drive]").next().unwrap();
    let without_cleaning = (DRILLING.lines())
        .filter(|line| !line.starts_with("poor_cleaning"))
        .map(|line| format!("{line}\n"))
        .collect::<String>();
    let stiff = (DRILLING.lines())
        .filter(|line| !line.contains("_gain_"))
        .map(|line| format!("{}\n", line.replace("\"gains\"", "\"stiff\"")))
        .collect::<String>();
    for (text, axis, meant) in [
        (bare, "torque_static_ratio", "needs a table [bit]"),
        (bare, "rock_friction", "needs a rock with a law of its own"),
        (
            &without_cleaning,
            "rock_poor_cleaning_from_kn",
            "needs poor cleaning",
        ),
        (bare, "top_drive_inertia_kg_m2", "needs a table [top_drive]"),
        (
            &stiff,
            "proportional_gain_knms_rad",
            "needs `controller = \"gains\"`",
        ),
        (bare, "mud_density_kg_m3", "needs a table [mud]"),
        (
            bare,
            "eccentric_mass_0_mass_kg",
            "the file has 0 [[eccentric_masses]]",
        ),
    ] {
        let design =
            format!("[design]\nkind = \"grid\"\n[design.axes]\n{axis} = {{ values = [1] }}\n");
        let place = Workplace::with_small(&format!("{text}{design}"));
        let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
        assert_ne!(answer.code, 0, "{axis}");
        let key = format!("`design.axes.{axis}`");
        assert!(
            answer.errors.contains(&key) && answer.errors.contains(meant),
            "{}",
            answer.errors
        );
        assert_eq!(answer.errors.lines().count(), 1, "{}", answer.errors);
    }
}
