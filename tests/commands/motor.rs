//! A mud motor above the bit, from file to tables: with a bit under a law, with friction along the
//! string, and with a bit that cuts.

use super::cutting::{columns, done};
use crate::support::{CUTTING, Workplace, small_with_design, with};

/// 100 rpm without load, 2 rpm less for each kN m.
const MOTOR: &str = "[motor]\nspeed_rpm = 100\nstall_torque_kn_m = 10\nspeed_at_stall_rpm = 80\n";

const DESIGN: &str = "[design]\nkind = \"grid\"\n[design.axes]\n\
                      surface_speed_rpm = { values = [60, 120] }\nweight_on_bit_kn = { values = [20, 40] }\n";

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// Speed of the motor under a torque (N m), rpm.
fn relative_speed(torque: f64) -> f64 {
    100.0 - 2e-3 * torque
}

/// Smooth rotation: by the chart faster than the surface, without friction along the string and with;
/// and no limit of a bit that turns with its string is given.
#[test]
fn a_bit_below_a_motor_turns_by_its_chart() {
    let friction = "[well]\nsurvey = \"survey.csv\"\n[string_friction]\nstatic_coefficient = 0.3\n\
                    dynamic_ratio = 0.7\nstribeck_rpm = 5\n";
    for more in ["", friction] {
        let place = Workplace::with_small(&small_with_design(&format!("{MOTOR}{more}{DESIGN}")));
        place.write("survey.csv", "md_m,inc_deg,azi_deg\n0,0,0\n200,40,0\n");
        done(&place, &["run", "small.toml", "--out", "out"]);
        let names = [
            "surface_speed_rpm",
            "torque_dynamic_nm",
            "torsion",
            "bit_speed_closing_rpm",
            "stick_slip_margin_rpm",
        ];
        let rows = columns(&place, "out/labels.csv", names);
        assert_eq!(rows.len(), 4);
        for [surface, torque, label, bit, margin] in rows {
            assert_eq!((label.as_str(), margin.as_str()), ("smooth", ""));
            let expected = number(&surface) + relative_speed(number(&torque));
            assert!((number(&bit) - expected).abs() < 0.05, "{bit} {expected}");
        }
        let boundary = std::fs::read_to_string(place.path("out/boundary.csv")).unwrap();
        assert_eq!(boundary.lines().count(), 1, "{boundary}");
    }
}

/// 150 N m for each kN of weight: a motor of 10 kN m stalls from 66.7 kN on.
const ROCK: &str = "rock = \"table\"\ntable_kn_nm = [[0, 0], [200, 30000]]\n";

/// A motor that a bit of 150 N m per kN stalls from 10 000/150 kN on: cases, map, window, report and
/// `inspect` say so, and a stalled one that turns smoothly is not safe.
#[test]
fn a_motor_stalls_from_the_weight_at_which_the_bit_takes_its_stall_torque() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
                  surface_speed_rpm = { values = [120, 160] }\n\
                  weight_on_bit_kn = { values = [40, 60, 80] }\n";
    let text = small_with_design(&format!("{MOTOR}{design}"));
    let text = with(&text, "rock = \"sandstone\"\n", ROCK);
    let place = Workplace::with_small(&text);
    let said = done(&place, &["run", "small.toml", "--out", "out"]);
    let names = [
        "weight_on_bit_kn",
        "torsion",
        "motor_stalled",
        "motor_stalled_fraction",
    ];
    let rows = columns(&place, "out/labels.csv", names);
    assert_eq!(rows.len(), 6);
    for [weight, label, stalled, part] in &rows {
        let stalls = number(weight) > 1e4 / 150.0;
        assert_eq!(label, "smooth");
        assert_eq!(stalled, if stalls { "true" } else { "false" });
        assert_eq!(number(part), f64::from(stalls));
    }
    let sentence = "the mud motor stalls in 2 of 6 cases, 2 of them smooth";
    assert!(said.replace("\n    ", " ").contains(sentence), "{said}");
    for row in columns(&place, "out/boundary.csv", ["limit", "weight_on_bit_kn"]) {
        let [limit, weight] = row;
        assert_eq!(limit, "motor_stall");
        assert!((number(&weight) - 1e4 / 150.0).abs() < 1e-6, "{weight}");
    }
    let said = done(
        &place,
        &["inspect", "small.toml", "--out", "seen", "--json"],
    );
    let found: serde_json::Value = serde_json::from_str(&said).unwrap();
    let from = found["motor"]["stalls_from_kn"][0].as_f64().unwrap();
    assert!((from - 1e4 / 150.0).abs() < 1e-6, "{from}");
    done(&place, &["window", "small.toml", "out"]);
    let names = ["weight_on_bit_kn_to", "standing"];
    for [weight, standing] in columns(&place, "out/window.csv", names) {
        let may_be_safe = number(&weight) < 1e4 / 150.0;
        assert!(
            may_be_safe || !standing.starts_with("safe"),
            "{weight} {standing}"
        );
    }
}

