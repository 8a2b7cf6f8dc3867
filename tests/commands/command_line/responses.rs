//! `sweep inspect --csv`: taps and frequency responses.

use linear::Complex64;

use crate::command_line::{succeeds, table, text};
use crate::support::{SMALL, Workplace, with};

const LENGTH: f64 = 100.0;

/// A uniform pipe of 100 m, observed and turned at its lower end.
fn uniform() -> String {
    let (before, rest) = SMALL.split_once("[[string.sections]]").unwrap();
    let (_, after) = rest.split_once("]\n\n").unwrap();
    let section = "[[string.sections]]\nrepeat = 10\n\
                   parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]\n\n";
    let text = format!("{before}{section}{after}");
    with(&text, "distance_from_bit_m = 50", "distance_from_bit_m = 0")
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// The rows of a table whose first columns are these, without them.
fn rows_of(table: &[Vec<String>], start: &[&str]) -> Vec<Vec<f64>> {
    let is_meant = |row: &&Vec<String>| row.iter().zip(start).all(|(one, other)| one == other);
    let rows = table.iter().filter(is_meant);
    rows.map(|row| row[start.len()..].iter().map(|it| number(it)).collect())
        .collect()
}

/// 1/cos(kL), with k² = (ρJω² − icω)/GJ, of a bar that is free at its lower end.
fn exact(frequency: f64) -> Complex64 {
    let rate = std::f64::consts::TAU * frequency;
    let polar = 0.5 * std::f64::consts::PI * (0.1_f64.powi(4) - 0.05_f64.powi(4));
    let square = Complex64::new(7840.0 * polar * rate * rate, -10.0 * rate) / (80e9 * polar);
    (square.sqrt() * LENGTH).cos().inv()
}

#[test]
fn tables_of_responses_agree_with_one_another_and_with_a_uniform_bar() {
    let place = Workplace::with_small(&uniform());
    succeeds(
        &place,
        &["inspect", "small.toml", "--csv", "--out", "looked"],
    );
    let [taps, frequencies] = ["taps", "frequency_responses"]
        .map(|name| table(&text(&place, &format!("looked/{name}.csv"))));
    let turned = ["torsion", "surface_speed", "", "0", "1"];
    let of = |method| [&[method][..], &turned].concat();

    let exact_rows = rows_of(&frequencies, &of("exact"));
    assert_eq!(exact_rows.len(), 2000);
    for row in exact_rows.iter().step_by(37) {
        let (given, bar) = (Complex64::new(row[1], row[2]), exact(row[0]));
        assert!((given - bar).norm() < 1e-9 * bar.norm(), "{row:?} {bar}");
    }

    // In the end the bit turns as the surface does.
    let taps_rows = rows_of(&taps, &of("quadrature"));
    let sum: f64 = taps_rows.iter().map(|row| row[2]).sum();
    assert!((sum - 1.0).abs() < 1e-2, "{sum}");
    assert_eq!(taps_rows[150][..2], [150.0, 1.5]);

    // Term by term, from what is written of the taps.
    let by_method = rows_of(&frequencies, &of("quadrature"));
    for row in by_method.iter().step_by(211) {
        let term = |tap: &Vec<f64>| {
            Complex64::from_polar(tap[2], -std::f64::consts::TAU * row[0] * tap[1])
        };
        let sum: Complex64 = taps_rows.iter().map(term).sum();
        let given = Complex64::new(row[1], row[2]);
        assert!((sum - given).norm() < 1e-9, "{row:?} {sum}");
    }
    for (name, columns) in [("modes", 4), ("critical_speeds", 5), ("mode_shapes", 4)] {
        let rows = table(&text(&place, &format!("looked/{name}.csv")));
        assert!(rows.len() > 1 || name == "critical_speeds", "{name}");
        assert_eq!(rows[0].len(), columns, "{name}");
    }
}

/// A force of a wall at a separate site, and a torque of the bit: each with its unit.
#[test]
fn every_response_of_a_scene_is_there_with_its_unit() {
    let wall = "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n\
                [wall]\nclearance_mm = 15\nstiffness_gn_m15 = 1\nfriction = 0.3\n\n[[sites]]";
    let sweep = with(&uniform(), "[[sites]]", wall);
    let place = Workplace::with_small(&sweep);
    let answer = place.sweep(&["inspect", "small.toml", "--csv", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    for name in ["taps", "frequency_responses"] {
        let rows = table(&text(&place, &format!("looked/{name}.csv")));
        for start in [
            ["quadrature", "torsion", "surface_speed", "", "0", "1"],
            ["quadrature", "torsion", "torque", "0", "0", "rad/(s N m)"],
        ] {
            assert!(!rows_of(&rows, &start).is_empty(), "{name}: {start:?}");
        }
    }
    let exact = table(&text(&place, "looked/frequency_responses.csv"));
    let force = ["exact", "bending", "force", "0", "0", "m/N"];
    assert!(!rows_of(&exact, &force).is_empty());
}
