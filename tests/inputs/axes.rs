//! Axes over quantities of bit, rock, drive, mud, masses and walls: a value along an axis is what the same
//! number in the file is.

use crate::support::{Workplace, with};

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

/// A string with two sites, each driven against its wall by an impulse in multiples of its I₀.
const TOUCHING: &str = r#"
surface_speed_rpm = 90
time_s = 3
sampling_frequency_hz = 200
methods = ["quadrature", "held"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 1000 }
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
[wall]
clearance_mm = 20
stiffness_gn_m15 = 1
friction = 0.4
friction_dynamic_ratio = 0.6
friction_stribeck_m_s = 0.5
[[sites]]
distance_from_bit_m = 30
[[sites]]
distance_from_bit_m = 0
[[impulses]]
distance_from_bit_m = 30
ratio = 3
start_s = 0.1
duration_s = 0.04
[[impulses]]
distance_from_bit_m = 0
ratio = 4
start_s = 0.5
duration_s = 0.02
direction_deg = 90
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

/// The quantities of the wall, each with the number of the file and another.
const OF_WALL: [(&str, [f64; 2]); 5] = [
    ("clearance_mm", [20.0, 13.7]),
    ("stiffness_gn_m15", [1.0, 0.037]),
    ("friction", [0.4, 0.93]),
    ("friction_dynamic_ratio", [0.6, 0.31]),
    ("friction_stribeck_m_s", [0.5, 0.083]),
];

fn two_values(axis: &str, [one, other]: [f64; 2]) -> String {
    format!("{axis} = {{ values = [{one}, {other}] }}\n")
}

fn grid(axes: &str) -> String {
    format!("[design]\nkind = \"grid\"\n[design.axes]\n{axes}")
}

/// What a file without a design has, once for each method.
fn of_file(text: &str) -> Vec<String> {
    let rows = measures(text);
    assert_eq!(rows.len(), 2);
    rows
}

/// Of both sites, wherever the number is given in the file; I₀ follows the clearance.
#[test]
fn a_value_along_an_axis_of_the_wall_is_that_value_in_the_file() {
    for (key, [file, other]) in OF_WALL {
        let from = format!("\n{key} = {file}\n");
        let changed = with(TOUCHING, &from, &format!("\n{key} = {other}\n"));
        let by_file = [of_file(TOUCHING), of_file(&changed)].concat();
        assert_ne!(by_file[..2], by_file[2..], "{key} does not matter");
        let design = grid(&two_values(key, [file, other]));
        let own = with(
            TOUCHING,
            "distance_from_bit_m = 0\n[[imp",
            &format!("distance_from_bit_m = 0\n{key} = {}\n[[imp", 0.5 * file),
        );
        for text in [TOUCHING, &own] {
            assert_eq!(measures(&format!("{text}{design}")), by_file, "{key}");
        }
    }
    // A rigid wall gets a stiffness.
    let rigid = with(TOUCHING, "stiffness_gn_m15 = 1\n", "");
    let design = grid("stiffness_gn_m15 = { values = [1] }\n");
    let by_axis = measures(&format!("{rigid}{design}"));
    assert_eq!(by_axis, of_file(TOUCHING));
    assert_ne!(by_axis, of_file(&rigid));
}

/// Of one site, before what is said of every site.
#[test]
fn a_value_along_an_axis_of_one_site_is_its_own_in_the_file() {
    // The first site of the file is not the first from the surface.
    let text = with(
        TOUCHING,
        "distance_from_bit_m = 30\n[[sites]]",
        "distance_from_bit_m = 0\n[[sites]]",
    );
    let text = with(
        &text,
        "distance_from_bit_m = 0\n[[imp",
        "distance_from_bit_m = 30\n[[imp",
    );
    for (site, place) in [(0, "= 0\n[[sites]]"), (1, "= 30\n[[imp")] {
        for (key, [all, own]) in OF_WALL {
            let (head, tail) = place.split_once('\n').unwrap();
            let in_file =
                |value: f64| with(&text, place, &format!("{head}\n{key} = {value}\n{tail}"));
            let by_file = [of_file(&in_file(all)), of_file(&in_file(own))].concat();
            let axis = format!("site_{site}_{key}");
            assert_ne!(by_file[..2], by_file[2..], "{axis} does not matter");
            let axes = two_values(&axis, [all, own]);
            assert_eq!(
                measures(&format!("{text}{}", grid(&axes))),
                by_file,
                "{axis}"
            );
            let third = in_file(0.7 * all);
            assert_eq!(
                measures(&format!("{third}{}", grid(&axes))),
                by_file,
                "{axis}"
            );
            // The other site has what the axis of all says.
            let both = format!("{axes}{key} = {{ values = [{all}] }}\n");
            let without = text.replacen(
                &format!("\n{key} = {all}\n"),
                &format!("\n{key} = {}\n", 0.8 * all),
                1,
            );
            assert_eq!(
                measures(&format!("{without}{}", grid(&both))),
                by_file,
                "{axis}"
            );
        }
    }
}