/// A torque that falls with the bit's speed stalls the motor from the weight on at which it is the stall
/// torque where the rotor is about to stall: 10 kN m = 150 W (1 + 0.2 e^(−(Ω + 80)/100)).
#[test]
fn a_falling_torque_stalls_the_motor_by_the_speed_that_the_bit_has_left() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
                  surface_speed_rpm = { values = [40, 160] }\n\
                  weight_on_bit_kn = { values = [40, 80] }\n";
    let text = small_with_design(&format!("{MOTOR}{design}"));
    let falling = format!("{ROCK}torque_static_ratio = 1.2\ntorque_decay_rpm = 100\n");
    let text = with(&text, "rock = \"sandstone\"\n", &falling);
    let place = Workplace::with_small(&text);
    done(&place, &["run", "small.toml", "--out", "out"]);
    let names = ["limit", "surface_speed_rpm", "weight_on_bit_kn"];
    let rows = columns(&place, "out/boundary.csv", names);
    assert!(rows.len() > 2);
    for [limit, speed, weight] in rows {
        let falling = 1.0 + 0.2 * (-(number(&speed) + 80.0) / 100.0).exp();
        assert_eq!(limit, "motor_stall");
        assert!(
            (number(&weight) * 150.0 * falling - 1e4).abs() < 1e-3,
            "{speed} {weight}"
        );
    }
}

/// However it chatters, the bit is faster than the surface by the chart in the mean.
#[test]
fn a_bit_that_cuts_below_a_motor_turns_by_its_chart_in_the_mean() {
    let place = Workplace::with_small(&with(CUTTING, "[design]\n", &format!("{MOTOR}[design]\n")));
    done(
        &place,
        &["simulate", "small.toml", "--case", "3", "--out", "out"],
    );
    let names = ["bit_speed_rpm", "mud_motor_torque_nm"];
    let rows = columns(&place, "out/history.csv", names);
    let late: Vec<[f64; 2]> = (rows[rows.len() / 2..].iter())
        .map(|[speed, torque]| [number(speed), number(torque)])
        .collect();
    let mean = |of: usize| late.iter().map(|row| row[of]).sum::<f64>() / late.len() as f64;
    assert!(late.iter().all(|row| row[1] < 10e3), "it never stalls");
    let expected = 100.0 + relative_speed(mean(1));
    assert!(
        (mean(0) / expected - 1.0).abs() < 5e-3,
        "{} {expected}",
        mean(0)
    );
}

