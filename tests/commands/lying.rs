//! How a string lies in its hole, as `inspect` has it: in words, as JSON, in tables and a picture.

use std::collections::HashMap;

use serde_json::Value;

use crate::support::Workplace;

/// Collars in a hole of 30°, on blades, on their joints and on the bit.
const LYING: &str = r#"
title = "Collars that lie"
surface_speed_rpm = 60
time_s = 1
sampling_frequency_hz = 400
methods = ["finite-element"]
[string]
shear_modulus_gpa = 79.3
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 206, damping_ns_m2 = 200 }
[[string.sections]]
repeat = 6
parts = [
    { length_m = 9, inner_radius_m = 0.04, outer_radius_m = 0.09 },
    { length_m = 1, inner_radius_m = 0.04, outer_radius_m = 0.1 },
]
[[string.sections]]
repeat = 1
parts = [{ length_m = 2, inner_radius_m = 0.04, outer_radius_m = 0.1, contact_radius_m = 0.15 }]
[[string.sections]]
repeat = 1
parts = [{ length_m = 10, inner_radius_m = 0.04, outer_radius_m = 0.1 }]
[well]
hole_radius_m = 0.152
inclination_deg = 30
[wall]
clearance = "hole"
friction = 0.3
sites = "ends"
[[sites]]
distance_from_bit_m = 0
clearance_mm = 2
"#;

/// Two cases of it.
const DESIGN: &str =
    "[design]\nkind = \"grid\"\n[design.axes]\nfriction = { values = [0.1, 0.3] }\n";