/// Friction may be given by axes alone, of each site.
#[test]
fn friction_of_every_site_by_axes_needs_none_in_the_file() {
    let text = with(TOUCHING, "friction = 0.4\n", "");
    let axes = "site_0_friction = { values = [0.4] }\nsite_1_friction = { values = [0.4] }\n";
    assert_eq!(
        measures(&format!("{text}{}", grid(axes))),
        of_file(TOUCHING)
    );
    let place = Workplace::with_small(&format!(
        "{text}{}",
        grid("site_0_friction = { values = [0.4] }\n")
    ));
    let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
    assert!(
        answer.errors.contains("`wall.friction`"),
        "{}",
        answer.errors
    );
}

/// A limit of whirl holds for one clearance and one stiffness of each wall and for one friction of
/// all; how friction falls does not change it.
#[test]
fn over_walls_there_is_no_one_limit_of_whirl() {
    let points = |more: &str| {
        let axes = format!("friction = {{ values = [0.5, 1] }}\n{more}");
        let place = Workplace::with_small(&format!("{TOUCHING}{}", grid(&axes)));
        let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
        assert_eq!(answer.code, 0, "{}", answer.errors);
        let boundary = std::fs::read_to_string(place.path("out/boundary.csv"));
        let lines = boundary.unwrap_or_default();
        lines.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    };
    let limit = points("");
    assert!(!limit.is_empty());
    for (key, values) in OF_WALL {
        let falls = key.starts_with("friction_");
        for axis in [key.to_owned(), format!("site_1_{key}")] {
            if axis == "friction" {
                continue;
            }
            let expected = if falls { &limit[..] } else { &[] };
            assert_eq!(points(&two_values(&axis, values)), expected, "{axis}");
        }
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
        (bare, "rock_friction", "needs a rock with `law`"),
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
        (bare, "clearance_mm", "needs a table [wall]"),
        (bare, "friction_stribeck_m_s", "needs a table [wall]"),
        (bare, "site_0_friction", "needs a table [wall]"),
        (
            TOUCHING,
            "site_2_clearance_mm",
            "the file has 2 [[sites]], from 0",
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

/// A number that no wall has is refused with file, line and key, of one site and of all.
#[test]
fn an_invalid_wall_is_refused() {
    for (axis, value) in [
        ("clearance_mm", 0.0),
        ("site_1_clearance_mm", 2000.0),
        ("stiffness_gn_m15", 0.0),
        ("site_0_stiffness_gn_m15", 1e7),
        ("site_0_friction", -0.1),
        ("friction_dynamic_ratio", 1.5),
        ("friction_stribeck_m_s", -1.0),
    ] {
        let text = format!(
            "{TOUCHING}{}",
            grid(&format!("{axis} = {{ values = [{value}] }}\n"))
        );
        let line = text.lines().count();
        let place = Workplace::with_small(&text);
        let answer = place.sweep(&["run", "small.toml", "--out", "out", "--quiet"]);
        assert_ne!(answer.code, 0, "{axis}");
        let place = format!("small.toml:{line}: `design.axes.{axis}");
        let said = &answer.errors;
        assert!(
            said.contains(&place) && said.contains("is not between"),
            "{said}"
        );
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}

/// The last value of an axis is where it ends, also in other units and where limits are traced.
#[test]
fn a_rock_table_may_end_where_the_weights_end() {
    for to in [30, 40, 47, 61] {
        let text = format!(
            "methods = [\"quadrature\"]\n[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 5\n[[string.sections]]\nrepeat = 1\nparts = [{{ length_m = 1000, \
             inner_radius_m = 0.05, outer_radius_m = 0.0635 }}]\n[bit]\nrock = \"table\"\n\
             table_klbf_lbf_ft = [[0, 0], [{to}, 5000]]\n[design]\nkind = \"grid\"\n[design.axes]\n\
             surface_speed_rpm = {{ values = [100] }}\nweight_on_bit_klbf = {{ from = 2, to = {to}, count = 4 }}\n"
        );
        let place = Workplace::with_small(&text);
        let answer = place.sweep(&["run", "small.toml", "--quiet"]);
        assert_eq!(answer.code, 0, "{to}: {}", answer.errors);
    }
}

/// A case whose time is by rule lasts as long as what it is compared with.
#[test]
fn what_is_compared_is_simulated() {
    let rows = (0..=80).map(|second| format!("{second},{}\n", 20 + second % 3));
    let place = Workplace::new();
    place.write(
        "recorded.csv",
        format!("time_s,bit_rpm\n{}", rows.collect::<String>()),
    );
    let compared = "[[compare]]\ntrace = \"bit_speed_rpm\"\nfile = \"recorded.csv\"\ncolumn = \"bit_rpm\"\n\
                    from_s = 0\nto_s = 80\n";
    let text = DRILLING.replace("time_s = 30\n", "") + compared;
    place.write("small.toml", text);
    let answer = place.answer(&["run", "small.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let rows: Vec<Vec<&str>> = labels
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    let misfit = rows[0]
        .iter()
        .position(|it| *it == "misfit_bit_speed_rpm")
        .unwrap();
    assert!(rows[1][misfit].parse::<f64>().unwrap() > 0.0, "{labels}");
}