/// A string that is pushed to its walls above a motor, and begins turning: from the first step the bit turns
/// by its chart, and limits of whirl are not given.
#[test]
fn walls_go_together_with_a_motor() {
    let wall = "[string.bending]\nyoungs_modulus_gpa = 206\ndamping_ns_m2 = 100\n\
                [bit]\ntorque_dynamic_nm = 500\n[wall]\nclearance_mm = 20\nfriction = 0.3\n\
                [[sites]]\ndistance_from_bit_m = 0\n[[sites]]\ndistance_from_bit_m = 20\n\
                [[impulses]]\ndistance_from_bit_m = 0\namount_ns = 2000\nstart_s = 1\n";
    let setting = crate::support::SMALL.split("[bit]").next().unwrap();
    let design =
        "[design]\nkind = \"grid\"\n[design.axes]\nsurface_speed_rpm = { values = [40, 80] }\n";
    let text = format!("start = \"smooth\"\nstart_disturbance = 0\n{setting}{MOTOR}{wall}{design}");
    let place = Workplace::with_small(&text);
    done(&place, &["run", "small.toml", "--out", "out"]);
    let rows = columns(&place, "out/labels.csv", ["torsion", "peak_radius_mm"]);
    assert_eq!(rows.len(), 2);
    for [torsion, radius] in &rows {
        // It is pushed to its wall.
        assert!(
            torsion == "smooth" && number(radius) > 20.0,
            "{torsion} {radius}"
        );
    }
    done(
        &place,
        &["simulate", "small.toml", "--case", "1", "--out", "case"],
    );
    let speeds = columns(&place, "case/history.csv", ["bit_speed_rpm"]);
    let expected = 80.0 + relative_speed(500.0);
    for [speed] in speeds.iter().take(90) {
        assert!(
            (number(speed) - expected).abs() < 1e-6,
            "{speed} {expected}"
        );
    }
    // Limits of whirl are of what turns with the string.
    let text = with(&text, "torque_dynamic_nm = 500", "rock = \"sandstone\"");
    place.write("small.toml", with(&text, design, DESIGN));
    done(&place, &["run", "small.toml", "--out", "grid"]);
    let said = done(&place, &["window", "small.toml", "grid"]);
    assert!(
        said.contains("from which speed on whirl lasts")
            && said.contains("no bound excludes it anywhere"),
        "{said}"
    );
}

/// In soft rock it drills steadily from the first step, as the chart and the rock say, and the roots that
/// grow are counted with the motor.
#[test]
fn a_bit_that_cuts_below_a_motor_may_begin_drilling() {
    let steady = "start = \"smooth\"\nstart_disturbance = 1e-4\ntitle = ";
    let text = with(
        &with(CUTTING, "title = ", steady),
        "specific_energy_mpa = 60",
        "specific_energy_mpa = 0.5",
    );
    let text = with(
        &text,
        "[design]\n",
        &format!("[string.axial]\ndamping_ns_m2 = 2000\n{MOTOR}[design]\n"),
    );
    let text = with(&text, "wear_flat_mm = 1\n", "wear_flat_mm = 0.1\n");
    let place = Workplace::with_small(&text);
    done(&place, &["run", "small.toml", "--out", "out"]);
    done(
        &place,
        &[
            "inspect",
            "small.toml",
            "--modes",
            "--csv",
            "--out",
            "modes",
        ],
    );
    let names = ["axial", "rate_of_penetration_m_h", "bit_speed_closing_rpm"];
    let simulated = columns(&place, "out/labels.csv", names);
    let names = [
        "surface_speed_rpm",
        "steady_torque_nm",
        "steady_rate_of_penetration_m_h",
        "steady_bit_speed_rpm",
        "growing_roots",
    ];
    let exact = columns(&place, "modes/steady_drilling.csv", names);
    assert_eq!(simulated.len(), 6);
    for ([label, rate, speed], exact) in simulated.iter().zip(&exact) {
        let [surface, torque, exact_rate, exact_speed, roots] =
            exact.each_ref().map(|it| number(it));
        assert_eq!((label.as_str(), roots), ("steady", 0.0));
        assert!((exact_speed - surface - relative_speed(torque)).abs() < 1e-3);
        assert!(
            (number(speed) / exact_speed - 1.0).abs() < 1e-4,
            "{speed} {exact_speed}"
        );
        assert!(
            (number(rate) / exact_rate - 1.0).abs() < 1e-4,
            "{rate} {exact_rate}"
        );
    }
}
