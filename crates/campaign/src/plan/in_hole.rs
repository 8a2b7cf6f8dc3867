//! Strings in their holes as sweep files describe them: where they touch, with how much clearance,
//! and what is refused with its line.

use std::path::Path;

use super::{Setting, Sweep};
use crate::sweep_file::SweepFileError;

/// Pipe with joints, collars, a stabiliser and a bit, 47.5 m, in casing, open hole and a washout.
const IN_HOLE: &str = r#"surface_speed_rpm = 60
time_s = 10
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }
[[string.sections]]
repeat = 3
parts = [{ length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.06 }, { length_m = 0.5, inner_radius_m = 0.05, outer_radius_m = 0.08 }]
[[string.sections]]
repeat = 2
parts = [{ length_m = 8, inner_radius_m = 0.04, outer_radius_m = 0.1 }]
[[string.sections]]
repeat = 1
parts = [{ length_m = 1, inner_radius_m = 0.04, outer_radius_m = 0.1, contact_radius_m = 0.15 }]
[[string.sections]]
repeat = 1
parts = [{ length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.1 }]
[well]
holes = [
    { from_m = 0, to_m = 30, hole_radius_m = 0.2 },
    { from_m = 30, to_m = 40, hole_radius_m = 0.16 },
    { from_m = 40, to_m = 44, hole_radius_m = 0.25 },
    { from_m = 44, to_m = 60, hole_radius_m = 0.16 },
]
[wall]
clearance = "hole"
friction = 0.3
sites = "all"
"#;

fn read(text: &str) -> Result<Sweep, SweepFileError> {
    Sweep::read_from(Path::new("sweep.toml"), &[], &|_, _| Ok(text.to_owned()))
}

/// [`IN_HOLE`] with one piece of it replaced, and more after it.
#[track_caller]
fn with(piece: &str, instead: &str, more: &str) -> String {
    assert_eq!(IN_HOLE.matches(piece).count(), 1, "{piece}");
    IN_HOLE.replace(piece, instead) + more
}

/// Of each site from the bit up: its distance, which one of the file it is, clearance in mm, R₀.
fn sites(setting: &Setting) -> Vec<(f64, Option<usize>, f64, f64)> {
    let walls = &setting.lateral.as_ref().unwrap().walls;
    let sites = setting.sites.distances_from_bit().iter().zip(walls).rev();
    sites
        .map(|(distance, wall)| {
            let clearance_mm = (1e9 * wall.clearance).round() / 1e6;
            (*distance, wall.site, clearance_mm, wall.radius)
        })
        .collect()
}

#[test]
fn candidates_and_sites_of_the_file_have_the_clearance_that_the_hole_leaves() {
    let more = "[[sites]]\ndistance_from_bit_m = 5\n\
                [[sites]]\ndistance_from_bit_m = 13.50000001\nfriction = 0.1\n\
                [[sites]]\ndistance_from_bit_m = 0\nclearance_mm = 2\n\
                [[impulses]]\ndistance_from_bit_ft = 58.23490813648294\nratio = 3\n";
    let sweep = read(&(IN_HOLE.to_owned() + more)).unwrap();
    assert_eq!(
        sites(&sweep.setting),
        [
            (0.0, Some(2), 2.0, 0.1),
            (1.0, None, 10.0, 0.15),
            (5.0, Some(0), 150.0, 0.1),
            (13.50000001, Some(1), 60.0, 0.1),
            (17.75, None, 120.0, 0.08),
            (27.75, None, 120.0, 0.08),
            (37.75, None, 120.0, 0.08),
        ]
    );
    let lateral = sweep.setting.lateral.as_ref().unwrap();
    // Counted from the surface down, at the lowest joint.
    assert_eq!(lateral.impulses[0].site, 2);
    assert_eq!(lateral.walls[3].friction, Some(0.1));
    assert_eq!(lateral.walls[2].friction, Some(0.3));
    // Sites are those of the file in what is written of it.
    assert_eq!(sweep.content.sites.len(), 3);
}