#[test]
fn an_inspection_says_how_a_string_lies_in_its_hole() {
    let place = Workplace::with_small(LYING);
    let arguments = ["inspect", "small.toml", "--out", "out"];
    let text = place.answer(&arguments);
    assert_eq!(text.code, 0, "{}", text.errors);
    let json = place.answer(&[&arguments[..], &["--json"]].concat());
    let found: Value = serde_json::from_str(&json.output).unwrap();
    let lying = &found["lying"];
    let number = |value: &Value| value.as_f64().unwrap();
    assert_eq!(lying["is_stable"], true);
    // Spans of 9 m of the pipe, held at slopes by those next to them, or less as contacts are few.
    let snakes = number(&lying["snakes_from_kn"]);
    assert!((100.0..2000.0).contains(&snakes), "{snakes}");
    let contacts = lying["contacts"].as_array().unwrap();
    // The collars between bit and blades weigh at the former: less than half, as they are held at
    // the latter.
    let area = std::f64::consts::PI * (0.1_f64.powi(2) - 0.04_f64.powi(2));
    let half = 0.5 * 5.0 * 7.85 * 9.80665 * area * 30f64.to_radians().sin();
    let bit = number(&contacts[0]["force_kn"]);
    assert!((0.5 * half..1.5 * half).contains(&bit), "{bit} {half}");
    assert!((number(&lying["side_force_of_bit_kn"][0]) + bit).abs() < 1e-9);
    for contact in contacts {
        assert!(number(&contact["angle_deg"]).abs() < 1e-6, "{contact}");
    }
    let moment = &lying["greatest_moment_knm"];
    let [value, from_bit] = ["value", "from_bit_m"].map(|key| number(&moment[key]));
    for words in [
        format!("{value:.2} kN m, {from_bit:.2} m from the bit"),
        format!("side force of the bit      {bit:.3} kN to the low side"),
        format!("{} of {} sites", contacts.len(), number(&lying["sites"])),
    ] {
        assert!(text.output.contains(&words), "{words}\n{}", text.output);
    }
    let sites = std::fs::read_to_string(place.path("out/static_contacts.csv")).unwrap();
    let sum = |column: usize| -> f64 {
        let fields = sites.lines().skip(1);
        let fields = fields.map(|line| line.split(',').nth(column).unwrap());
        let given = fields.filter(|field| !field.is_empty());
        given.map(|field| field.parse::<f64>().unwrap()).sum()
    };
    let pressed: f64 = contacts.iter().map(|it| number(&it["force_kn"])).sum();
    assert!((sum(4) - pressed).abs() < 1e-9);
    // A string without stiffness presses with as much, but for what the surface holds.
    assert!((sum(5) / pressed - 1.0).abs() < 0.1, "{} {pressed}", sum(5));
    // Sliding it climbs to where friction holds it, and presses less.
    let torque = number(&lying["turning"]["friction_torque_knm"]);
    let radius = torque / (0.3 * sum(6));
    assert!((0.1..0.15).contains(&radius), "{radius}");
    let less = sum(6) / pressed * 1.09f64.sqrt();
    assert!((less - 1.0).abs() < 0.03, "{less}");
    let along = std::fs::read_to_string(place.path("out/static_string.csv")).unwrap();
    assert!(along.starts_with("distance_from_bit_m,high_side_mm,right_mm,tension_kn,"));
    assert!(place.path("out/static_string.png").exists());
    // Its bit held otherwise: in the middle of the hole, or by nothing.
    let lowest = |bit: &str| {
        let text = place.answer(&[&arguments[..], &["--bit", bit]].concat());
        let lines = text.output.lines();
        let line = lines.filter(|line| line.contains("side force of the bit"));
        let sites = std::fs::read_to_string(place.path("out/static_contacts.csv")).unwrap();
        let fields: Vec<f64> = (sites.lines().nth(1).unwrap().split(',').take(5))
            .map(|field| field.parse().unwrap())
            .collect();
        (line.collect::<String>(), fields)
    };
    let (_, pinned) = lowest("pinned");
    assert!(
        pinned[0] == 0.0 && pinned[2].abs() < 1e-9 && pinned[4] > 0.0,
        "{pinned:?}"
    );
    let (force, free) = lowest("free");
    assert!(free[0] > 0.0 && force.contains("none"), "{free:?} {force}");
    // A case has them as well.
    let text = place.answer(&["simulate", "small.toml", "--out", "case"]);
    assert!(
        text.output.contains("static_string"),
        "{}{}",
        text.output,
        text.errors
    );
    assert!(place.path("case/static_string.png").exists());
    // One that hangs straight lies on nothing.
    let hanging = Workplace::with_small(&LYING.replace("inclination_deg = 30\n", ""));
    let text = hanging.answer(&arguments);
    assert!(
        !text.output.contains("at rest in its hole"),
        "{}",
        text.output
    );
    assert!(!hanging.path("out/static_string.csv").exists());
    let text = hanging.answer(&[&arguments[..], &["--bit", "free"]].concat());
    assert!(
        text.errors.contains("--bit: the string does not lie"),
        "{}",
        text.errors
    );
}

/// Sites closer to each other than elements are short.
#[test]
fn a_string_that_is_not_found_to_lie_in_its_hole_is_refused() {
    let near = "[[sites]]\ndistance_from_bit_m = 5\n[[sites]]\ndistance_from_bit_m = 5.0015\n";
    let place = Workplace::with_small(&format!("{LYING}{near}"));
    let text = place.answer(&["inspect", "small.toml", "--out", "out"]);
    let words = "two contacts are less than 0.002 m apart, 5 m from the bit";
    assert!(
        text.errors.contains(words),
        "{}{}",
        text.output,
        text.errors
    );
    assert_ne!(text.code, 0);
}

