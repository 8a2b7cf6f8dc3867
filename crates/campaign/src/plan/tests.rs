//! Sweep files that once went wrong, read from memory.

use std::path::Path;
use std::time::{Duration, Instant};

use super::wall::WallSettings;
use super::{Setting, Sweep};
use crate::quantities::Axis;
use crate::sweep_file::SweepFileError;

/// Reads a file on top of the paper's drillstring.
fn read(text: &str) -> Result<Sweep, SweepFileError> {
    let text = format!("base = \"academic.toml\"\n{text}");
    Sweep::read_from(Path::new("sweep.toml"), &[], &|path, _| {
        Ok(match path.to_str() {
            Some("sweep.toml") => text.clone(),
            _ => include_str!("../../../../sweeps/academic.toml").to_owned(),
        })
    })
}

#[track_caller]
fn message(text: &str) -> String {
    read(text).unwrap_err().to_string()
}

/// Four times 2¹⁶ cases multiply to none in 64 bits.
#[test]
fn a_grid_of_more_cases_than_can_be_counted_is_refused() {
    let axes = [
        "surface_speed_rpm",
        "weight_on_bit_kn",
        "impulse_ratio",
        "friction",
    ];
    let axes = axes.map(|axis| format!("{axis} = {{ from = 1, to = 2, count = 65536 }}\n"));
    let text = format!(
        "[design]\nkind = \"grid\"\n[design.axes]\n{}",
        axes.concat()
    );
    let message = message(&text);
    assert!(message.starts_with("sweep.toml:2: `design`: "), "{message}");
    assert!(
        message.contains("cases are more than 10000000"),
        "{message}"
    );
}

