//! `sweep simulate`, `sweep inspect` and `sweep plot`.

use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};
use crate::{columns, is_png, names, names_in, run, succeeds, table, text};

#[test]
fn simulate_writes_the_history_of_one_case() {
    let place = Workplace::with_small(SMALL);
    let arguments = ["simulate", "small.toml", "--out", "case"];
    let answer = succeeds(&place, &arguments);
    assert!(answer.output.contains("Ω = 0.0200 rpm"), "{answer:?}");
    assert_eq!(
        names_in(&place, "case"),
        names(["case.csv", "history.csv", "history.png", "history.svg"])
    );
    is_png(&place, "case/history.png");
    let history = table(&text(&place, "case/history.csv"));
    assert_eq!(
        history[0],
        [
            "case",
            "method",
            "time_s",
            "50m_above_bit_speed_rpm",
            "bit_speed_rpm",
            "torque_on_bit_nm"
        ]
    );
    let times = columns(&history, ["method", "time_s"]);
    assert_eq!(times[0], ["quadrature", "0"]);
    assert_eq!(times[1], ["quadrature", "0.01"]);
    assert!((1200..=1201).contains(&times.len()), "{}", times.len());
}

#[test]
fn simulate_picks_a_case_and_sets_its_axes() {
    let place = Workplace::with_small(SMALL);
    let history = |options: &[&str], expected: &str| {
        let answer = succeeds(
            &place,
            &[&["simulate", "small.toml", "--out", "case"], options].concat(),
        );
        assert!(answer.output.starts_with(expected), "{answer:?}");
        let history = table(&text(&place, "case/history.csv"));
        columns(&history, ["time_s", "bit_speed_rpm", "torque_on_bit_nm"])
            .concat()
            .concat()
    };
    let last = history(&["--case", "5"], "Ω = 0.6000 rpm, T_d = ");
    let set = [
        "--set",
        "surface_speed_rpm=0.6",
        "--set",
        "weight_on_bit_kn=70",
    ];
    assert_eq!(history(&set, "Ω = 0.6000 rpm, T_d = "), last);
    assert_eq!(
        history(&[&["--case", "3"], &set[..2]].concat(), "Ω = 0.6000 rpm"),
        last
    );
    let torque = ["--set", "torque_dynamic_nm=1000"];
    assert_ne!(history(&torque, "Ω = 0.0200 rpm, T_d = 1000.0 N m"), last);
}

#[test]
fn several_cases_are_kept_beside_each_other() {
    let place = Workplace::with_small(SMALL);
    let arguments = ["simulate", "small.toml", "--out", "case", "--case", "5,0,5"];
    let answer = succeeds(&place, &arguments);
    let expected = ["Ω = 0.6000 rpm", "Ω/rpm = 0.6, W/kN = 70, quadrature: "];
    for word in expected {
        assert!(answer.output.contains(word), "{answer:?}");
    }
    let history = table(&text(&place, "case/history.csv"));
    let mut cases = columns(&history, ["case"]);
    cases.dedup();
    assert_eq!(cases, [["5"], ["0"]]);
    let beyond = ["simulate", "small.toml", "--case", "0,6"];
    refused(&place, &beyond, &["--case 6: small.toml has cases 0 to 5"]);
}

/// Where the time follows from the case, each is drawn and kept for as long as it lasts.
#[test]
fn cases_of_different_length_are_kept_beside_each_other() {
    // From rest they wait for their first slip, the longer the slower the surface turns.
    let place = Workplace::with_small(&with(SMALL, "time_s = 12\n", "start = \"ramp\"\n"));
    let steps = |cases: &str| {
        let arguments = ["simulate", "small.toml", "--out", "case", "--case", cases];
        succeeds(&place, &arguments);
        let history = table(&text(&place, "case/history.csv"));
        let mut counts: Vec<(String, usize)> = Vec::new();
        for row in columns(&history, ["case"]) {
            match counts.last_mut() {
                Some((case, count)) if *case == row[0] => *count += 1,
                _ => counts.push((row[0].to_string(), 1)),
            }
        }
        counts
    };
    let slow_first = steps("0,5");
    assert!(slow_first[0].1 > 2 * slow_first[1].1, "{slow_first:?}");
    let fast_first = steps("5,0");
    assert_eq!(
        [&fast_first[1], &fast_first[0]],
        [&slow_first[0], &slow_first[1]]
    );
}

#[test]
fn inspect_shows_the_linear_system() {
    let place = Workplace::with_small(SMALL);
    let answer = succeeds(&place, &["inspect", "small.toml", "--out", "linear"]);
    for word in [
        "100.000 m",
        "k_eff",
        "travel time",
        "100.00 Hz (given in the sweep file)",
    ] {
        assert!(answer.output.contains(word), "no {word:?} in {answer:?}");
    }
    // GJ/L of nine metres and a half and of half a metre, ten times in series:
    // 80 GPa × π/2 / 10 / Σ L/(R⁴ − r⁴).
    let stiffness = 80e9 * std::f64::consts::FRAC_PI_2
        / 10.0
        / (9.5 / (0.125f64.powi(4) - 0.05f64.powi(4)) + 0.5 / (0.15f64.powi(4) - 0.04f64.powi(4)));
    let shown = format!("k_eff  {stiffness:.1} N m/rad");
    assert!(answer.output.contains(&shown), "no {shown:?} in {answer:?}");
    assert_eq!(
        names_in(&place, "linear"),
        names(["inspect.csv", "inspect.png", "inspect.svg"])
    );
    is_png(&place, "linear/inspect.png");
}

#[test]
fn plot_draws_the_same_map_again() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    let before = place.files();
    for picture in ["map.svg", "map.png"] {
        std::fs::remove_file(place.path(&format!("results/{picture}"))).unwrap();
    }
    let answer = succeeds(&place, &["plot", "results"]);
    assert_eq!(answer.output, "results/map.png\n");
    assert!(place.files() == before);
}

#[test]
fn plot_of_what_is_no_results_folder_says_so() {
    let place = Workplace::with_small(SMALL);
    refused(&place, &["plot", "nowhere"], &["nowhere is not a folder"]);
    place.write("manifest.json", "{}");
    let answer = place.sweep(&["plot", "."]);
    assert_ne!(answer.code, 0);
    assert!(
        answer.errors.contains("is not a manifest of this program"),
        "{answer:?}"
    );
}