/// A hole of one width goes as deep as the string; a string of other measures touches elsewhere.
#[test]
fn axes_of_the_string_move_candidates_and_clearances() {
    let holes = &IN_HOLE[IN_HOLE.find("holes =").unwrap()..IN_HOLE.find("[wall]").unwrap()];
    let more = "[design]\nkind = \"grid\"\n[design.axes]\n\
                section_0_part_1_outer_radius_m = { values = [0.08, 0.09] }\n\
                section_1_part_0_length_m = { values = [8, 9] }\n\
                clearance_mm = { values = [7] }\n";
    let sweep = read(&with(holes, "hole_radius_m = 0.2\n", more)).unwrap();
    let of_case = |values: [f64; 2]| {
        let places = [0, 1].map(|place| (sweep.design.axes()[place], values[place]));
        sites(&sweep.setting_with(places.into_iter()).unwrap())
    };
    assert_eq!(of_case([0.08, 8.0])[2], (17.75, None, 120.0, 0.08));
    assert_eq!(of_case([0.09, 8.0])[2], (17.75, None, 110.0, 0.09));
    assert_eq!(of_case([0.08, 9.0])[1], (15.0, None, 100.0, 0.1));
    // An axis of the clearance goes before what the hole leaves.
    let lateral = sweep.setting.lateral.as_ref().unwrap();
    let conditions = sweep.conditions_at(&[0.08, 8.0, 7.0]);
    let clearances = lateral
        .walls
        .iter()
        .map(|wall| wall.in_case(&conditions).clearance);
    assert!(clearances.into_iter().all(|clearance| clearance == 7e-3));
}

/// Blades of a clearance given by hand turn on the wall with their own radius.
#[test]
fn the_radius_of_contact_counts_where_the_clearance_is_given() {
    let well = &IN_HOLE[IN_HOLE.find("[well]").unwrap()..IN_HOLE.find("[wall]").unwrap()];
    let text = with(well, "", "").replace("clearance = \"hole\"", "clearance_mm = 4");
    let found = sites(&read(&text).unwrap().setting);
    assert_eq!(found[0], (1.0, None, 4.0, 0.15));
    assert_eq!(found.len(), 5);
    let even = text.replace("sites = \"all\"", "sites = \"all\"\nsites_every_ft = 100\n");
    assert_eq!(
        sites(&read(&even).unwrap().setting),
        [(0.0, None, 4.0, 0.1), (30.48, None, 4.0, 0.06)]
    );
}

/// The shipped one: three stabilisers, a sixteenth of an inch from the wall.
#[test]
fn the_shipped_string_touches_with_its_blades() {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../sweeps/well_12in_contacts.toml"
    );
    let found = sites(&Sweep::read(Path::new(file)).unwrap().setting);
    let close = found.iter().filter(|site| site.2 == 1.5875);
    let close: Vec<f64> = close.map(|site| site.0).collect();
    assert_eq!(close, [4.735, 15.625, 29.43]);
    assert_eq!(found.len(), 24);
}

/// With its ends it touches where the independent reference of the static string has it.
#[test]
fn the_shipped_string_may_touch_with_the_ends_of_its_wide_parts() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps");
    let file = Path::new(folder).join("well_12in_contacts.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let ends = text.replace("sites = \"all\"", "sites = \"ends\"");
    // Where the impulse is, in the middle of a collar, is then no site.
    let ends = ends.replace("distance_from_bit_m = 38.54", "distance_from_bit_m = 43.2");
    let file = file.with_file_name("ends.toml");
    let from = |path: &Path, _: u64| match path == file {
        true => Ok(ends.clone()),
        false => std::fs::read_to_string(path),
    };
    let sweep = Sweep::read_from(&file, &[], &from).unwrap();
    let mut expected = problems::field_assembly::ends(200.0);
    expected.sort_by(|a, b| a.distance_from_bit.total_cmp(&b.distance_from_bit));
    let found = sites(&sweep.setting);
    assert_eq!(found.len(), expected.len());
    for ((distance, _, clearance_mm, radius), expected) in found.into_iter().zip(expected) {
        assert!(
            (distance - expected.distance_from_bit).abs() < 1e-3,
            "{distance} {expected:?}"
        );
        assert!(
            (1e-3 * clearance_mm - expected.clearance).abs() < 1e-9,
            "{distance}"
        );
        // The bit's body is narrow.
        assert!(
            distance == 0.0 || (radius - expected.radius).abs() < 1e-9,
            "{distance}"
        );
    }
}