/// The same string, turned: labels and columns of a string that lies, by two methods.
#[test]
fn a_run_says_how_a_string_lies_and_swings() {
    let run = |more: &str| {
        let text = LYING
            .replace("time_s = 1\n", "")
            .replace("[\"finite-element\"]", "[\"held\", \"finite-element\"]");
        let place = Workplace::with_small(&(text + more));
        let run = place.sweep(&["run", "small.toml", "--out", "out"]);
        assert_eq!(run.code, 0, "{run:?}");
        place
    };
    let place = run(DESIGN);
    let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    let column = |name: &str| names.iter().position(|it| *it == name).unwrap();
    let rows: Vec<Vec<&str>> = lines.collect();
    assert_eq!(rows.len(), 4);
    for row in &rows {
        let number = |name: &str| row[column(name)].parse::<f64>().unwrap();
        assert_eq!(row[column("lateral")], "low_side");
        // It climbs by about the angle of friction, and lies there.
        let friction: f64 = number("friction");
        let climb = number("climb_deg");
        let slides = friction.atan().to_degrees();
        assert!(
            (0.5..1.3).contains(&(climb / slides)),
            "{friction}: {climb}"
        );
        assert!(number("swing_deg") < 1.0);
        assert!(number("greatest_angle_deg") > climb);
        assert!(number("acceleration_rms_g") <= number("acceleration_peak_g"));
        assert_eq!(number("lateral_shocks_per_s"), 0.0);
    }
    // In the middle of its hole it touches nothing.
    let hangs = LYING.replace(
        "sites = \"ends\"",
        "sites = \"ends\"\nlies_on_low_side = false",
    );
    let place = Workplace::with_small(&(hangs + DESIGN));
    let hanging = place.sweep(&["run", "small.toml", "--out", "out"]);
    assert_eq!(hanging.code, 0, "{hanging:?}");
    let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    assert!(!table.contains("climb_deg") && table.contains("no_contact"));
}

/// The rows of `labels.csv` of a run, as numbers by the names of columns.
fn rows_of(place: &Workplace) -> Vec<impl Fn(&str) -> f64 + use<>> {
    let run = place.sweep(&["run", "small.toml", "--out", "out"]);
    assert_eq!(run.code, 0, "{run:?}");
    let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let mut lines = table.lines().map(|line| {
        let fields = line.split(',').map(str::to_owned);
        fields.collect::<Vec<String>>()
    });
    let names = lines.next().unwrap();
    let row = |fields: Vec<String>| {
        let names = names.clone();
        move |name: &str| {
            let at = names.iter().position(|it| it == name).unwrap();
            fields[at].parse::<f64>().unwrap()
        }
    };
    lines.map(row).collect()
}

/// Without friction it turns as it lies, so that it is bent as `inspect` says, by every method: once a
/// turn each point of its surface is stretched as much as it is pressed.
#[test]
fn a_string_that_turns_as_it_lies_is_bent_and_stressed_as_at_rest() {
    let text = LYING
        .replace("friction = 0.3", "friction = 0\nstress_every_m = 1")
        .replace("time_s = 1\n", "time_s = 6\n")
        .replace(
            "[\"finite-element\"]",
            "[\"held\", \"quadrature\", \"finite-element\"]",
        );
    let place = Workplace::with_small(&text);
    let inspected = place.answer(&["inspect", "small.toml", "--out", "out", "--json"]);
    let found: Value = serde_json::from_str(&inspected.output).unwrap();
    let greatest = |what: &str| found["lying"][what]["value"].as_f64().unwrap();
    let along = std::fs::read_to_string(place.path("out/static_string.csv")).unwrap();
    let mut lines = along
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    let column = |name: &str| names.iter().position(|it| *it == name).unwrap();
    let at_rest: Vec<[f64; 2]> = lines
        .map(|line| {
            let number = |name: &str| line[column(name)].parse::<f64>().unwrap();
            let moment = ["moment_to_high_side_knm", "moment_to_right_knm"].map(number);
            [number("distance_from_bit_m"), moment[0].hypot(moment[1])]
        })
        .collect();
    let rows = rows_of(&place);
    assert_eq!(rows.len(), 3);
    for row in &rows {
        let (moment, from_bit) = (
            row("bending_moment_peak_kn_m"),
            row("bending_moment_from_bit_m"),
        );
        let there = at_rest
            .iter()
            .find(|[distance, _]| (distance - from_bit).abs() < 1e-6);
        let [_, expected] = there.unwrap_or_else(|| panic!("{from_bit} is no node"));
        assert!(
            (moment / expected - 1.0).abs() < 1e-6,
            "{moment} {expected}"
        );
        // Places a metre apart.
        let most = greatest("greatest_moment_knm");
        assert!(
            moment <= most + 1e-9 && moment > 0.98 * most,
            "{moment} {most}"
        );
        let bending = row("bending_stress_peak_mpa");
        let most = greatest("greatest_bending_stress_mpa");
        assert!(
            bending <= most + 1e-9 && bending > 0.98 * most,
            "{bending} {most}"
        );
        let amplitude = row("bending_stress_amplitude_mpa");
        assert!(
            (amplitude / bending - 1.0).abs() < 1e-3,
            "{amplitude} {bending}"
        );
        let von_mises = row("von_mises_peak_mpa");
        let most = greatest("greatest_von_mises_mpa");
        assert!(
            von_mises >= bending && von_mises <= most + 1e-9,
            "{von_mises} {most}"
        );
    }
}

