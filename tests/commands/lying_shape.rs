//! How a string that lies in its hole, or hangs, is bent and stressed as it moves, and where it is drawn.

use std::collections::HashMap;

use serde_json::Value;

use crate::lying::{LYING, rows_of};
use crate::support::Workplace;

/// The string with the sites at its ends given one by one: so it touches there alone at rest, too, and not
/// between them, as it moves.
fn with_given_sites() -> String {
    let site = |distance: u32| format!("[[sites]]\ndistance_from_bit_m = {distance}\n");
    let sites = [11, 13, 22, 23, 32, 33, 42, 43, 52, 53, 62, 63].map(site);
    LYING.replace("sites = \"ends\"\n", "") + &sites.concat()
}

/// Without friction it turns as it lies, so that it is bent as `inspect` says, by every method: once a
/// turn each point of its surface is stretched as much as it is pressed.
#[test]
fn a_string_that_turns_as_it_lies_is_bent_and_stressed_as_at_rest() {
    let text = with_given_sites()
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

/// [`LYING`] at rest, with its sites given, as it buckles without its walls, so that springs hold its linear part, and the
/// same with more sites than taps are summed for: its elements are stepped and need none.
fn lying_buckled_and_stepped() -> [String; 3] {
    let lying = with_given_sites().replace("_hz = 400", "_hz = 1600");
    let damping = "damping_ns_m2 = 200";
    let buckled = lying.replace(damping, &format!("{damping}, compression_kn = 200"));
    let all = "friction = 0.3\nsites = \"all\"\nsites_every_m = 1.5";
    let stepped = buckled.replace("friction = 0.3", all);
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