/// In a straight well it lies as the independent reference of the static string has it, by the
/// sites and the clearances of the file.
#[test]
fn the_shipped_string_lies_in_an_inclined_hole() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps");
    let file = Path::new(folder).join("well_12in_contacts.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let inclined = text
        .replace(
            "hole_diameter_in = 12.25",
            "hole_diameter_in = 12.25\ninclination_deg = 60",
        )
        .replace("density_ppg = 13.436", "density_kg_m3 = 1200")
        .replace("sites_to_m = 200", "sites_to_m = 250")
        .replace(
            "distance_from_bit_m = 38.54",
            "distance_from_bit_m = 38.54\namount_ns = 3000",
        )
        .replace("impulse_ratio = { values = [1.5, 3, 6] }", "");
    let file = file.with_file_name("inclined.toml");
    let from = |path: &Path, _: u64| match path == file {
        true => Ok(inclined.clone()),
        false => std::fs::read_to_string(path),
    };
    let sweep = Sweep::read_from(&file, &[], &from).unwrap();
    let lying = sweep
        .setting
        .lying_string(&sweep.conditions, None)
        .unwrap()
        .unwrap();
    let state = lying.at_rest().unwrap();
    let forces = [995.4084, 10268.2199, 23023.5236, 0.0, 30904.9361];
    for (it, force) in state.contacts().iter().rev().zip(forces) {
        // In a hole of 12 1/4 in that is rounded to a hundredth of a millimetre.
        assert!((it.normal() - force).abs() <= 1e-4 * force, "{it:?}");
    }
    // A hanging one does not lie.
    let sweep = Sweep::read(&Path::new(folder).join("well_12in_contacts.toml")).unwrap();
    assert!(
        sweep
            .setting
            .lying_string(&sweep.conditions, None)
            .is_none()
    );
}

#[test]
fn an_inclination_that_a_well_does_not_have_is_refused_with_its_line() {
    let with_well = |keys: &str| with("[well]\n", &format!("[well]\n{keys}\n"), "");
    let steep = with_well("inclination_deg = 181");
    let message = "181 ° is not between 0 and 180 °";
    is_refused(&steep, "inclination_deg", "well.inclination_deg", message);
    let both = with_well("inclination_deg = 30\nsurvey = \"survey.csv\"");
    let message = "conflicts with `inclination_deg`: give only one";
    is_refused(&both, "survey =", "survey", message);
    assert!(
        read(&with_well("inclination_deg = 30"))
            .unwrap()
            .setting
            .lying
            .is_some()
    );
}

/// A mistake: the file, a piece of the wrong line, its key, and the message.
#[track_caller]
fn is_refused(text: &str, at: &str, key: &str, expected: &str) {
    let line = 1 + text.lines().position(|line| line.contains(at)).expect(at);
    let message = read(text).unwrap_err().to_string();
    let place = format!("sweep.toml:{line}: `{key}`: ");
    assert!(message.starts_with(&place), "{place}\n{message}");
    assert!(message.contains(expected), "{expected}\n{message}");
}

#[test]
fn a_clearance_that_the_hole_cannot_leave_is_refused_with_its_line() {
    let well = &IN_HOLE[IN_HOLE.find("[well]").unwrap()..IN_HOLE.find("[wall]").unwrap()];
    is_refused(
        &with(well, "", ""),
        "clearance =",
        "wall.clearance",
        "needs `well.hole_radius_m`",
    );
    let both = with(
        "clearance = \"hole\"",
        "clearance = \"hole\"\nclearance_in = 1",
        "",
    );
    let message = "conflicts with `clearance_in`: give only one";
    is_refused(&both, "clearance = \"hole\"", "clearance", message);
    let by_hand = with("clearance = \"hole\"", "clearance_mm = 4", "");
    let notes = read(&by_hand).unwrap().notes().concat();
    assert!(
        notes.contains("the hole of [well] has no effect without"),
        "{notes}"
    );
    let narrow = with(
        "to_m = 60, hole_radius_m = 0.16",
        "to_m = 60, hole_radius_m = 0.149",
        "",
    );
    let key = "string.sections[2].parts[0].contact_radius_m";
    let message =
        "does not fit: its radius is 0.15 m, and at a depth of 46 m that of the hole is 0.149 m";
    is_refused(&narrow, "contact_radius_m", key, message);
    let narrow = with(
        "to_m = 30, hole_radius_m = 0.2",
        "to_m = 30, hole_radius_m = 0.07",
        "",
    );
    let key = "string.sections[0].parts[1].outer_radius_m";
    let message =
        "does not fit: its radius is 0.08 m, and at a depth of 29.5 m that of the hole is 0.07 m";
    is_refused(&narrow, "length_m = 9.5", key, message);
}