/// A table of a case, a row for each of its lines by the names of columns.
fn table(place: &Workplace, name: &str) -> Vec<HashMap<String, f64>> {
    let text = std::fs::read_to_string(place.path(name)).unwrap();
    let mut lines = text.lines().map(|line| line.split(','));
    let names: Vec<&str> = lines.next().unwrap().collect();
    let number = |field: &str| field.parse().unwrap_or(f64::NAN);
    let row = |fields: std::str::Split<'_, char>| {
        let named = names.iter().zip(fields);
        named
            .map(|(name, field)| ((*name).to_owned(), number(field)))
            .collect()
    };
    lines.map(row).collect()
}

/// The clearance of most sites of [`LYING`], mm, and how long the string is, m.
const CLEARANCE: f64 = 52.0;
const DEEPEST: f64 = 72.0;

/// Simulates one method with a film of its beginning and its end.
fn filmed(text: &str, method: &str) -> Workplace {
    let place = Workplace::with_small(&text.replace("finite-element", method));
    let film = ["--film", "--film-from", "0", "--film-frames", "2"];
    let simulated = [&["simulate", "small.toml", "--out", "out"][..], &film].concat();
    let answer = place.answer(&simulated);
    assert_eq!(answer.code, 0, "{method}: {}", answer.errors);
    place
}

/// How far the shapes of a film are at most off a place, mm, at a distance from the bit, m, if they have
/// a node there.
fn off(shapes: &[&HashMap<String, f64>], from_bit: f64, [x, y]: [f64; 2]) -> Option<f64> {
    let depth = DEEPEST - from_bit;
    let here = shapes
        .iter()
        .filter(|row| (row["depth_m"] - depth).abs() < 1e-6);
    let apart = here.map(|row| (row["x_mm"] - x).hypot(row["y_mm"] - y));
    apart.reduce(f64::max)
}

/// How far the string in a film is at most off its sites, how far one of these is out of the middle
/// towards the low side, and how far one goes, mm.
fn at_sites(place: &Workplace) -> [f64; 3] {
    let (history, film) = (
        table(place, "out/history.csv"),
        table(place, "out/film.csv"),
    );
    let [first, last] = [&history[0], history.last().unwrap()];
    let (mut most, mut sites) = ([0.0_f64; 3], 0);
    for name in first.keys() {
        let Some(site) = name.strip_suffix("_x_mm") else {
            continue;
        };
        let from_bit = site.strip_suffix("m_above_bit");
        let from_bit = from_bit.map_or(0.0, |metres| metres.parse().unwrap());
        let at = |row: &HashMap<String, f64>| [row[name], row[&format!("{site}_y_mm")]];
        for row in [first, last] {
            let shape = film.iter().filter(|it| it["time_s"] == row["time_s"]);
            let off = off(&shape.collect::<Vec<_>>(), from_bit, at(row)).unwrap();
            most[0] = most[0].max(off);
            most[1] = most[1].max(-row[name]);
        }
        let ([x, y], [u, v]) = (at(first), at(last));
        most[2] = most[2].max((u - x).hypot(v - y));
        sites += 1;
    }
    assert!(sites >= 13, "{sites}");
    most
}

/// [`LYING`] at rest, as it buckles without its walls, so that springs hold its linear part, and the
/// same with more sites than taps are summed for: its elements are stepped and need none.
fn lying_buckled_and_stepped() -> [String; 3] {
    let lying = LYING.replace("_hz = 400", "_hz = 1600");
    let damping = "damping_ns_m2 = 200";
    let buckled = lying.replace(damping, &format!("{damping}, compression_kn = 200"));
    let stepped = buckled.replace("\"ends\"", "\"all\"\nsites_every_m = 1.5");
    [lying, buckled, stepped]
}