/// A hundred axes of a million values took most of a gigabyte before they were
/// multiplied.
#[test]
fn a_grid_that_is_too_large_is_not_filled() {
    let start = Instant::now();
    let axes: String = (0..100)
        .map(|site| {
            let name = format!("site_{site}_distance_from_bit_m");
            format!("{name} = {{ from = 1, to = 2, count = 1000000 }}\n")
        })
        .collect();
    let message = message(&format!("[design]\nkind = \"grid\"\n[design.axes]\n{axes}"));
    assert!(message.contains("cases are more than"), "{message}");
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn a_message_is_one_line_for_any_file() {
    for text in [
        "\"a\\nb\\u001b[31m\" = 1",
        "[bit]\nrock = \"a\\r\\nb\"",
        "\u{8}",
    ] {
        let message = message(text);
        assert!(!message.contains(char::is_control), "{message:?}");
    }
}

/// Finding the places of values that are replaced took a minute, though none were.
#[test]
fn a_long_file_is_read_at_once() {
    let start = Instant::now();
    let marks = "{ name = \"x\", friction = 1, impulse_ratio = 2 }, ".repeat(40_000);
    let sweep = read(&format!("map.marks = [{marks}]")).unwrap();
    assert_eq!(sweep.content.map.marks.len(), 40_000);
    let message = message(
        &(0..40_000)
            .map(|key| format!("k{key} = 1\n"))
            .collect::<String>(),
    );
    assert!(message.contains("unknown key"), "{message}");
    assert!(start.elapsed() < Duration::from_secs(10));
}

/// Places that are only observed cost a run nothing.
#[test]
fn labels_need_the_bit_alone_where_there_is_no_wall() {
    let bit = "[bit]\ntorque_dynamic_nm = 2000\n";
    let observed = read(&format!("sites = [{{ distance_from_bit_m = 50 }}]\n{bit}")).unwrap();
    assert_eq!(observed.setting.sites.len(), 2);
    assert_eq!(observed.setting.for_labels().sites.len(), 1);
    let touching = read(
        "sites = [{ distance_from_bit_m = 50 }, { distance_from_bit_m = 0 }]\n\
         [wall]\nclearance_mm = 15\nfriction = 0.5\n",
    );
    let touching = touching.unwrap();
    assert_eq!(touching.setting.for_labels().sites.len(), 2);
}

#[test]
fn a_site_may_have_its_own_friction_that_falls() {
    let sweep = read(
        "sites = [{ distance_from_bit_m = 10, friction_dynamic_ratio = 0.3 }, \
         { distance_from_bit_m = 0, friction_stribeck_m_s = 2 }]\n\
         [wall]\nclearance_mm = 15\nfriction = 0.5\nfriction_dynamic_ratio = 0.8\n\
         friction_stribeck_m_s = 0.1\n",
    )
    .unwrap();
    let walls = sweep.setting.lateral.unwrap().walls;
    let falls = |wall: &WallSettings| (wall.dynamic_ratio, wall.stribeck_speed);
    let falls: Vec<(f64, f64)> = walls.iter().map(falls).collect();
    assert_eq!(falls, [(0.3, 0.1), (0.8, 2.0)]);
}

/// The string carries what is eccentric, all of it at one place, but for masses in the form of the paper; a
/// mass that an axis varies is that of the case.
#[test]
fn a_string_carries_its_eccentric_masses() {
    let with = |masses: &str| {
        read(&format!(
            "sites = [{{ distance_from_bit_m = 0 }}, {{ distance_from_bit_m = 20 }}]\n\
             eccentric_masses = [{masses}]\n[wall]\nclearance_mm = 15\nfriction = 0.5\n\
             [design]\nkind = \"grid\"\n[design.axes]\n\
             eccentric_mass_0_mass_kg = {{ values = [10, 30] }}\n"
        ))
    };
    let mass = |place: f64, kg: f64, form: &str| {
        format!(
            "{{ distance_from_bit_m = {place}, mass_kg = {kg}, offset_m = 1, form = \"{form}\" }}"
        )
    };
    let all = |of: &[(f64, f64, &str)]| {
        let all: Vec<String> = of.iter().map(|it| mass(it.0, it.1, it.2)).collect();
        with(&all.join(", "))
    };
    let sweep = all(&[
        (20.0, 10.0, "carried"),
        (0.0, 5.0, "paper"),
        (20.0, 2.0, "carried"),
    ])
    .unwrap();
    assert_eq!(sweep.setting.sites.masses(), [12.0, 0.0]);
    assert_eq!(
        sweep.setting_at(&[30.0]).unwrap().sites.masses(),
        [32.0, 0.0]
    );
    let sweep = all(&[(20.0, 10.0, "paper")]).unwrap();
    assert!(sweep.setting.sites.masses().is_empty());
    let mixed = all(&[(20.0, 10.0, "paper"), (20.0, 10.0, "carried")])
        .unwrap_err()
        .to_string();
    assert!(
        mixed.contains("`eccentric_masses[1].form`: masses at one place must"),
        "{mixed}"
    );
}

/// Where one site goes, another still stood: what is at either goes with its own.
#[test]
fn sites_move_at_once_each_with_what_is_there() {
    let sweep = read(
        "sites = [{ distance_from_bit_m = 10 }, { distance_from_bit_m = 20 }]\n\
         impulses = [{ distance_from_bit_m = 10, ratio = 3 }]\n\
         eccentric_masses = [{ distance_from_bit_m = 20, mass_kg = 1, offset_m = 1 }]\n\
         [wall]\nclearance_mm = 15\nfriction = 0.5\n\
         [design]\nkind = \"grid\"\n[design.axes]\n\
         site_0_distance_from_bit_m = { values = [10, 20] }\n\
         site_1_distance_from_bit_m = { values = [20, 30] }\n",
    )
    .unwrap();
    let places = |setting: &Setting| {
        let (distances, lateral) = (setting.sites.distances_from_bit(), &setting.lateral);
        let lateral = lateral.as_ref().unwrap();
        [lateral.impulses[0].site, lateral.eccentric_masses[0].site].map(|site| distances[site])
    };
    for values in [[10.0, 20.0], [10.0, 30.0], [20.0, 30.0], [20.0, 10.0]] {
        assert_eq!(places(&sweep.setting_at(&values).unwrap()), values);
    }
    // Of a value given twice, as by `--set`, the last counts.
    let values = [(0, 20.0), (1, 30.0), (0, 40.0)];
    let twice = values.map(|(site, value)| (sweep.design.axes()[site], value));
    let setting = sweep.setting_with(twice.into_iter()).unwrap();
    assert_eq!(places(&setting), [40.0, 30.0]);
}

/// The greatest friction there is, missed by a rounding.
#[test]
fn a_logarithmic_axis_ends_where_it_is_said_to() {
    let sweep = read(
        "sites = [{ distance_from_bit_m = 0 }]\n[wall]\nclearance_mm = 15\n\
         [design]\nkind = \"grid\"\n[design.axes]\n\
         friction = { from = 0.3, to = 50, count = 4, spacing = \"log\" }\n",
    )
    .unwrap();
    let [first, last] = [0, 3].map(|case| sweep.design.values(case));
    assert_eq!([first, last], [[0.3], [50.0]]);
}

const FIELD: &str = "surface_speed_rpm = 60
[[string.sections]]
repeat = 3
parts = [{ length_ft = 30, inner_diameter_in = 4, outer_radius_in = 2.5 }]
[[sites]]
distance_from_bit_ft = 10
[bit]
rock = \"table\"
table_klbf_lbf_ft = [[0, 0], [100, 20000]]
";

#[test]
fn field_units_are_read_as_what_they_are_twins_of() {
    let axes = "[design]\nkind = \"grid\"\n[design.axes]\n\
                weight_on_bit_klbf = { from = 10, to = 20, count = 2 }\n\
                [map]\nx = \"weight_on_bit_klbf\"\n";
    let sweep = read(&format!("{FIELD}{axes}")).unwrap();
    let near = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    };
    let part = &sweep.setting.string.sections()[0].parts[0];
    near(part.length, 9.144);
    near(part.inner_radius, 0.0508);
    near(part.outer_radius, 0.0635);
    near(sweep.setting.sites.distances_from_bit()[0], 3.048);
    near(sweep.design.values(1)[0], 20.0 * 4.4482216152605);
    // 2000 lbf ft at 10 klbf.
    let conditions = (sweep.conditions).with(Axis::WeightOnBitKn, 44.482216152605);
    let torque = sweep.bit.unwrap().torque_dynamic(&conditions);
    near(torque.unwrap().unwrap(), 2000.0 * 1.3558179483314);
}

