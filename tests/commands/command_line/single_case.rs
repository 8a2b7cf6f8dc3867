//! `sweep simulate`, `sweep inspect` and `sweep plot`.

use crate::command_line::{columns, is_png, names, names_in, run, succeeds, table, text};
use crate::refusals::refused;
use crate::support::{CUTTING, SMALL, Workplace, with};

#[test]
fn simulate_writes_the_history_of_one_case() {
    let place = Workplace::with_small(SMALL);
    let arguments = ["simulate", "small.toml", "--out", "case"];
    let answer = succeeds(&place, &arguments);
    assert!(answer.output.contains("Ω = 0.0200 rpm"), "{answer:?}");
    assert_eq!(
        names_in(&place, "case"),
        names([
            "case.csv",
            "history.csv",
            "history.png",
            "history.svg",
            "phase.png",
            "phase.svg",
            "spectrum.png",
            "spectrum.svg",
        ])
    );
    for picture in ["history", "phase", "spectrum"] {
        is_png(&place, &format!("case/{picture}.png"));
    }
    let spectrum = text(&place, "case/spectrum.svg");
    for words in [
        "Bit speed, quadrature",
        "Frequency (Hz)",
        "Amplitude (rpm)",
        "Amplitude (kN m)",
    ] {
        assert!(spectrum.contains(words), "{words}");
    }
    assert!(text(&place, "case/phase.svg").contains("Twist of the string"));
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

/// The rock that a bit leaves is as deep as the bit, or as what it found where it is off bottom; and
/// what the bit cuts is what it goes below that of a blade before.
#[test]
fn simulate_draws_what_a_bit_cuts_and_what_it_leaves() {
    let place = Workplace::with_small(CUTTING);
    let arguments = ["simulate", "small.toml", "--case", "3", "--out", "case"];
    let answer = succeeds(&place, &arguments);
    assert!(answer.output.contains("cut, surface as svg"), "{answer:?}");
    for picture in ["cut", "surface", "history"] {
        is_png(&place, &format!("case/{picture}.png"));
    }
    let cut = text(&place, "case/cut.svg");
    assert!(cut.contains("Turn of the bit") && cut.contains("Depth of cut (mm)"));
    assert!(text(&place, "case/surface.svg").contains("Height of the rock"));
    assert!(text(&place, "case/history.svg").contains("Depth of the bit"));
    let history = table(&text(&place, "case/history.csv"));
    let names = [
        "bit_turns",
        "bit_depth_mm",
        "rock_depth_mm",
        "depth_of_cut_mm",
    ];
    let steps: Vec<Vec<f64>> = (columns(&history, names).iter())
        .map(|row| row.iter().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    // Recorded in the middle of steps, of which the bit leaves the ends.
    let mut ends = vec![[0.0; 2]];
    for step in &steps {
        let last = ends[ends.len() - 1];
        ends.push([0, 1].map(|index| 2.0 * step[index] - last[index]));
    }
    let (mut off_bottom, mut errors) = (0, Vec::new());
    for step in &steps {
        let [turns, depth, rock, cut] = step[..] else {
            unreachable!()
        };
        assert_eq!(rock, if cut < 0.0 { rock } else { depth });
        assert!(rock >= depth && (rock - depth - (-cut).max(0.0)).abs() < 1e-9);
        off_bottom += usize::from(cut < 0.0);
        // Four blades: the one before was here a quarter of a turn earlier.
        let before = turns - 0.25;
        let above = ends.partition_point(|end| end[0] < before);
        if before < 1.0 {
            continue;
        }
        // What is left of a bit that stands, or is off bottom, is not a straight line between ends.
        let mut around = ends[above - 4..above + 4].windows(2);
        let is_turning = around.all(|ends| ends[1][0] - ends[0][0] > 1e-4);
        let cuts = steps[above - 5..above + 4]
            .iter()
            .all(|other| other[3] > 0.0);
        if is_turning && cuts {
            let [low, high] = [ends[above - 1], ends[above]];
            let part = (before - low[0]) / (high[0] - low[0]);
            let found = low[1] + part * (high[1] - low[1]);
            errors.push((depth - found - cut).abs());
        }
    }
    assert!(2 * errors.len() > steps.len(), "{}", errors.len());
    let wrong = errors.iter().filter(|error| **error > 1e-6).count();
    assert!(100 * wrong < errors.len(), "{wrong}");
    assert!(off_bottom > 10, "{off_bottom}");
}

#[test]
fn a_bit_that_never_turns_once_has_no_picture_of_its_turns() {
    let slow = with(CUTTING, "from = 40, to = 160", "from = 0.4, to = 1.6");
    let place = Workplace::with_small(&slow);
    let answer = succeeds(&place, &["simulate", "small.toml", "--out", "case"]);
    assert!(!answer.output.contains("cut, "), "{answer:?}");
    assert!(!place.path("case/cut.svg").exists());
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
fn several_cases_are_kept_together() {
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
fn cases_of_different_length_are_kept_together() {
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

/// Each measure by its words, from the history that `simulate` writes: greatest in all the time, mean
/// and share in the closing window, of which the last two seconds of lateral motion are.
#[test]
fn columns_are_what_their_words_say_of_the_motion() {
    let of = |file: &str| {
        let place = Workplace::new();
        let sweep = format!("{}/../../sweeps/{file}", env!("CARGO_MANIFEST_DIR"));
        let arguments = [
            "simulate",
            &sweep,
            "--methods",
            "quadrature",
            "--out",
            "out",
        ];
        assert_eq!(place.sweep(&arguments).code, 0);
        let read = |name: &str| std::fs::read_to_string(place.path(name)).unwrap();
        (
            numbers_of(&read("out/case.csv")),
            numbers_of(&read("out/history.csv")),
        )
    };
    let near = |name: &str, found: f64, expected: f64, part: f64| {
        let off = (found - expected).abs() / expected.abs();
        assert!(off < part, "{name}: {found}, not {expected}");
    };
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let greatest = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);

    let (case, history) = of("fig12.toml");
    let [time, x, y, force_x, force_y] = [
        "time_s",
        "bit_x_mm",
        "bit_y_mm",
        "bit_wall_force_x_n",
        "bit_wall_force_y_n",
    ]
    .map(|name| history[name].clone());
    let radius: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).collect();
    let first = time.partition_point(|it| *it <= time[time.len() - 1] - 2.0);
    near(
        "peak_radius_mm",
        case["peak_radius_mm"][0],
        greatest(&radius),
        1e-6,
    );
    near(
        "mean_radius_mm",
        case["mean_radius_mm"][0],
        mean(&radius[first..]),
        1e-3,
    );
    let normal: Vec<f64> = (first..time.len())
        .map(|step| -1e-3 * (force_x[step] * x[step] + force_y[step] * y[step]) / radius[step])
        .collect();
    let touching: Vec<f64> = normal
        .iter()
        .copied()
        .filter(|force| *force > 0.0)
        .collect();
    near(
        "normal_force_mean_kn",
        case["normal_force_mean_kn"][0],
        mean(&touching),
        1e-2,
    );
    near(
        "contact_fraction",
        case["contact_fraction"][0],
        touching.len() as f64 / normal.len() as f64,
        1e-2,
    );

    let (case, history) = of("fig08b.toml");
    let (time, speed) = (&history["time_s"], &history["bit_speed_rpm"]);
    near(
        "bit_speed_peak_rpm",
        case["bit_speed_peak_rpm"][0],
        greatest(speed),
        1e-6,
    );
    // Its closing window is as long as a cycle takes by estimate: about a period.
    let (period, end) = (case["period_s"][0], time[time.len() - 1]);
    let found = case["bit_speed_closing_rpm"][0];
    let first = |periods: f64| time.partition_point(|it| *it <= end - periods * period);
    let mut windows = first(2.5)..first(0.5);
    let window = windows.find(|from| (mean(&speed[*from..]) / found - 1.0).abs() < 1e-3);
    let from = window.unwrap_or_else(|| panic!("{found} is the mean of no window"));
    assert!(greatest(&speed[from..]) > 1.5 * found);
}

/// The numbers of a table, by column; NaN for other fields.
fn numbers_of(text: &str) -> std::collections::BTreeMap<String, Vec<f64>> {
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let rows: Vec<Vec<&str>> = lines.collect();
    let column = |place: usize| {
        rows.iter()
            .map(|row| row[place].parse().unwrap_or(f64::NAN))
            .collect()
    };
    (header.iter().enumerate())
        .map(|(place, name)| ((*name).to_owned(), column(place)))
        .collect()
}