/// What nothing pushes is drawn where it lies: at its sites as its motion has it, between them as
/// `static_string.csv` has it.
#[test]
fn the_whole_string_is_drawn_where_it_lies() {
    let [lying, buckled, stepped] = lying_buckled_and_stepped();
    let methods = ["held", "quadrature", "finite-element"];
    let all = [&lying, &buckled].into_iter();
    let cases = all.flat_map(|text| methods.map(|method| (text, method)));
    for (text, method) in cases.chain([(&stepped, "finite-element")]) {
        let text = text.replace("friction = 0.3", "friction = 0");
        let place = filmed(&text, method);
        let [off_sites, low, _] = at_sites(&place);
        assert!(off_sites < 1e-6 * CLEARANCE, "{method}: {off_sites}");
        assert!(low > 0.9 * CLEARANCE, "{method}: {low}");
        let film = table(&place, "out/film.csv");
        let shapes: Vec<_> = film.iter().collect();
        let mut nodes = 0;
        for row in table(&place, "out/static_string.csv") {
            let there = [row["high_side_mm"], row["right_mm"]];
            let from_bit = row["distance_from_bit_m"];
            if let Some(off) = off(&shapes, from_bit, there) {
                assert!(off < 1e-4 * CLEARANCE, "{method} {from_bit}: {off}");
                nodes += 1;
            }
        }
        assert!(nodes > 60, "{nodes}");
        // No farther from the middle than it is at rest.
        for row in table(&place, "out/string.csv") {
            let node = |shape: &&HashMap<_, _>| shape["depth_m"] == row["depth_m"];
            let shape = film.iter().find(node).unwrap();
            let radius = shape["x_mm"].hypot(shape["y_mm"]);
            let off = (row["peak_radius_mm"] - radius).abs();
            assert!(off < 1e-4 * CLEARANCE, "{method}: {off}");
        }
    }
}

/// One that climbs as it turns is drawn through its sites, whether springs are in its forces or not.
#[test]
fn the_whole_string_is_drawn_through_sites_that_move() {
    for text in lying_buckled_and_stepped() {
        let [off, _, goes] = at_sites(&filmed(&text, "finite-element"));
        assert!(goes > 0.05 * CLEARANCE, "{goes}");
        assert!(off < 1e-6 * CLEARANCE, "{off}");
    }
}

/// Where elements are stepped, for there are many sites, they are stepped once more.
#[test]
fn moments_of_elements_that_are_stepped_are_those_of_another_method() {
    let text = LYING
        .replace(
            "sites = \"ends\"",
            "sites = \"all\"\nsites_every_m = 1.5\nstress_every_m = 2",
        )
        .replace("time_s = 1\n", "time_s = 6\n")
        .replace(
            "[\"finite-element\"]",
            "[\"quadrature\", \"finite-element\"]",
        );
    let rows = rows_of(&Workplace::with_small(&text));
    let [one, other] = [&rows[0], &rows[1]];
    for name in [
        "bending_moment_peak_kn_m",
        "bending_stress_peak_mpa",
        "bending_stress_amplitude_mpa",
        "von_mises_peak_mpa",
    ] {
        let apart = (one(name) / other(name) - 1.0).abs();
        assert!(apart < 5e-3, "{name}: {} {}", one(name), other(name));
    }
    assert_eq!(
        one("bending_stress_from_bit_m"),
        other("bending_stress_from_bit_m")
    );
}

