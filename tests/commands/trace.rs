//! Traced limits: the cases that a grid would have, fewer of them, and where the limits are.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Stdio;

use crate::support::{Workplace, small_with_design, with};

const TRACE: &str = "[design]\nkind = \"trace\"\ntolerance = 0.02\n[design.axes]\n\
                     surface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                     weight_on_bit_kn = { from = 5, to = 100 }\n";

const GRID: &str = "[design]\nkind = \"grid\"\n[design.axes]\n\
                    surface_speed_rpm = { from = 0.02, to = 0.6, count = 65 }\n\
                    weight_on_bit_kn = { from = 5, to = 100, count = 65 }\n";

fn small(design: &str) -> String {
    let two = "methods = [\"quadrature\", \"finite-element\"]";
    with(
        &small_with_design(design),
        "methods = [\"quadrature\"]",
        two,
    )
}

#[track_caller]
fn run(place: &Workplace, file: &str, folder: &str, more: &[&str]) -> String {
    let arguments = [&["run", file, "--out", folder], more].concat();
    let answer = place.sweep(&arguments);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    answer.output
}

fn read(place: &Workplace, name: &str) -> String {
    std::fs::read_to_string(place.path(name)).unwrap()
}

/// The cells of a row, by the names of their columns.
type Row = BTreeMap<String, String>;

fn rows(table: &str) -> Vec<Row> {
    let mut lines = table.lines().map(|line| line.split(','));
    let header: Vec<&str> = lines.next().unwrap().collect();
    let row = |line: std::str::Split<char>| {
        let cells = header.iter().zip(line);
        cells
            .map(|(name, cell)| ((*name).to_owned(), cell.to_owned()))
            .collect()
    };
    lines.map(row).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// Fig. 9 by two methods, as coarse as these designs.
fn fig09(design: &str) -> String {
    let base = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig09.toml");
    format!("base = {base:?}\nmethods = [\"quadrature\", \"held\"]\n{design}")
}

/// A traced sweep and the grid that it chooses from.
struct Both {
    traced: String,
    limits: Vec<Row>,
    bands: Vec<Row>,
    grid: String,
}

impl Both {
    fn run(trace: &str, grid: &str) -> Self {
        let place = Workplace::with_small(trace);
        place.write("grid.toml", grid);
        let reported = run(&place, "small.toml", "traced", &[]);
        assert!(
            reported.contains("cases of the equivalent grid, 4225"),
            "{reported}"
        );
        run(&place, "grid.toml", "grid", &["--quiet"]);
        Self {
            traced: read(&place, "traced/labels.csv"),
            limits: rows(&read(&place, "traced/limits.csv")),
            bands: rows(&read(&place, "traced/bands.csv")),
            grid: read(&place, "grid/labels.csv"),
        }
    }

    /// The regimes of the grid by method, speed and weight.
    fn regimes(&self) -> BTreeMap<(String, usize, usize), String> {
        let of_row = |row: Row| {
            let case: usize = row["case"].parse().unwrap();
            let key = (row["method"].clone(), case / 65, case % 65);
            (key, row["torsion"].clone())
        };
        rows(&self.grid).into_iter().map(of_row).collect()
    }
}

/// How many steps of the grid a speed and a weight are from its corner.
fn steps(speed: f64, weight: f64) -> [f64; 2] {
    [64.0 * (speed - 0.02) / 0.58, 64.0 * (weight - 5.0) / 95.0]
}

#[test]
fn a_trace_has_rows_of_the_grid_and_its_lines_part_regimes() {
    let both = Both::run(&fig09(TRACE), &fig09(GRID));
    let of_grid: BTreeSet<&str> = both.grid.lines().collect();
    assert!(both.traced.lines().all(|row| of_grid.contains(row)));
    let part = both.traced.lines().count() as f64 / of_grid.len() as f64;
    assert!(part < 0.3, "{part}");

    // Each point of a line is between two neighbours of the grid that differ.
    let regimes = both.regimes();
    assert!(both.limits.len() > 50);
    for point in &both.limits {
        let of = |column: &str| number(point, column);
        let [x, y] = steps(of("surface_speed_rpm"), of("weight_on_bit_kn"));
        let regime = |x: f64, y: f64| {
            let place = [x, y].map(|steps| steps.round() as usize);
            &regimes[&(point["method"].clone(), place[0], place[1])]
        };
        let is_along_speed = of("surface_speed_rpm_within") > 0.0;
        let [dx, dy] = if is_along_speed {
            [0.5, 0.0]
        } else {
            [0.0, 0.5]
        };
        assert_ne!(regime(x - dx, y - dy), regime(x + dx, y + dy), "{point:?}");
        let within = of("surface_speed_rpm_within") + of("weight_on_bit_kn_within");
        let half_step = if is_along_speed { 0.58 } else { 95.0 } / 128.0;
        assert!((within - half_step).abs() < 1e-9 * half_step, "{point:?}");
    }
    // A line of each method, and nothing is ragged.
    let lines = both
        .limits
        .iter()
        .map(|point| [&point["method"][..], &point["line"]]);
    let lines: BTreeSet<_> = lines.collect();
    assert_eq!(lines, BTreeSet::from([["held", "0"], ["quadrature", "0"]]));
    assert!(both.bands.is_empty());
}

/// A short string without joints to speak of: from rest chance decides near its limit.
#[test]
fn the_parts_of_tiles_are_those_of_the_grid_where_a_limit_is_ragged() {
    let from_rest = |design| format!("start = \"ramp\"\n{}", small(design));
    let both = Both::run(&from_rest(TRACE), &from_rest(GRID));
    let regimes = both.regimes();
    assert!(both.bands.len() > 20);
    let (mut off, mut points) = (0.0, 0.0);
    for band in &both.bands {
        let of = |column: &str| number(band, column);
        let from = steps(of("surface_speed_rpm_from"), of("weight_on_bit_kn_from"));
        let to = steps(of("surface_speed_rpm_to"), of("weight_on_bit_kn_to"));
        let [x, y] = [0, 1].map(|axis| from[axis].round() as usize..to[axis].round() as usize);
        let places = x.flat_map(|x| y.clone().map(move |y| (x, y)));
        let labels = places.map(|(x, y)| &regimes[&(band["method"].clone(), x, y)]);
        let labels: Vec<_> = labels.filter(|label| *label != "stuck").collect();
        let with = labels
            .iter()
            .filter(|label| **label == "stick_slip")
            .count();
        let part = with as f64 / labels.len() as f64;
        assert!(of("low") <= of("part") && of("part") <= of("high"));
        off += (of("part") - part) * labels.len() as f64;
        points += labels.len() as f64;
    }
    assert!((off / points).abs() < 0.01, "{}", off / points);
}

#[test]
fn threads_and_stops_do_not_change_a_trace() {
    let place = Workplace::with_small(&small(TRACE));
    run(&place, "small.toml", "whole", &["--quiet", "--jobs", "1"]);
    let mut stops = 0;
    for attempt in 1..20 {
        let arguments = [
            "run",
            "small.toml",
            "--quiet",
            "--out",
            "stopped",
            "--jobs",
            "2",
        ];
        let mut child = (place.command(&arguments))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(20 * attempt));
        child.kill().unwrap();
        child.wait().unwrap();
        if place.path("stopped/manifest.json").exists() {
            break;
        }
        stops += 1;
        if place.path("stopped/cases.log").exists() {
            // What is done can be summarised.
            let answer = place.sweep(&["summary", "stopped"]);
            assert!(matches!(answer.code, 0 | 2), "{}", answer.errors);
        }
    }
    assert!(stops > 2, "only {stops} stops");
    run(&place, "small.toml", "stopped", &["--quiet"]);
    for name in [
        "labels.csv",
        "limits.csv",
        "bands.csv",
        "boundary.csv",
        "map.svg",
    ] {
        let [whole, stopped] =
            ["whole", "stopped"].map(|folder| read(&place, &format!("{folder}/{name}")));
        assert!(whole == stopped, "{name}");
    }
}

