//! `sweep inspect --modes`: natural frequencies, critical speeds and mode shapes.

use super::*;

/// A plain pipe of 100 m that bends freely, its surface pinned, turned at 20 to 100 rpm.
fn plain() -> String {
    let setting = SMALL.split("[[string.sections]]").next().unwrap();
    setting.to_owned()
        + r#"
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]

[string.bending]
youngs_modulus_gpa = 210
damping_ns_m2 = 100
surface = "pinned"

[wall]
clearance_mm = 15
stiffness_gn_m15 = 10
friction = 0.5

[[sites]]
distance_from_bit_m = 0

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 20, to = 100, count = 3 }
"#
}

fn rows(place: &Workplace, file: &str) -> Vec<Vec<String>> {
    table(&text(place, file)).split_off(1)
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// (n − ¾)-quarter waves of a shaft; kL of a pinned beam, free below, near (n + ¼)π.
#[test]
fn modes_are_those_of_a_uniform_string() {
    let place = Workplace::with_small(&plain());
    let arguments = ["inspect", "small.toml", "--modes=3", "--orders", "2,1"];
    let answer = place.sweep(&[&arguments[..], &["--out", "looked"]].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    for word in [
        "torsion, surface held",
        "bending of the whole string, surface pinned",
        "rpm, 2×",
    ] {
        assert!(answer.output.contains(word), "no {word:?} in {answer:?}");
    }
    for name in ["campbell", "mode_shapes"] {
        is_png(&place, &format!("looked/{name}.png"));
        assert!(place.path(&format!("looked/{name}.svg")).exists());
    }
    let modes = rows(&place, "looked/modes.csv");
    let of = |motion: &str| -> Vec<f64> {
        let own = modes.iter().filter(|row| row[0] == motion);
        own.map(|row| number(&row[2])).collect()
    };
    let (torsion, bending) = (of("torsion"), of("bending"));
    let travel = 100.0 / (80e9f64 / 7840.0).sqrt();
    for (index, found) in torsion.iter().enumerate() {
        let expected = (index as f64 + 0.5) / (2.0 * travel);
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    }
    let slenderness: f64 = 210e9 * (0.1f64.powi(2) + 0.05f64.powi(2)) / 4.0 / 7840.0;
    for (index, found) in bending.iter().enumerate().skip(3) {
        let turns = (index as f64 + 1.25) * std::f64::consts::PI;
        let expected = turns * turns * slenderness.sqrt() / 1e4 / std::f64::consts::TAU;
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
    }
    // As far as twice the greatest speed reaches, and at least three.
    assert_eq!(torsion.len(), 3);
    assert!(bending.len() > 3 && bending.iter().all(|it| *it < 200.0 / 60.0));
    let damping = modes.iter().filter(|row| row[0] == "torsion");
    // c_t/(2 ρ J ω) of a uniform string.
    let moment = std::f64::consts::FRAC_PI_2 * (0.1f64.powi(4) - 0.05f64.powi(4));
    for (row, frequency) in damping.zip(&torsion) {
        let rate = std::f64::consts::TAU * frequency;
        let expected = 10.0 / (2.0 * 7840.0 * moment * rate);
        assert!(
            (number(&row[3]) / expected - 1.0).abs() < 1e-6,
            "{row:?} {expected}"
        );
    }
    // Every meeting in the range, and no other.
    let critical = rows(&place, "looked/critical_speeds.csv");
    let mut expected = 0;
    for order in [1.0, 2.0] {
        for frequency in torsion.iter().chain(&bending) {
            let speed = 60.0 * frequency / order;
            let is_there = critical
                .iter()
                .any(|row| number(&row[1]) == order && number(&row[4]) == speed);
            let is_in_range = (20.0..=100.0).contains(&speed);
            assert_eq!(is_there, is_in_range, "{order} {frequency}");
            expected += usize::from(is_in_range);
        }
    }
    assert!(expected > 3 && critical.len() == expected, "{critical:?}");
    let shapes = rows(&place, "looked/mode_shapes.csv");
    assert_eq!(shapes.len(), 6 * 201);
    let first = shapes.iter().take(201);
    for row in first {
        let (depth, amplitude) = (number(&row[2]), number(&row[3]));
        let expected = (std::f64::consts::FRAC_PI_2 * depth / 100.0).sin();
        assert!((amplitude.abs() - expected).abs() < 1e-4, "{row:?}");
    }
}

#[test]
fn tables_of_modes_are_the_same_by_any_number_of_threads() {
    let place = Workplace::with_small(&plain());
    let tables = |jobs: &str| {
        let out = format!("by_{jobs}");
        let arguments = [
            "inspect",
            "small.toml",
            "--modes",
            "--jobs",
            jobs,
            "--out",
            &out,
        ];
        assert_eq!(place.sweep(&arguments).code, 0);
        ["modes", "critical_speeds", "mode_shapes"]
            .map(|name| text(&place, &format!("{out}/{name}.csv")))
    };
    assert_eq!(tables("1"), tables("3"));
}

#[test]
fn without_a_wall_there_is_torsion_alone_and_speeds_too_slow_for_it_are_not_critical() {
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["inspect", "small.toml", "--modes", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(!answer.output.contains("bending, surface"), "{answer:?}");
    assert_eq!(rows(&place, "looked/modes.csv").len(), 6);
    assert!(rows(&place, "looked/critical_speeds.csv").is_empty());
}

#[test]
fn what_no_modes_can_be_asked_for_is_refused() {
    let place = Workplace::with_small(SMALL);
    for (arguments, complaint) in [
        (&["--modes=0"][..], "0 is not in 1..=30"),
        (&["--modes=31"], "31 is not in 1..=30"),
        (&["--modes", "--orders", "1,0"], "`0` is not a multiple"),
        (&["--modes", "--orders", "nan"], "`nan` is not a multiple"),
        (&["--orders", "2"], "--modes"),
        (
            &["--modes", "--orders", "1,2,3,4,5,6,7"],
            "7 are more than 6",
        ),
    ] {
        let answer = place.sweep(&[&["inspect", "small.toml"], arguments].concat());
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(complaint), "{answer:?}");
    }
}

/// Held at the bit and 20 m above it: between these the half sine of a beam, ω = (π/l)² √(EI/m).
#[test]
fn modes_between_held_places_are_apart_from_those_of_the_whole_string() {
    let site = "[[sites]]\ndistance_from_bit_m = 0\n";
    let held = plain().replace(
        site,
        &format!("{site}[[sites]]\ndistance_from_bit_m = 20\n"),
    );
    let place = Workplace::with_small(&held);
    let answer = place.sweep(&["inspect", "small.toml", "--modes=2", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(
        answer.output.contains("pinned at 20, 0 m from the bit"),
        "{answer:?}"
    );
    let modes = rows(&place, "looked/modes.csv");
    let between: Vec<f64> = modes
        .iter()
        .filter(|row| row[0] == "bending_between_sites")
        .map(|row| number(&row[2]))
        .collect();
    let slenderness: f64 = 210e9 * (0.1f64.powi(2) + 0.05f64.powi(2)) / 4.0 / 7840.0;
    let expected =
        (std::f64::consts::PI / 20.0).powi(2) * slenderness.sqrt() / std::f64::consts::TAU;
    assert!(
        (between[0] / expected - 1.0).abs() < 1e-8,
        "{between:?} {expected}"
    );
    let shapes = rows(&place, "looked/mode_shapes.csv");
    let first: Vec<_> = (shapes.iter())
        .filter(|row| row[0] == "bending_between_sites" && row[1] == "1")
        .collect();
    assert_eq!(first.len(), 201);
    for row in first {
        let expected = (std::f64::consts::PI * (100.0 - number(&row[2])) / 20.0).sin();
        assert!((number(&row[3]).abs() - expected).abs() < 1e-4, "{row:?}");
    }
}

/// Below its hook load a pipe of 100 m has half waves along its axis, √(E/ρ)/2L apart; and all ways of
/// vibration that grow about steady drilling do so in pairs of roots.
#[test]
fn a_bit_that_cuts_has_modes_of_the_axis_and_roots_that_grow() {
    let place = Workplace::with_small(CUTTING);
    let arguments = ["inspect", "small.toml", "--modes=4", "--out", "looked"];
    let answer = place.sweep(&arguments);
    assert_eq!(answer.code, 0, "{answer:?}");
    for words in [
        "along the axis, hanging from its hoist, free to move",
        "plus 1 rigid-body mode",
        "steady drilling, by the roots of D(s)",
    ] {
        assert!(answer.output.contains(words), "no {words:?} in {answer:?}");
    }
    // A torque that falls with speed is not given.
    assert!(!place.path("looked/bit_resonances.csv").exists());
    let modes = rows(&place, "looked/modes.csv");
    let axial: Vec<_> = modes.iter().filter(|row| row[0] == "axial").collect();
    assert_eq!(axial.len(), 4);
    let half_wave = (210e9_f64 / 7840.0).sqrt() / 200.0;
    for (mode, row) in axial.into_iter().enumerate() {
        let exact = (mode + 1) as f64 * half_wave;
        assert!((number(&row[2]) / exact - 1.0).abs() < 1e-6, "{row:?}");
        assert!((0.0..0.2).contains(&number(&row[3])), "{row:?}");
    }
    let points = rows(&place, "looked/steady_drilling.csv");
    assert_eq!(points.len(), 6);
    for row in points {
        let roots: usize = row[8].parse().unwrap();
        assert!(roots > 0 && roots % 2 == 0, "{row:?}");
    }
    let uneven = with(
        CUTTING,
        "blades = 4",
        "blade_angles_deg = [80, 100, 80, 100]",
    );
    place.write("small.toml", uneven);
    let answer = place.sweep(&arguments);
    assert!(answer.output.contains("blades are not even"), "{answer:?}");
    // A surface that moves at its speed holds the string.
    let fed = with(
        CUTTING,
        "[design]\n",
        "[feed]\nkind = \"speed\"\n\n[design]\n",
    );
    let fed = with(&fed, "weight_on_bit_kn = 20\n", "");
    place.write(
        "small.toml",
        with(&fed, "weight_on_bit_kn = {", "feed_m_h = {"),
    );
    let answer = place.sweep(&arguments);
    assert!(
        answer.output.contains("along the axis, surface held"),
        "{answer:?}"
    );
    let modes = rows(&place, "looked/modes.csv");
    let first = modes.iter().find(|row| row[0] == "axial").expect("a mode");
    assert!(
        (number(&first[2]) / (0.5 * half_wave) - 1.0).abs() < 1e-6,
        "{first:?}"
    );
}