#[test]
fn a_quantity_given_in_two_units_is_refused() {
    let found = message("[wall]\nclearance_mm = 10\nclearance_in = 0.5\n");
    assert_eq!(
        found,
        "sweep.toml:3: `clearance_mm`: says the same as `clearance_in`; give one of them"
    );
}

#[test]
fn an_error_names_the_key_as_it_was_written() {
    let found = message(&format!("{FIELD}weight_on_bit_klbf = 5000\n"));
    let key = "sweep.toml:11: `bit.weight_on_bit_klbf`: ";
    assert!(found.starts_with(key), "{found}");
    let found = message(&format!("{FIELD}weight_on_bit_klbf = 5\n").replace("= 30", "= -30"));
    let key = "sweep.toml:5: `string.sections[0].parts[0].length_ft`: ";
    assert!(found.starts_with(key), "{found}");
}

/// A file with a top drive of 4000 kg m².
fn driven(keys: &str) -> Result<Sweep, SweepFileError> {
    read(&format!("[top_drive]\ninertia_kg_m2 = 4000\n{keys}"))
}

#[test]
fn controllers_have_the_gains_that_they_should() {
    let drive = |keys: &str| driven(keys).unwrap().setting.string.top_drive().unwrap();
    let stiff = drive("controller = \"stiff\"");
    let matched = drive("controller = \"impedance-matched\"");
    assert!((stiff.proportional_gain / matched.proportional_gain - 100.0).abs() < 1e-9);
    assert_eq!((stiff.inertia, matched.inertia), (4000.0, 0.0));
    // K_p² = 4 K_i J₁: the drive is critically damped by the first mode's inertia.
    let soft = drive("controller = \"soft-torque\"");
    let string = driven("controller = \"soft-torque\"")
        .unwrap()
        .setting
        .string;
    let first = linear::estimates::first_mode(&string);
    let critical = soft.proportional_gain.powi(2) / (4.0 * soft.integral_gain * first.inertia);
    assert!((critical - 1.0).abs() < 1e-9, "{critical}");
    let given = "controller = \"gains\"\nproportional_gain_knms_rad = 38\n\
                 integral_gain_klbf_ft_rad = 10\ninertia_compensation = 0.25";
    let given = drive(given);
    assert_eq!((given.inertia, given.proportional_gain), (3000.0, 38e3));
    assert!((given.integral_gain / 13558.17948 - 1.0).abs() < 1e-8);
    let slow = "controller = \"impedance-matched\"\nintegral_gain_knm_rad = 1";
    assert_eq!(drive(slow).integral_gain, 1e3);
}