#[test]
fn what_follows_from_the_labels_is_made_again() {
    let place = Workplace::with_small(&small(TRACE));
    run(&place, "small.toml", "out", &["--quiet"]);
    let [whole, bands] = ["limits", "bands"].map(|name| read(&place, &format!("out/{name}.csv")));
    place.write("out/limits.csv", "method\n");
    std::fs::remove_file(place.path("out/bands.csv")).unwrap();
    let answer = place.sweep(&["run", "small.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    assert!(answer.errors.contains("limits.csv"), "{}", answer.errors);
    assert_eq!(read(&place, "out/limits.csv"), whole);
    assert_eq!(read(&place, "out/bands.csv"), bands);
}

/// Its cases lie along limits.
#[test]
fn fractions_of_a_trace_are_not_counted() {
    let place = Workplace::with_small(&small(TRACE));
    run(&place, "small.toml", "out", &["--quiet"]);
    let answer = place.sweep(&["analyse", "out"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("bands.csv"), "{answer:?}");
}

/// An axis of the string together with one that is not: a linear system for each of its values.
#[test]
fn a_trace_may_go_over_the_string_itself() {
    let design = with(
        TRACE,
        "surface_speed_rpm = { from = 0.02, to = 0.6 }",
        "torsional_damping_nms_rad_m = { from = 2, to = 200, count = 3, spacing = \"log\" }",
    );
    let text = with(
        &with(
            &small(&design),
            "surface_speed_rpm = 60",
            "surface_speed_rpm = 0.25",
        ),
        "tolerance = 0.02",
        "tolerance = 0.1",
    );
    let place = Workplace::with_small(&text);
    run(&place, "small.toml", "out", &["--quiet"]);
    let lines = rows(&read(&place, "out/limits.csv"));
    assert!(!lines.is_empty());
    let values = lines
        .iter()
        .map(|point| number(point, "torsional_damping_nms_rad_m"));
    let values: Vec<f64> = values.collect();
    assert!(values.iter().all(|value| (2.0..=200.0).contains(value)));
}

#[test]
fn before_it_is_run_a_trace_tells_what_it_may_take() {
    let place = Workplace::with_small(&small(TRACE));
    let reported = run(&place, "small.toml", "out", &["--dry-run"]);
    for words in ["a trace (from 81 cases on", "grid of 65 × 65", "perhaps "] {
        assert!(reported.contains(words), "no {words:?} in {reported}");
    }
    assert!(!place.path("out").exists());
}