/// An impulse bends a string that hangs and touches nothing, and leaves it straight.
#[test]
fn a_string_that_hangs_is_bent_by_what_pushes_it_alone() {
    let text = |start: f64| {
        LYING
            .replace("inclination_deg = 30\n", "")
            .replace("friction = 0.3", "friction = 0.3\nstress_every_m = 3")
            .replace("damping_ns_m2 = 200", "damping_ns_m2 = 3000")
            .replace("time_s = 1\n", "time_s = 8\n")
            + &format!("[[impulses]]\ndistance_from_bit_m = 11\namount_ns = 5\nstart_s = {start}\n")
    };
    let moments = [1.0, 7.0].map(|start| {
        let rows = rows_of(&Workplace::with_small(&text(start)));
        rows[0]("bending_moment_peak_kn_m")
    });
    assert!(
        moments[1] > 0.1 && moments[0] < 1e-2 * moments[1],
        "{moments:?}"
    );
}

/// What begins in steady sliding stays there; what only turns climbs first.
#[test]
fn a_string_that_lies_begins_at_rest_turning_or_sliding() {
    let greatest = |start: &str| {
        let text = format!(
            "start = \"{start}\"\n{}",
            LYING.replace("time_s = 1\n", "time_s = 4\n")
        );
        let place = Workplace::with_small(&text);
        let run = place.sweep(&["run", "small.toml", "--out", "out"]);
        assert_eq!(run.code, 0, "{run:?}");
        let table = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
        let mut lines = table.lines();
        let names: Vec<&str> = lines.next().unwrap().split(',').collect();
        let at = names.iter().position(|it| *it == "greatest_angle_deg");
        let row: Vec<&str> = lines.next().unwrap().split(',').collect();
        row[at.unwrap()].parse::<f64>().unwrap()
    };
    let [sliding, turning, resting] = ["smooth", "turning", "ramp"].map(greatest);
    let slides = 0.3f64.atan().to_degrees();
    assert!(sliding < 1.5 * slides, "{sliding}");
    // Without damping it would go twice as far as it slides.
    assert!(
        turning > 1.5 * slides && resting > 1.2 * slides,
        "{turning} {resting}"
    );
}

#[test]
fn what_does_not_go_with_a_string_that_lies_is_refused_by_its_key() {
    for (text, key, says) in [
        (
            format!("{LYING}[[impulses]]\ndistance_from_bit_m = 0\nratio = 2\n"),
            "impulses[0].ratio",
            "amount_ns",
        ),
        (
            LYING
                .replace("inclination_deg = 30\n", "")
                .replace("\"ends\"", "\"ends\"\nlies_on_low_side = true"),
            "wall.lies_on_low_side",
            "well.inclination_deg",
        ),
        (
            format!(
                "start = \"turning\"\n{}",
                LYING.replace("inclination_deg = 30\n", "")
            ),
            "start",
            "needs a table [bit]",
        ),
        (
            LYING.replace("\"ends\"", "\"ends\"\nshock_g = -1"),
            "wall.shock_g",
            "g",
        ),
        (
            LYING.replace("\"ends\"", "\"ends\"\nstress_every_m = 0.01"),
            "wall.stress_every_m",
            "m",
        ),
        (
            LYING
                .replace("repeat = 6", "repeat = 60")
                .replace("\"ends\"", "\"ends\"\nstress_every_m = 0.5"),
            "wall.stress_every_m",
            "at most 500",
        ),
        (
            LYING.replace("sites = \"ends\"", "stress_every_m = 5"),
            "wall.stress_every_m",
            "needs a site above the bit",
        ),
        (
            LYING.replace("surface_speed_rpm = 60\n", "")
                + DESIGN
                + "surface_speed_rpm = { values = [60, 90] }\n[map]\ncolour = \"von_mises_peak_mpa\"\n",
            "map.colour",
            "stress_every_m",
        ),
        (
            LYING.replace("finite-element", "hilbert"),
            "methods[0]",
            "slow tail",
        ),
        (
            LYING.replace("inclination_deg = 30", "inclination_deg = 200"),
            "well.inclination_deg",
            "180",
        ),
    ] {
        let place = Workplace::with_small(&text);
        let refused = place.answer(&["run", "small.toml", "--dry-run"]);
        assert_ne!(refused.code, 0, "{key}");
        assert!(
            refused.errors.contains(&format!("`{key}`")),
            "{key}: {}",
            refused.errors
        );
        assert!(refused.errors.contains(says), "{key}: {}", refused.errors);
    }
}
