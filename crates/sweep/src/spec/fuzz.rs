//! Whatever is done to a sweep file, reading it gives a sweep or a sentence.

use std::path::Path;

use proptest::prelude::*;

use super::Sweep;

/// A file with something of everything that a sweep file can say.
const FULL: &str = r#"
base = "base.toml"
title = "A title"
surface_speed_rpm = 60
time_s = 12
sampling_frequency_hz = 100
methods = ["quadrature", "hilbert", "finite-element"]

[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10

[[string.sections]]
name = "pipe"
repeat = 10
parts = [
    { length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.125 },
    { length_m = 0.5, inner_radius_m = 0.05, outer_radius_m = 0.15 },
]

[bit]
rock = "table"
table_kn_nm = [[0, 0], [100.0, 3e3]]
torque_static_ratio = 1.3

[method.hilbert]
transform_s = 20
[method.finite-element]
elements_per_cell = 4
gamma = 0.6

[[sites]]
distance_from_bit_m = 50

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 0.02, to = 0.6, count = 3, spacing = "log" }
weight_on_bit_kn = { values = [30, 70] }

[map]
x = "weight_on_bit_kn"
marks = [{ name = "A", surface_speed_rpm = 0.3, torque_dynamic_nm = 500 }]
"#;

const BASE: &str = "[bit]\nrock = \"sandstone\"\n[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";

const LIST: &str = "surface_speed_rpm,weight_on_bit_kn\n# slow\n0.1,50\n\n0.5,\"20\"\n";

/// What is put in the place of what was there.
const PIECES: &[&str] = &[
    "",
    "=",
    "[",
    "]",
    "[[",
    "{",
    "}",
    "\"",
    "'",
    ",",
    ".",
    "#",
    "\n",
    "\r\n",
    "-",
    "_",
    "0",
    "1e9",
    "1e999",
    "nan",
    "-inf",
    "0x_1",
    "99999999999999999999",
    "true",
    "1979-05-27",
    "[]",
    "{}",
    "\"\"",
    "base = \"sweep.toml\"\n",
    "[design]\n",
    "a.b.c = 1\n",
    "é",
    "\u{0}",
    "\u{feff}",
];

#[derive(Debug, Clone)]
enum Change {
    DropLine(usize),
    RepeatLine(usize, usize),
    SwapLines(usize, usize),
    Replace(usize, usize, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let place = 0..10_000usize;
    prop_oneof![
        place.clone().prop_map(Change::DropLine),
        (place.clone(), place.clone()).prop_map(|(line, to)| Change::RepeatLine(line, to)),
        (place.clone(), place.clone()).prop_map(|(one, other)| Change::SwapLines(one, other)),
        (place, 0..6usize, 0..PIECES.len())
            .prop_map(|(at, length, piece)| Change::Replace(at, length, piece)),
    ]
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut text = text.to_owned();
    for change in changes {
        let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
        if lines.is_empty() {
            break;
        }
        let count = lines.len();
        text = match *change {
            Change::DropLine(line) => {
                lines.remove(line % count);
                lines.concat()
            }
            Change::RepeatLine(line, to) => {
                lines.insert(to % count, lines[line % count]);
                lines.concat()
            }
            Change::SwapLines(one, other) => {
                lines.swap(one % count, other % count);
                lines.concat()
            }
            Change::Replace(at, length, piece) => {
                let characters: Vec<char> = text.chars().collect();
                let from = at % characters.len();
                let to = (from + length).min(characters.len());
                let (before, after) = (&characters[..from], &characters[to..]);
                let piece = PIECES[piece].chars();
                before
                    .iter()
                    .copied()
                    .chain(piece)
                    .chain(after.iter().copied())
                    .collect()
            }
        };
    }
    text
}

/// Reads a sweep whose files have the given texts, and tells whether it could.
fn read(folder: &Path, full: &str, base: &str, list: &str) -> bool {
    for (name, text) in [
        ("sweep.toml", full),
        ("base.toml", base),
        ("cases.csv", list),
    ] {
        std::fs::write(folder.join(name), text).unwrap();
    }
    match Sweep::read(&folder.join("sweep.toml")) {
        Ok(sweep) => {
            let cases = sweep.design.cases();
            assert!(cases > 0);
            for case in [0, cases - 1] {
                assert_eq!(sweep.design.values(case).len(), sweep.design.axes().len());
            }
            true
        }
        Err(error) => {
            let message = error.to_string();
            assert!(message.contains(folder.to_str().unwrap()), "{message}");
            false
        }
    }
}

/// The file with its own design, or with the list of its base.
fn with_design_of(base: bool) -> String {
    match base {
        false => FULL.to_owned(),
        true => FULL[..FULL.find("[design]").unwrap()].to_owned(),
    }
}

#[test]
fn the_texts_that_are_changed_can_be_read() {
    let folder = tempfile::tempdir().unwrap();
    for base in [false, true] {
        assert!(read(folder.path(), &with_design_of(base), BASE, LIST));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn no_change_of_a_sweep_file_brings_the_reader_down(
        base in any::<bool>(),
        of_file in proptest::collection::vec(change(), 0..5),
        of_base in proptest::collection::vec(change(), 0..2),
        of_list in proptest::collection::vec(change(), 0..3),
    ) {
        let folder = tempfile::tempdir().unwrap();
        read(
            folder.path(),
            &changed(&with_design_of(base), &of_file),
            &changed(BASE, &of_base),
            &changed(LIST, &of_list),
        );
    }
}
