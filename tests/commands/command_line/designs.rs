//! Grid, Monte Carlo and list; a sweep file on its base.

use std::collections::BTreeSet;

use crate::command_line::{columns, labels, manifest, run, succeeds, table, text};
use crate::support::{SMALL, Workplace, small_with_design, with};

const SPEED_AND_WEIGHT: [&str; 2] = ["surface_speed_rpm", "weight_on_bit_kn"];

#[test]
fn a_monte_carlo_design_draws_from_its_seed() {
    let random = |seed: u64| {
        small_with_design(&format!(
            "[design]\nkind = \"monte-carlo\"\ncases = 5\nseed = {seed}\n[design.axes]\n\
             surface_speed_rpm = {{ from = 0.1, to = 10, spacing = \"log\" }}\n\
             weight_on_bit_kn = {{ from = 30, to = 70 }}\n"
        ))
    };
    let place = Workplace::new();
    for (name, text) in [("a", random(1)), ("b", random(2))] {
        place.write(&format!("{name}.toml"), text);
        run(&place, &format!("{name}.toml"), name);
    }
    run(&place, "a.toml", "a-again");
    let values = |folder: &str| labels(&place, folder, SPEED_AND_WEIGHT);
    let (a, b) = (values("a"), values("b"));
    assert_eq!(a, values("a-again"));
    assert_ne!(a, b);
    assert_eq!(a.len(), 5);
    for [speed, weight] in a.iter().chain(&b) {
        assert!((0.1..10.0).contains(&speed.parse().unwrap()), "{speed}");
        assert!((30.0..70.0).contains(&weight.parse().unwrap()), "{weight}");
    }
    let distinct: BTreeSet<_> = a.iter().collect();
    assert_eq!(distinct.len(), 5);
    assert_ne!(
        manifest(&place, "a")["meaning_sha256"],
        manifest(&place, "b")["meaning_sha256"]
    );
}

/// The cases of a list, run: its labels.
fn labels_of_list(cases: &str) -> String {
    let design = "[design]\nkind = \"list\"\nfile = \"lists/cases.csv\"\n";
    let place = Workplace::with_small(&small_with_design(design));
    std::fs::create_dir(place.path("lists")).unwrap();
    place.write("lists/cases.csv", cases);
    run(&place, "small.toml", "results");
    text(&place, "results/labels.csv")
}

#[test]
fn a_list_is_run_in_its_own_order_for_any_order_of_columns() {
    let labels = labels_of_list("surface_speed_rpm,weight_on_bit_kn\n0.5,40\n0.1,60\n0.1,60\n");
    let values = columns(
        &table(&labels),
        ["case", "surface_speed_rpm", "weight_on_bit_kn"],
    );
    assert_eq!(
        values,
        [["0", "0.5", "40"], ["1", "0.1", "60"], ["2", "0.1", "60"]]
    );
    for spelling in [
        "weight_on_bit_kn,surface_speed_rpm\n40,0.5\n60,0.1\n60,0.1\n",
        "# fast first\nweight_on_bit_kn, surface_speed_rpm\n\n40.0, 5e-1\n# slow\n60,\"0.1\"\r\n6e1,.1",
    ] {
        assert_eq!(labels_of_list(spelling), labels);
    }
}

#[test]
fn a_listed_case_is_the_same_as_that_of_a_grid() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    let grid = text(&place, "results/labels.csv");
    let cases: String = columns(&table(&grid), SPEED_AND_WEIGHT)
        .iter()
        .map(|values| format!("{}\n", values.join(",")))
        .collect();
    assert_eq!(
        labels_of_list(&format!("{}\n{cases}", SPEED_AND_WEIGHT.join(","))),
        grid
    );
}

#[test]
fn a_base_is_changed_key_by_key_but_its_design_as_a_whole() {
    let place = Workplace::new();
    std::fs::create_dir(place.path("bases")).unwrap();
    place.write(
        "bases/rock.toml",
        "[bit]\ntorque_static_ratio = 1.5\nrock = \"shale\"\n",
    );
    place.write("bases/small.toml", format!("base = \"rock.toml\"\n{SMALL}"));
    place.write(
        "child.toml",
        "base = \"bases/small.toml\"\n[string]\ndensity_kg_m3 = 8000\n\
         [design]\nkind = \"grid\"\naxes = { surface_speed_rpm = { values = [0.5] } }\n\
         [bit]\nweight_on_bit_kn = 40\n",
    );
    run(&place, "child.toml", "results");
    let manifest = manifest(&place, "results");
    let sweep = &manifest["sweep"];
    assert_eq!(sweep["string"]["density_kg_m3"], 8000.0);
    assert_eq!(sweep["string"]["shear_modulus_gpa"], 80.0);
    assert_eq!(sweep["bit"]["rock"], "sandstone");
    assert_eq!(sweep["bit"]["torque_static_ratio"], 1.5);
    assert_eq!(sweep["bit"]["weight_on_bit_kn"], 40.0);
    assert_eq!(sweep["design"]["axes"].as_object().unwrap().len(), 1);
    assert_eq!(manifest["cases"], 1);
    assert_eq!(manifest["name"], "child");
    assert_eq!(manifest["title"], "A small sweep");
}

#[test]
fn a_list_is_looked_for_next_to_the_file_that_names_it() {
    let place = Workplace::new();
    std::fs::create_dir(place.path("bases")).unwrap();
    let design = "[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";
    place.write("bases/small.toml", small_with_design(design));
    place.write(
        "bases/cases.csv",
        "surface_speed_rpm,weight_on_bit_kn\n0.5,40\n",
    );
    place.write("child.toml", "base = \"bases/small.toml\"\n");
    let answer = succeeds(&place, &["run", "child.toml", "--dry-run"]);
    assert!(answer.output.contains("would run 1 case by"), "{answer:?}");
}