#[test]
fn what_no_drive_can_be_is_refused_with_its_key() {
    for (keys, expected) in [
        (
            "controller = \"stiff\"\nproportional_gain_knms_rad = 38",
            "sweep.toml:5: `top_drive.proportional_gain_knms_rad`: this controller has its own",
        ),
        (
            "controller = \"gains\"\nproportional_gain_knms_rad = 38",
            "sweep.toml:4: `top_drive.controller`: the controller \"gains\" needs \
             `integral_gain_knm_rad`",
        ),
        (
            "controller = \"stiff\"\ninertia_compensation = 1.1",
            "sweep.toml:5: `top_drive.inertia_compensation`: 1.1 is not between 0 and 1",
        ),
        (
            "controller = \"soft-torque\"\ninertia_compensation = 0.5",
            "sweep.toml:4: `top_drive.controller`: soft torque needs a drive at least as heavy",
        ),
        (
            "controller = \"gains\"\nproportional_gain_knms_rad = -1\n\
             integral_gain_knm_rad = 1",
            "sweep.toml:5: `top_drive.proportional_gain_knms_rad`: -1 kN m s/rad is not between",
        ),
        ("controller = \"soft\"", "sweep.toml:4: "),
    ] {
        let message = driven(keys).unwrap_err().to_string();
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn labels_are_certified_by_two_methods_that_share_no_equation() {
    let held_to = |methods: &str| message(&format!("methods = {methods}\ncertify = true\n"));
    for (methods, lacks) in [
        ("[\"held\", \"quadrature\"]", "`finite-element`"),
        ("[\"finite-element\", \"quadrature\"]", "`held`"),
    ] {
        let message = held_to(methods);
        assert!(
            message.starts_with("sweep.toml:3: `certify`: "),
            "{message}"
        );
        assert!(
            message.ends_with(&format!("`methods` lacks {lacks}")),
            "{message}"
        );
    }
    let text = "methods = [\"hilbert\", \"finite-element\", \"held\"]\ncertify = true\n";
    let sweep = read(text).unwrap();
    assert_eq!(sweep.certifying, None, "it is not run");
    assert_eq!(sweep.for_run().unwrap().certifying, Some([2, 1]));
    let both = message("accuracy = 0.1\ncertify = true\n");
    assert!(
        both.contains("conflicts with `certify`: give only one"),
        "{both}"
    );
}

#[test]
fn what_does_not_go_with_a_mud_motor_is_refused_by_its_key() {
    const MOTOR: &str =
        "surface_speed_rpm = 120\n[motor]\nspeed_rpm = 100\nstall_torque_kn_m = 12\n";
    const BIT: &str = "[bit]\ntorque_dynamic_nm = 4000\n";
    let after = |more: &str| format!("{MOTOR}{more}\n{BIT}");
    let before = |more: &str| format!("{more}\n{MOTOR}{BIT}");
    for (text, key) in [
        (
            after("speed_at_stall_rpm = 110"),
            "motor.speed_at_stall_rpm",
        ),
        (
            after("rotor_inertia_kg_m2 = 0"),
            "motor.rotor_inertia_kg_m2",
        ),
        (MOTOR.replace("= 100", "= 0") + BIT, "motor.speed_rpm"),
        (
            MOTOR.replace("= 12\n", "= 0\n") + BIT,
            "motor.stall_torque_kn_m",
        ),
        (MOTOR.to_owned(), "motor"),
        (before("start = \"stuck\""), "start"),
        (before("start = \"both\""), "start"),
        (before("accuracy = \"1 %\""), "accuracy"),
        (
            before("methods = [\"held\", \"finite-element\"]\ncertify = true"),
            "certify",
        ),
    ] {
        let found = message(&text);
        assert!(found.contains(&format!("`{key}`: ")), "{key}: {found}");
    }
    let sweep = read(&(MOTOR.to_owned() + BIT)).unwrap();
    let motor = sweep.setting.motor.unwrap();
    assert!((motor.relative_speed(1e3) * 60.0 / std::f64::consts::TAU - 100.0).abs() < 1e-9);
    assert_eq!(motor.rotor_inertia, 3.0);
}

const CUTTING: &str = "methods = [\"held\"]\nsurface_speed_rpm = 120\n[bit]\nrock = \"sandstone\"\nweight_on_bit_kn = 60\n\
                       [bit.cutting]\nblades = 6\n";

const WALLED: &str =
    "[wall]\nclearance_mm = 20\nfriction = 0.3\n[[sites]]\ndistance_from_bit_m = 0\n";

#[test]
fn what_does_not_go_with_a_bit_that_cuts_is_refused_by_its_key() {
    let bit = |more: &str| CUTTING.replace("[bit.cutting]", &format!("{more}\n[bit.cutting]"));
    let after = |more: &str| format!("{CUTTING}{more}");
    let before = |more: &str| format!("{more}\n{CUTTING}");
    for (text, key) in [
        (bit("torque_static_ratio = 1.3"), "bit.torque_static_ratio"),
        (bit("torque_decay_rpm = 5"), "bit.torque_decay_rpm"),
        (before("start = \"stuck\""), "start"),
        (before("start = \"both\""), "start"),
        (
            CUTTING.replace("methods = [\"held\"]", "accuracy = \"5 %\"") + WALLED,
            "accuracy",
        ),
        (
            CUTTING.replace(
                "[\"held\"]",
                "[\"held\", \"finite-element\"]\ncertify = true",
            ),
            "certify",
        ),
        (before("sampling_frequency_hz = 5"), "sampling_frequency_hz"),
        (CUTTING.replace("\"held\"", "\"hilbert\""), "methods"),
        (after("relief_deg = 80"), "bit.cutting.relief_deg"),
        (
            after("blade_angles_deg = [180, 180]"),
            "bit.cutting.blade_angles_deg",
        ),
        (after("kick_kn = 1"), "bit.cutting.kick_kn"),
        (after("[feed]\nfeed_m_h = 20"), "feed.feed_m_h"),
        (
            after("[feed]\nkind = \"speed\"\nfeed_m_h = 20"),
            "bit.weight_on_bit_kn",
        ),
        (
            CUTTING.replace("blades = 6", "blade_angles_deg = [100, 100]"),
            "bit.cutting.blade_angles_deg",
        ),
        (CUTTING.replace("rock = \"sandstone\"", ""), "bit.rock"),
        ("surface_speed_rpm = 120\n[feed]\n".to_owned(), "feed"),
        (
            "surface_speed_rpm = 120\n[string.axial]\ndamping_ns_m2 = 1\n".to_owned(),
            "string.axial",
        ),
    ] {
        let found = message(&text);
        assert!(found.contains(&format!("`{key}`: ")), "{key}: {found}");
    }
}

/// A bit that drills steadily is the rock law that is there, and axial vibration dies away as torsion
/// does unless a file says otherwise.
#[test]
fn a_steady_bit_obeys_the_law_of_its_rock() {
    let sweep = read(CUTTING).unwrap();
    let settings = sweep.setting.cutting.as_ref().unwrap();
    let bit = sweep.bit.as_ref().unwrap();
    let law = bit.cutting_law(&sweep.conditions).unwrap().unwrap();
    let cutting = settings.bit_in(law);
    let feed = settings.feed(&sweep.conditions).unwrap();
    let speed = sweep.conditions.surface_speed().unwrap();
    let steady = settings.steady((&sweep.setting.string, None), &cutting, speed, feed);
    let rock = bit.rock.as_ref().unwrap();
    let torque = rock.torque_dynamic(steady.weight).unwrap();
    assert!(
        (steady.torque / torque - 1.0).abs() < 1e-9,
        "{steady:?} {torque}"
    );
    // Hoist and damping take their part of the weight that is set.
    assert!(steady.weight < 60e3 && steady.weight > 50e3, "{steady:?}");
    let rate = linear::estimates::torsional_decay_rate;
    let rates = [rate(&sweep.setting.string), rate(&settings.rod)];
    assert!((rates[0] / rates[1] - 1.0).abs() < 1e-9, "{rates:?}");
}

/// In soft rock the axis is stable when the bit turns fast, and there the rate of penetration is that of
/// steady drilling.
#[test]
fn steady_drilling_stays_steady_above_its_limit() {
    let file = |speed: f64| {
        format!(
            "surface_speed_rpm = {speed}\nstart = \"smooth\"\nmethods = [\"held\", \"quadrature\"]\n\
             [bit]\nrock = \"law\"\nweight_on_bit_kn = 20\n[bit.law]\nbit_radius_m = 0.15\n\
             specific_energy_mpa = 20\ncutting_ratio = 0.6\nfriction = 0.6\n\
             contact_strength_mpa = 60\ncontact_growth = 50\nwear_flat_mm = 1\n\
             [bit.cutting]\nblades = 6\n[string.axial]\ndamping_ns_m2 = 200\n"
        )
    };
    let outcome = |speed: f64| {
        let sweep = read(&file(speed)).unwrap();
        let case = crate::engine::Case::of(&sweep, &sweep.setting, 0).unwrap();
        let longest = case.scene.timing.duration;
        let outcomes: Vec<sim::AxialMeasures> = (sweep.methods.iter())
            .map(|&method| {
                let recipe = crate::engine::Recipe::of(&sweep, &sweep.setting, method, longest);
                let system = recipe.build().unwrap();
                let outcome = system.simulate(&case, sim::Stopping::Early, None).unwrap();
                outcome.axial().unwrap()
            })
            .collect();
        outcomes
    };
    for axial in outcome(400.0) {
        assert_eq!(axial.regime, sim::AxialRegime::Steady, "{axial:?}");
        let part = axial.part_of_steady.unwrap();
        assert!((part - 1.0).abs() < 1e-3, "{axial:?}");
    }
    for axial in outcome(80.0) {
        assert_ne!(axial.regime, sim::AxialRegime::Steady, "{axial:?}");
    }
}

/// Where a blade takes longer than that, a third of the time simulated, which is measured, sees three pass.
#[test]
fn a_bit_that_turns_slowly_is_followed_for_longer() {
    for (speed, window) in [(120.0, 20.0), (0.2, 3.0 * 60.0 / (6.0 * 0.2))] {
        let file = CUTTING.replace("= 120", &format!("= {speed}"));
        let sweep = read(&file).unwrap();
        let timing = crate::engine::Case::of(&sweep, &sweep.setting, 0).unwrap();
        let timing = timing.scene.timing;
        assert!((timing.closing_window / window - 1.0).abs() < 1e-12);
        // And the rise of the surface speed, before.
        assert!(timing.duration >= 3.0 * window, "{timing:?}");
    }
}
