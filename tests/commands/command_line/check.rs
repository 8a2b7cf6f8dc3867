//! `sweep check`: the regression of labels.

use crate::command_line::{columns, run, succeeds, table, text};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

/// The small sweep, its own labels as a reference.
pub fn with_reference() -> Workplace {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    place.write("reference.csv", text(&place, "results/labels.csv"));
    place
}

#[test]
fn check_finds_its_own_labels() {
    let place = with_reference();
    let before = place.files();
    let answer = succeeds(&place, &["check", "small.toml", "reference.csv"]);
    assert_eq!(answer.output, "reference.csv: 6 of 6 labels as expected\n");
    assert!(place.files() == before);
}

/// The user's own cases, of columns in any order, with a comment above.
#[test]
fn check_needs_few_columns_and_cases() {
    let place = with_reference();
    let labels = table(&text(&place, "reference.csv"));
    let wanted = [
        "torsion",
        "weight_on_bit_kn",
        "method",
        "surface_speed_rpm",
        "case",
    ];
    let rows: String = columns(&labels, wanted)[3..]
        .iter()
        .map(|row| format!("{}\n", row.join(",")))
        .collect();
    place.write(
        "few.csv",
        format!("# Three cases.\n{}\n{rows}", wanted.join(",")),
    );
    let answer = succeeds(&place, &["check", "small.toml", "few.csv"]);
    assert_eq!(answer.output, "few.csv: 3 of 3 labels as expected\n");
}

/// A method that the sweep file does not name, with the parameters it has there.
#[test]
fn check_runs_the_methods_of_the_reference() {
    let place = with_reference();
    let methods = "finite-element,held";
    let run = ["run", "small.toml", "--methods", methods, "--out", "others"];
    succeeds(&place, &run);
    place.write("both.csv", text(&place, "others/labels.csv"));
    let answer = succeeds(&place, &["check", "small.toml", "both.csv"]);
    assert_eq!(answer.output, "both.csv: 12 of 12 labels as expected\n");
    let coarse = "\n[method.finite-element]\nelements_per_cell = 0\n";
    place.write("none.toml", format!("base = \"small.toml\"\n{coarse}"));
    let parts = ["none.toml", "elements_per_cell"];
    refused(&place, &["check", "none.toml", "both.csv"], &parts);
}

#[test]
fn check_prints_labels_that_differ() {
    let place = with_reference();
    let reference = text(&place, "reference.csv");
    let row = reference.lines().find(|row| row.starts_with("3,")).unwrap();
    let (found, other) = match row.contains("smooth") {
        true => ("smooth", "stick_slip"),
        false => ("stick_slip", "smooth"),
    };
    place.write(
        "reference.csv",
        with(&reference, row, &row.replace(found, other)),
    );
    let answer = place.sweep(&["check", "small.toml", "reference.csv"]);
    assert_eq!(answer.code, 5, "{answer:?}");
    let expected = format!(
        "case 3 by quadrature: surface_speed_rpm = 0.31, weight_on_bit_kn = 70: \
         expected {other}, found {found}, at "
    );
    assert!(answer.output.starts_with(&expected), "{answer:?}");
    assert!(
        answer
            .output
            .ends_with("reference.csv: 5 of 6 labels as expected\n"),
        "{answer:?}"
    );
}

/// A label that differs is reported with the limit of its own motion; without it where axes change
/// the string, since each string has its own limits.
#[test]
fn a_label_that_differs_is_measured_by_the_limit_of_its_motion() {
    let wall = "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n\
                [wall]\nclearance_mm = 15\nstiffness_gn_m15 = 1\n\n\
                [[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n\n[[string.sections]]";
    let sweep = with(SMALL, "[[string.sections]]", wall);
    let sweep = with(
        &sweep,
        "distance_from_bit_m = 50",
        "distance_from_bit_m = 0",
    );
    let sweep = with(&sweep, "to = 0.6, count = 3", "to = 60, count = 2");
    let sweep = with(&sweep, "values = [30, 70]", "values = [70]");
    let axes = "[design.axes]\nfriction = { values = [2] }\n";
    let sweep = with(&sweep, "[design.axes]\n", axes);
    let lines_with = |axes: &str| {
        let place = Workplace::with_small(&with(&sweep, "[design.axes]\n", axes));
        run(&place, "small.toml", "results");
        let labels = text(&place, "results/labels.csv");
        place.write("reference.csv", other_labels(&labels));
        let answer = place.sweep(&["check", "small.toml", "reference.csv"]);
        assert_eq!(answer.code, 5, "{answer:?}");
        answer.output
    };
    let lines = lines_with("[design.axes]\n");
    let (torsion, lateral): (Vec<&str>, Vec<&str>) = (lines.lines())
        .filter(|line| line.contains(": expected "))
        .partition(|line| line.contains("expected stuck"));
    assert!(torsion.len() == 2 && lateral.len() == 2, "{lines}");
    for line in torsion {
        assert!(line.ends_with(" times the speed of Eq. 74"), "{lines}");
    }
    for line in lateral {
        assert!(!line.contains("Eq. 74"), "{lines}");
    }
    assert!(
        lines.contains("least friction of steady rolling whirl"),
        "{lines}"
    );
    let strings = "[design.axes]\nsection_0_repeat = { values = [10] }\n";
    let lines = lines_with(strings);
    assert!(!lines.contains(" times the "), "{lines}");
}

