//! `surface_torque = true`: what turns the surface, measured in every case.

use std::collections::HashMap;
use std::f64::consts::TAU;
use std::path::Path;

use crate::support::{SMALL, Workplace, with};

const COLUMNS: [&str; 4] = [
    "surface_torque_peak_nm",
    "surface_torque_least_nm",
    "surface_torque_mean_nm",
    "surface_torque_greatest_nm",
];

/// The rows of a table, by the names of its columns.
fn rows(table: &str) -> Vec<HashMap<&str, &str>> {
    let mut lines = table.lines().map(|line| line.split(','));
    let header: Vec<&str> = lines.next().unwrap().collect();
    let row = |line| header.iter().copied().zip(line).collect();
    lines.map(row).collect()
}

fn number(row: &HashMap<&str, &str>, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// The small sweep, slow speeds in which the bit sticks and fast ones, with the key.
fn measured() -> String {
    format!("surface_torque = true\n{SMALL}")
}

fn labels(text: &str, more: &[&str]) -> String {
    let place = Workplace::with_small(text);
    run(&place, more);
    std::fs::read_to_string(place.path("out/labels.csv")).unwrap()
}

fn run(place: &Workplace, more: &[&str]) {
    let arguments = ["run", "small.toml", "--out", "out", "--quiet"];
    let answer = place.sweep(&[&arguments, more].concat());
    assert_eq!(answer.code, 0, "{}", answer.errors);
}

/// Momentum in, momentum out: a bit that turns evenly takes its torque and the string its
/// damping; and one that sticks is torn loose by more than its static torque.
#[test]
fn val_a_bit_that_turns_evenly_takes_its_torque_and_the_string_its_damping() {
    // Long enough for the start to be over in the closing window.
    let table = labels(&with(&measured(), "time_s = 12", "time_s = 60"), &[]);
    let (mut turning, mut sticking) = (0, 0);
    for row in rows(&table) {
        let [peak, least, mean, greatest] = COLUMNS.map(|column| number(&row, column));
        assert!(least <= mean && mean <= greatest && greatest <= peak);
        let cuts = number(&row, "torque_dynamic_nm");
        let speed = number(&row, "surface_speed_rpm") * TAU / 60.0;
        let even = cuts + 10.0 * 100.0 * speed;
        if row["torsion"] == "smooth" {
            turning += 1;
            assert!((mean / even - 1.0).abs() < 2e-3, "{mean} {even}");
        } else {
            sticking += 1;
            assert!(
                greatest > 1.05 * even && least < 0.95 * even,
                "{least} {greatest} {even}"
            );
        }
    }
    assert!(turning > 1 && sticking > 1, "{turning} {sticking}");
}

/// Measuring it changes no label and no other measure; and no number of threads,
/// no shard and no interruption changes a byte.
#[test]
fn it_changes_nothing_else_and_does_not_depend_on_how_it_was_run() {
    let table = labels(&measured(), &[]);
    let full = labels(SMALL, &["--full"]);
    for (line, without) in table.lines().zip(full.lines()) {
        assert!(line.starts_with(without), "{line}\n{without}");
    }
    assert_eq!(labels(&measured(), &["--jobs", "1"]), table);
    let cases = |count: usize| {
        let design = format!("[design]\nkind = \"monte-carlo\"\nseed = 5\ncases = {count}\n");
        let axes = "[design.axes]\nsurface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                    weight_on_bit_kn = { from = 30, to = 70 }\n";
        let text = format!("{}{axes}", crate::support::small_with_design(&design));
        format!("surface_torque = true\n{text}")
    };
    let place = Workplace::with_small(&cases(3));
    run(&place, &[]);
    place.write("small.toml", cases(7));
    run(&place, &[]);
    let grown = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    assert_eq!(grown, labels(&cases(7), &[]));
}

/// Backward whirl rolls on the wall and slows the string: the surface makes up for that.
#[test]
fn val_a_bit_that_whirls_takes_the_torque_of_its_wall() {
    let sweeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    let base = sweeps.join("fig12.toml").display().to_string();
    let place = Workplace::new();
    place.write(
        "whirl.toml",
        format!(
            "base = {base:?}\nsurface_torque = true\ntime_s = 20\nmethods = [\"quadrature\"]\n"
        ),
    );
    let answer = place.sweep(&["simulate", "whirl.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let read = |name: &str| std::fs::read_to_string(place.path("out").join(name)).unwrap();
    let (history, case) = (read("history.csv"), read("case.csv"));
    let row = rows(&case).remove(0);
    assert_eq!(row["lateral"], "backward_whirl");
    assert!(read("history.svg").contains("Torque at surface"));
    let torques: Vec<f64> = (rows(&history).iter())
        .filter(|row| number(row, "time_s") > 18.0)
        .map(|row| {
            let [x, y] = ["bit_x_mm", "bit_y_mm"].map(|column| number(row, column));
            let forces = ["bit_wall_force_x_n", "bit_wall_force_y_n"];
            let [fx, fy] = forces.map(|column| number(row, column));
            // The collars' radius, 0.15 m.
            0.15 * (x * fy - y * fx) / x.hypot(y)
        })
        .collect();
    let of_wall = torques.iter().sum::<f64>() / torques.len() as f64;
    // c_t L of the paper's string is 10 000 N m s/rad.
    let expected = 1e4 * TAU - of_wall;
    let mean = number(&row, "surface_torque_mean_nm");
    assert!(of_wall < -1000.0, "{of_wall}");
    assert!((mean / expected - 1.0).abs() < 2e-3, "{mean} {expected}");
}

/// A rotor at a prescribed speed, which shows in no bit's motion, may be given where its torque is
/// measured; its recorded torque may be held against any motion's.
#[test]
fn val_a_rotor_takes_its_inertia_times_its_acceleration() {
    let peak = |inertia: f64| {
        let rise = "surface_torque = true\nsurface_speed_rise_s = 2\n";
        let drive =
            format!("[top_drive]\ncontroller = \"prescribed\"\ninertia_kg_m2 = {inertia}\n\n[bit]");
        let text = with(&format!("{rise}{SMALL}"), "[bit]", &drive);
        let table = labels(&text, &[]);
        let fastest = rows(&table).into_iter().last().unwrap();
        let speed = number(&fastest, "surface_speed_rpm") * TAU / 60.0;
        (number(&fastest, "surface_torque_peak_nm"), 0.5 * speed)
    };
    let ([light, heavy], acceleration) = ([peak(0.0).0, peak(1e6).0], peak(0.0).1);
    assert!(heavy - light > 0.0, "{light} {heavy}");
    let added = (heavy - light) / (1e6 * acceleration);
    // The peak without a rotor may be after its rise.
    assert!((0.5..1.01).contains(&added), "{added}");
}