/// Axes of the string: each case is what a file with its values would give.
#[test]
fn an_axis_of_the_string_is_as_if_the_file_said_it() {
    let axes = "[design.axes]\n\
         torsional_damping_nms_rad_m = { values = [10, 30] }\n\
         section_0_repeat = { from = 8, to = 10, count = 2 }\n\
         section_0_part_1_outer_radius_m = { values = [0.14, 0.15] }\n\
         site_0_distance_from_bit_m = { values = [20, 50] }\n";
    let place = Workplace::with_small(&with(SMALL, "[design.axes]\n", axes).replace(
        "marks = [{ name = \"A\", surface_speed_rpm = 0.3, weight_on_bit_kn = 50 }]",
        "",
    ));
    let dry = succeeds(&place, &["run", "small.toml", "--dry-run"]).output;
    assert!(dry.contains("16 distinct strings"), "{dry}");
    // Which settled cases are followed to the end depends on their numbers.
    let run = |file: &str, out: &str| succeeds(&place, &["run", file, "--full", "--out", out]);
    run("small.toml", "axes");
    let strings = &manifest(&place, "axes")["strings"];
    assert_eq!(strings, 16);
    let found = table(&text(&place, "axes/labels.csv"));
    assert_eq!(found.len(), 1 + 16 * 6);
    // In the file: cases of one string are neighbours.
    for (string, [damping, repeat, radius, place_of_site]) in [
        (0, ["10", "8", "0.14", "20"]),
        (6, ["10", "10", "0.15", "20"]),
        (15, ["30", "10", "0.15", "50"]),
    ] {
        let mut text_of = SMALL.to_owned();
        for (before, after, value) in [
            ("rad_m = 10", "rad_m = ", damping),
            ("repeat = 10", "repeat = ", repeat),
            ("outer_radius_m = 0.15 ", "outer_radius_m = ", radius),
            ("from_bit_m = 50", "from_bit_m = ", place_of_site),
        ] {
            text_of = with(&text_of, before, &format!("{after}{value} "));
        }
        place.write("one.toml", text_of);
        run("one.toml", &format!("one-{string}"));
        let expected = table(&text(&place, &format!("one-{string}/labels.csv")));
        for case in 0..6 {
            let row = &found[1 + 6 * string + case];
            let values = [damping, repeat, radius, place_of_site];
            assert_eq!(row[2..6], values.map(str::to_owned));
            assert_eq!(row[6..], expected[1 + case][2..], "{string} {case}");
        }
    }
}

/// The small string with a wall, and an impulse at a site.
fn lateral(distance: &str) -> String {
    let text = with(
        &small_with_design(""),
        "[[string.sections]]",
        "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n\
         [[string.sections]]",
    );
    let text = with(&text, "[bit]\nrock = \"sandstone\"\n", "");
    with(
        &text,
        "distance_from_bit_m = 50",
        &format!("distance_from_bit_m = {distance}"),
    ) + &format!(
        "[wall]\nclearance_mm = 15\nstiffness_gn_m15 = 1\nfriction = 0.5\n\n\
         [[impulses]]\ndistance_from_bit_m = {distance}\nratio = 3\n"
    )
}

/// With a ratio of one it does not; the friction of a fast slide is then that of a wall which
/// has no more.
#[test]
fn friction_at_the_wall_falls_with_the_speed_of_sliding() {
    let place = Workplace::new();
    let labels = |name: &str, friction: &str| {
        let content = with(&lateral("0"), "friction = 0.5\n", friction);
        place.write("one.toml", content);
        run(&place, "one.toml", name);
        table(&text(&place, &format!("{name}/labels.csv")))
    };
    let constant = labels("constant", "friction = 0.5\n");
    let one = "friction = 0.5\nfriction_dynamic_ratio = 1\nfriction_stribeck_m_s = 2\n";
    assert_eq!(labels("one", one), constant);
    let falls = |speed| format!("friction = 0.5\nfriction_dynamic_ratio = 0.2\n{speed}\n");
    let at_once = labels("at_once", &falls(""));
    let slowly = labels("slowly", &falls("friction_stribeck_m_s = 0.3048"));
    assert_ne!(at_once, constant);
    assert_ne!(slowly, at_once);
    let field = labels("field", &falls("friction_stribeck_ft_s = 1"));
    assert_eq!(field, slowly);
    assert_ne!(constant[1][3], "no_contact");
}

/// The impulse goes with its site, and the wall stays where it is.
#[test]
fn a_site_that_moves_takes_its_impulse_along() {
    let place = Workplace::new();
    let axes = "\n[design]\nkind = \"grid\"\n[design.axes]\n\
                site_0_distance_from_bit_m = { values = [0, 20] }\n";
    place.write("axes.toml", lateral("50") + axes);
    run(&place, "axes.toml", "axes");
    let found = table(&text(&place, "axes/labels.csv"));
    for (case, distance) in ["0", "20"].into_iter().enumerate() {
        place.write("one.toml", lateral(distance));
        run(&place, "one.toml", distance);
        let expected = table(&text(&place, &format!("{distance}/labels.csv")));
        assert_eq!(found[1 + case][3..], expected[1][2..]);
        assert_ne!(expected[1][3], "no_contact");
    }
    assert_ne!(found[1][4..], found[2][4..]);
}
