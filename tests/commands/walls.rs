//! How deep walls give way, and whether rock bears it, from file to tables.

use super::cutting::{columns, done};
use crate::support::{SMALL, Workplace};

/// A string that is pushed to a wall without friction, soft or hard, 2 mm away.
fn pushed() -> String {
    let setting = SMALL.split("[bit]").next().unwrap();
    format!(
        "{setting}[string.bending]\nyoungs_modulus_gpa = 206\ndamping_ns_m2 = 100\n\
         [wall]\nclearance_mm = 2\nfriction = 0\n[[sites]]\ndistance_from_bit_m = 0\n\
         [[sites]]\ndistance_from_bit_m = 20\n\
         [[impulses]]\ndistance_from_bit_m = 0\namount_ns = 2000\nstart_s = 1\n\
         [design]\nkind = \"grid\"\n[design.axes]\nstiffness_gn_m15 = {{ values = [0.001, 10] }}\n"
    )
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// The hardest push and its depth are those of the motion in full: the greatest force, and the greatest
/// radius less the clearance. A hard wall would break, and run, summary and `simulate` say so;
/// a soft one presses on no rock.
#[test]
fn the_hardest_push_into_a_wall_is_that_of_the_motion() {
    let place = Workplace::with_small(&pushed());
    let said = done(&place, &["run", "small.toml", "--out", "out"]);
    let names = [
        "wall_penetration_mm",
        "wall_penetration_from_bit_m",
        "wall_force_kn",
        "wall_pressure_mpa",
        "wall_breaks",
    ];
    let rows = columns(&place, "out/labels.csv", names);
    assert_eq!(rows.len(), 2);
    let sentence = "in 1 of 2 cases that press on a wall its rock would break";
    let one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(one_line(&said).contains(sentence), "{said}");
    let said = done(&place, &["summary", "out"]);
    assert!(one_line(&said).contains(sentence), "{said}");
    for (case, [depth, from_bit, force, pressure, breaks]) in rows.iter().enumerate() {
        let number_of_case = case.to_string();
        let arguments = [
            "simulate",
            "small.toml",
            "--case",
            &number_of_case,
            "--out",
            "case",
        ];
        let said = done(&place, &arguments);
        assert_eq!(breaks, if case == 1 { "true" } else { "false" });
        assert_eq!(
            one_line(&said).contains("its rock would break"),
            case == 1,
            "{said}"
        );
        let site = if from_bit == "0" {
            "bit"
        } else {
            "20m_above_bit"
        };
        let columns_of = |names: [String; 2]| {
            let names = names.each_ref().map(String::as_str);
            let rows = columns(&place, "case/history.csv", names);
            let lengths = rows.iter().map(|[x, y]| number(x).hypot(number(y)));
            lengths.fold(0.0, f64::max)
        };
        let radius = columns_of(["x_mm", "y_mm"].map(|name| format!("{site}_{name}")));
        let most = columns_of(["x", "y"].map(|axis| format!("{site}_wall_force_{axis}_n")));
        assert!(
            (radius - 2.0 - number(depth)).abs() < 1e-9 * radius,
            "{radius} {depth}"
        );
        assert!(
            (1e-3 * most / number(force) - 1.0).abs() < 1e-6,
            "{most} {force}"
        );
        // By Hertz on a round patch of πRδ, R = 0.15 m at the joint above the bit.
        let area = std::f64::consts::PI * 0.15 * 1e-3 * number(depth);
        if site == "bit" {
            assert!(
                (1e-6 * most / area / number(pressure) - 1.0).abs() < 1e-6,
                "{pressure}"
            );
        }
    }
}