/// Blades and a bit of full gauge are in a hole that is a 32nd of an inch wider, and mud passes them.
#[test]
fn what_drilled_the_hole_fits_it() {
    let bit = "parts = [{ length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.1 }]";
    let wide = bit.replace("outer_radius_m = 0.1", "outer_radius_m = 0.15");
    let mud = "[mud]\ndensity_kg_m3 = 1500\n";
    let text = with(bit, &wide, mud).replace(
        "to_m = 60, hole_radius_m = 0.16",
        "to_m = 60, hole_radius_m = 0.15",
    );
    let setting = read(&text).unwrap().setting;
    let found = sites(&setting);
    // The bit is no wider than the blades next to it.
    assert_eq!((found[0].0, found[0].2), (1.0, 0.4));
}

#[test]
fn sites_that_the_hole_does_not_reach_are_refused_with_their_line() {
    let short = IN_HOLE.replace(
        "    { from_m = 44, to_m = 60, hole_radius_m = 0.16 },\n",
        "",
    );
    let message = "the site 1 m from the bit is at a depth of 46.5 m, and the hole ends at 44 m";
    is_refused(&short, "holes = [", "well.holes", message);
    let own = "[[sites]]\ndistance_from_bit_m = 2 # here\n";
    let short = short.replace("sites = \"all\"\n", "") + own;
    let message = "at a depth of 45.5 m, and the hole ends at 44 m";
    is_refused(&short, "# here", "sites[0].distance_from_bit_m", message);
    // A site with its own clearance does not need the hole.
    let sweep = read(&(short + "clearance_mm = 3\n")).unwrap();
    assert_eq!(sites(&sweep.setting), [(2.0, Some(0), 3.0, 0.1)]);
    // Below the collar, which just fits above, the hole is narrow.
    let touching = with(
        "from_m = 40, to_m = 44, hole_radius_m = 0.25",
        "from_m = 40, to_m = 44, hole_radius_m = 0.1000005",
        "",
    )
    .replace("sites = \"all\"\n", "")
        + "[[sites]]\ndistance_from_bit_m = 7.5 # here\n";
    let message = "at a depth of 40 m, the string touches with a radius of 0.1 m, and the \
                   clearance \
                that the hole leaves it is out of range: 0.0005 mm is not between";
    is_refused(&touching, "# here", "sites[0].distance_from_bit_m", message);
}

#[test]
fn no_candidates_or_too_many_are_refused_with_their_line() {
    let key = "wall.sites";
    let none = IN_HOLE.replace("sites = \"all\"", "sites = \"all\"\nsites_to_m = 0.6");
    let message = "no part of the string up to 0.6 m from the bit is wider than its neighbours: \
                `sites_every_m` makes";
    is_refused(&none, "sites = \"all\"", key, message);
    let many = IN_HOLE.replace("sites = \"all\"", "sites = \"all\"\nsites_every_m = 0.02");
    is_refused(
        &many,
        "sites = \"all\"",
        key,
        "more than 2000 candidates: `sites_to_m` ends",
    );
    for (name, message) in [
        (
            "sites_every_m",
            "needs `sites = \"all\"`, `\"ends\"` or `\"auto\"`",
        ),
        (
            "sites_to_ft",
            "needs `sites = \"all\"`, `\"ends\"` or `\"auto\"`",
        ),
    ] {
        let idle = IN_HOLE.replace("sites = \"all\"", &format!("{name} = 9"));
        is_refused(&idle, name, &format!("wall.{name}"), message);
    }
    let elsewhere = IN_HOLE.replace("sites = \"all\"", "hole_diameter_mm = 311");
    let message = "unknown key `hole_diameter_mm`; known here: clearance_mm";
    is_refused(
        &elsewhere,
        "hole_diameter_mm",
        "wall.hole_diameter_mm",
        message,
    );
    let cutting = "[bit]\ntorque_dynamic_nm = 2000\n";
    is_refused(
        &(IN_HOLE.to_owned() + cutting),
        "[wall]",
        "wall",
        "a bit with `[bit]` is one of the `[[sites]]`",
    );
    let even = IN_HOLE.replace("sites = \"all\"", "sites = \"all\"\nsites_every_m = 9");
    assert!(read(&(even + cutting)).is_ok());
    let far = "[[impulses]]\ndistance_from_bit_m = 20 # here\nratio = 3\n";
    let message = "no site is 20 m from the bit; there are sites at 37.75, 27.75, 17.75, 13.5, 1 m";
    let at = "impulses[0].distance_from_bit_m";
    is_refused(&(IN_HOLE.to_owned() + far), "# here", at, message);
    let many = IN_HOLE.replace("sites = \"all\"", "sites = \"all\"\nsites_every_m = 3") + far;
    is_refused(
        &many,
        "# here",
        at,
        "of 16 sites the nearest are at 21, 18 m",
    );
    let narrow = with("contact_radius_m = 0.15", "contact_diameter_in = 7", "");
    let key = "string.sections[2].parts[0].contact_diameter_in";
    is_refused(
        &narrow,
        "contact_diameter_in",
        key,
        "is less than the external radius, 3.937 in",
    );
}

