//! Accuracy against speed: a part of the study, small enough for every day.

use std::collections::{BTreeMap, BTreeSet};

use crate::support::Workplace;

type Row = BTreeMap<String, String>;

fn rows(place: &Workplace) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(place.path("out/tradeoff.csv")).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

/// The error of a method at a frequency, of its first parameters in the table
/// that are not excluded.
fn error(rows: &[Row], measure: &str, method: &str, frequency: &str) -> f64 {
    let is_it = |row: &&Row| {
        row["measure"] == measure
            && row["method"] == method
            && row["sampling_frequency_hz"] == frequency
            && ["", "0.52"].contains(&row["gamma"].as_str())
            && ["", "20"].contains(&row["elements_per_cell"].as_str())
            && ["", "20"].contains(&row["transform_s"].as_str())
    };
    let row = rows.iter().find(is_it).unwrap();
    row["relative_error"].parse().unwrap()
}

#[test]
fn val_a_part_of_the_study_finds_every_method_where_theory_has_it() {
    let place = Workplace::new();
    // One is named twice.
    let measures = "surface_step,static_stiffness_nm_rad,lateral_impulse,whirl_normal_force_n,\
        surface_step";
    let ladder = [
        "study",
        "tradeoff",
        "--ladder",
        "640,160,320",
        "--out",
        "out",
    ];
    let answer = place.sweep(&[&ladder[..], &["--measures", measures]].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    for said in ["10 %", "1 %", "0.1 %"].map(|part| format!("cheapest within {part}")) {
        assert!(answer.output.contains(&said), "{answer:?}");
    }
    let orders = "observed orders of convergence";
    assert!(answer.output.contains(orders), "{answer:?}");
    let is_narrow = |line: &str| line.chars().count() <= 80;
    assert!(answer.output.lines().all(is_narrow), "{answer:?}");
    let rows = rows(&place);
    let columns = [
        "measure",
        "method",
        "gamma",
        "elements_per_cell",
        "transform_s",
        "sampling_frequency_hz",
    ];
    let different: BTreeSet<[&String; 6]> = (rows.iter())
        .map(|row| columns.map(|name| &row[name]))
        .collect();
    assert_eq!(different.len(), rows.len());
    let of = |measure, method, frequency| error(&rows, measure, method, frequency);
    // Within its band the digital filter is exact; the others have their order.
    assert!(of("surface_step", "hilbert", "640") < 1e-5);
    for method in ["quadrature", "held", "finite-element", "radau-quadrature"] {
        let [coarse, fine] = ["320", "640"].map(|rung| of("surface_step", method, rung));
        let falls = fine < 0.6 * coarse && fine > 1e-5;
        assert!(falls, "{method}: {coarse} {fine}");
    }
    // Static limits are exact, but for what a finite transform folds back.
    assert!(of("static_stiffness_nm_rad", "quadrature", "160") < 1e-6);
    assert!(of("static_stiffness_nm_rad", "finite-element", "160") < 1e-6);
    assert!(of("static_stiffness_nm_rad", "held", "160") < 1e-6);
    // In bending the filter loses the slow tail.
    assert!(of("lateral_impulse", "hilbert", "640") > 0.3);
    assert!(of("lateral_impulse", "quadrature", "640") < 0.01);
    let held = ["320", "640"].map(|rung| of("lateral_impulse", "held", rung));
    assert!((held[0] / held[1] - 4.0).abs() < 0.5, "{held:?}");
    // Steady whirl is what the balance of forces says.
    assert!(of("whirl_normal_force_n", "quadrature", "640") < 2e-3);
    assert!(of("whirl_normal_force_n", "held", "640") < 2e-3);
    for file in ["out/tradeoff.svg", "out/tradeoff.png"] {
        assert!(place.path(file).exists());
    }
    // Nothing on the front is beaten by another of its measure; what is rounding is no
    // difference.
    let number = |row: &Row, key: &str| row[key].parse::<f64>().unwrap_or(f64::INFINITY);
    let error = |row: &Row| number(row, "relative_error").max(1e-7);
    let on_front: Vec<&Row> = rows.iter().filter(|row| row["on_front"] == "yes").collect();
    for row in &on_front {
        let is_beaten = on_front.iter().any(|other| {
            other["measure"] == row["measure"]
                && number(other, "cost_1000_cases_s") < number(row, "cost_1000_cases_s")
                && error(other) < 0.5 * error(row)
        });
        assert!(!is_beaten, "{row:?}");
    }
}

/// Filters and elements let fronts overshoot in steps of any length; loads that are held
/// do not.
#[test]
fn val_on_a_uniform_tube_fronts_are_sharp_by_held_alone() {
    let place = Workplace::new();
    let measure = "tube_undershoot_rad_s_nm";
    let study = [
        "study", "tradeoff", "--quiet", "--ladder", "160,320", "--out", "out",
    ];
    let answer = place.sweep(&[&study[..], &["--measures", measure]].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    let rows = rows(&place);
    for rung in ["160", "320"] {
        let of = |method| error(&rows, measure, method, rung);
        assert!(of("held") < 6e-3);
        for method in ["quadrature", "finite-element"] {
            assert!(of(method) > 0.3, "{method}");
        }
        assert!(of("hilbert") > 0.1);
    }
    // Within 1 % is nothing else.
    for row in rows.iter().filter(|row| row["on_front"] == "yes") {
        let error: f64 = row["relative_error"].parse().unwrap();
        assert!(row["method"] == "held" || error > 0.1, "{row:?}");
    }
}

#[test]
fn an_invalid_ladder_or_measure_is_refused() {
    let place = Workplace::new();
    for (arguments, said) in [
        (["--ladder", "160,250"], "160 Hz is not between"),
        (["--ladder", "1,2"], "1 Hz is not between"),
        (["--measures", "colour"], "unknown measure `colour`; known"),
        (
            ["--in-mud", "--measures=tube_undershoot_rad_s_nm"],
            "--in-mud: tube_undershoot_rad_s_nm has no reference in mud",
        ),
    ] {
        let answer = place.sweep(&["study", "tradeoff", arguments[0], arguments[1]]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(said), "{answer:?}");
        assert!(!place.path("results").exists());
    }
}