/// A reference in which no label is what it was.
fn other_labels(labels: &str) -> String {
    let mut rows = table(labels);
    let places = ["torsion", "lateral"].map(|name| {
        let mut names = rows[0].iter();
        names.position(|known| known == name).unwrap()
    });
    for row in &mut rows[1..] {
        for (place, other) in places.into_iter().zip(["stuck", "forward_whirl"]) {
            assert_ne!(row[place], other);
            row[place] = other.to_owned();
        }
    }
    let lines = rows.iter().map(|row| row.join(",") + "\n");
    lines.collect()
}

#[test]
fn check_refuses_a_reference_that_does_not_belong_to_the_sweep() {
    let place = with_reference();
    let reference = text(&place, "reference.csv");
    let header = reference.lines().next().unwrap();
    let row = reference.lines().nth(1).unwrap();
    for (changed, words) in [
        (
            with(&reference, row, &row.replace("quadrature", "magic")),
            "reference.csv:2: the sweep has no method `magic`",
        ),
        (
            format!(
                "# A comment.\n\n{header}\n# Another.\n{}\n",
                row.replace("quadrature", "magic")
            ),
            "reference.csv:5: the sweep has no method `magic`",
        ),
        (
            with(&reference, row, &row.replacen("0,", "zero,", 1)),
            "reference.csv:2: `zero` is not a case number",
        ),
        (
            with(&reference, row, &row.replace("0.02", "slow")),
            "reference.csv:2: surface_speed_rpm: `slow` is not a number",
        ),
        (
            with(&reference, row, &row.replace("0.02", "0")),
            "reference.csv:2: surface_speed_rpm: 0 rpm: the surface must turn",
        ),
        (
            with(&reference, row, &row.replace("0.02", "nan")),
            "reference.csv:2: surface_speed_rpm: NaN rpm is not between",
        ),
        (
            format!("{reference}{}\n", row.replace("0.02", "0.03")),
            "reference.csv:8: case 0 has other values above",
        ),
        (
            with(&reference, ",torsion,", ",label,"),
            "reference.csv:1: has no column `torsion`",
        ),
        (
            with(&reference, ",weight_on_bit_kn,", ",weight,"),
            "reference.csv:1: has no column `weight_on_bit_kn`",
        ),
        (
            with(&reference, ",lateral,", ",torsion,"),
            "reference.csv:1: has the column `torsion` twice",
        ),
        (format!("{header}\n"), "reference.csv has no rows"),
        (String::new(), "reference.csv"),
    ] {
        place.write("reference.csv", changed);
        refused(&place, &["check", "small.toml", "reference.csv"], &[words]);
    }
    let missing = ["check", "small.toml", "nowhere.csv"];
    refused(&place, &missing, &["nowhere.csv cannot be read"]);
}

/// No label that differs, which would be exit code 5.
#[test]
fn a_label_that_is_no_regime_is_a_mistake_in_the_reference() {
    let place = with_reference();
    let reference = text(&place, "reference.csv");
    let row = reference.lines().nth(1).unwrap();
    let label = row
        .split(',')
        .find(|cell| ["smooth", "stick_slip"].contains(cell))
        .unwrap();
    for (word, meant) in [
        (
            "stick-slip",
            "torsion: `stick-slip` is no torsion regime; did you mean `stick_slip`?",
        ),
        (
            "Smooth",
            "torsion: `Smooth` is no torsion regime; did you mean `smooth`?",
        ),
        (
            "no",
            "torsion: `no` is no torsion regime; known: stuck, smooth, stick_slip",
        ),
        (
            "smooth,no_whirl",
            "lateral: `no_whirl` is no lateral regime; known: no_contact, ",
        ),
        (
            "smooth,stick_slip",
            "lateral: `stick_slip` is no lateral regime; known: ",
        ),
        ("smooth,backward_whirls", "did you mean `backward_whirl`?"),
    ] {
        let wrong = match word.contains(',') {
            true => row.replace(&format!("{label},,"), &format!("{word},")),
            false => row.replace(label, word),
        };
        place.write("reference.csv", with(&reference, row, &wrong));
        let check = ["check", "small.toml", "reference.csv"];
        refused(&place, &check, &["error: reference.csv:2: ", meant]);
    }
}

#[test]
fn a_label_that_the_sweep_does_not_give_is_found_to_be_none() {
    let place = with_reference();
    let reference = text(&place, "reference.csv");
    let row = reference.lines().nth(1).unwrap();
    let fields: Vec<&str> = row.split(',').collect();
    let lateral = [&fields[..6], &["no_contact"], &fields[7..]].concat();
    place.write("reference.csv", with(&reference, row, &lateral.join(",")));
    let answer = place.sweep(&["check", "small.toml", "reference.csv"]);
    assert_eq!(answer.code, 5, "{answer:?}");
    let reported = "expected no_contact, found none";
    assert!(answer.output.contains(reported), "{answer:?}");
}

/// Through a spreadsheet and back.
#[test]
fn a_reference_may_have_semicolons_and_decimal_commas() {
    let place = with_reference();
    let exported = text(&place, "reference.csv")
        .replace(',', ";")
        .replace('.', ",");
    let rows = exported.replace('\n', "\r\n") + ";;;\r\n";
    place.write("reference.csv", format!("\u{feff}{rows}"));
    let answer = succeeds(&place, &["check", "small.toml", "reference.csv"]);
    assert_eq!(answer.output, "reference.csv: 6 of 6 labels as expected\n");
}