#[test]
fn sites_that_cannot_be_found_are_refused() {
    let site = "[[sites]]\ndistance_from_bit_m = 13.5\n";
    let auto = with("sites = \"all\"", "sites = \"auto\"", site);
    let sweep = read(&auto).unwrap();
    let lateral = sweep.setting.lateral.as_ref().unwrap();
    assert_eq!(lateral.walls.len(), 1);
    // Every corner of the hole and of the string, twice where something changes.
    let clearances: Vec<(f64, f64)> = (lateral.clearances.iter())
        .map(|(depth, clearance)| (*depth, (1e9 * clearance).round() / 1e6))
        .collect();
    assert_eq!(
        clearances[..4],
        [(0.0, 140.0), (9.5, 140.0), (9.5, 120.0), (10.0, 120.0)]
    );
    let last = &clearances[clearances.len() - 9..];
    let expected = [(40.0, 60.0), (40.0, 150.0), (44.0, 150.0), (44.0, 60.0)];
    assert_eq!(last[..4], expected, "{clearances:?}");
    let bit = [
        (46.0, 60.0),
        (46.0, 10.0),
        (47.0, 10.0),
        (47.0, 60.0),
        (47.5, 60.0),
    ];
    assert_eq!(last[4..], bit);
    let more = |key: &str| auto.replace("sites = \"auto\"", &format!("sites = \"auto\"\n{key}"));
    for (key, value, message) in [
        ("sites_rounds", "0", "0 is not between 1 and 1000"),
        ("sites_rounds", "1001", "1001 is not between 1 and 1000"),
        (
            "sites_tolerance_mm",
            "0",
            "0 mm is not between 0.001 and 1000 mm",
        ),
    ] {
        let text = more(&format!("{key} = {value}"));
        is_refused(&text, key, &format!("wall.{key}"), message);
    }
    for key in ["sites_rounds = 3", "sites_tolerance_in = 0.1"] {
        let idle = auto.replace("sites = \"auto\"", key);
        let name = key.split(' ').next().unwrap();
        is_refused(
            &idle,
            name,
            &format!("wall.{name}"),
            "needs `sites = \"auto\"`",
        );
    }
    let short = auto.replace("to_m = 60", "to_m = 47.2");
    let message = "finds sites down to the bit, at a depth of 47.5 m, and the hole ends at 47.2 m";
    is_refused(&short, "sites = \"auto\"", "wall.sites", message);
    let unknown = auto.replace("clearance = \"hole\"\n", "");
    let own = unknown.replace(site, &format!("{site}clearance_mm = 5\n"));
    let well = &own[own.find("[well]").unwrap()..own.find("[wall]").unwrap()];
    let own = own.replace(well, "");
    is_refused(
        &own,
        "sites = \"auto\"",
        "wall.sites",
        "needs `clearance_mm` or",
    );
    let none = auto.replace(site, "");
    is_refused(&none, "[wall]", "wall", "a wall needs `[[sites]]`");
}
