//! Any change of a sweep file gives, when read, a sweep or a message.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::TestRunner;

use super::Case;
use crate::plan::{Setting, Sweep};
use crate::sweep_file::SweepFileError;

/// Inputs made by changing a sweep file, each read in some milliseconds. A sixth can still be read.
/// `INPUTS=30000` for as many of each kind.
const CHANGED: u32 = 6_000;

/// Inputs made up from lines, keys and values. A seventh can be read.
const MADE_UP: u32 = 40_000;

/// What the shipped files do not say.
const MORE: &str = r#"
base = "academic.toml"
time_s = "auto"
sampling_frequency_hz = "auto"

[string.bending]
compression_kn = 20
surface = "pinned"

[bit]
rock = "law"
torque_static_ratio = 1.3

[bit.law]
bit_radius_m = 0.15
specific_energy_mpa = 60
cutting_ratio = 0.6
friction = 0.5
contact_strength_mpa = 60
contact_growth = 5
wear_flat_mm = 5
poor_cleaning_from_kn = 200
poor_cleaning_nm_per_kn = 10

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
torsional_damping_nms_rad_m = { from = 50, to = 70, count = 2 }
section_0_repeat = { from = 80, to = 90, count = 2 }
section_1_part_0_outer_radius_m = { values = [0.15, 0.16] }
site_0_distance_from_bit_m = { values = [40, 60] }
"#;

/// A rock's table, and as many axes of conditions as there can be.
const TABLE: &str = r#"
base = "fig10.toml"

[bit]
rock = "table"
table_kn_nm = [[0, 0], [100.0, 3e3]]

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 10, to = 60, count = 30 }
weight_on_bit_kn = { from = 10, to = 60, count = 30 }
impulse_ratio = { from = 1, to = 3, count = 30 }
friction = { from = 0, to = 3, count = 30 }
"#;

/// Axes of a string that touches a wall.
const STRINGS: &str = r#"
base = "fig10.toml"

[design]
kind = "grid"

[design.axes]
torsional_damping_nms_rad_m = { values = [5, 10] }
bending_damping_ns_m2 = { values = [0, 2000] }
compression_kn = { from = -50, to = 50, count = 3 }
section_0_repeat = { from = 20, to = 90, count = 2 }
section_0_part_0_length_m = { values = [9] }
section_0_part_1_inner_radius_m = { values = [0.04] }
section_1_part_0_outer_radius_m = { values = [0.16] }
site_0_distance_from_bit_m = { from = 0, to = 1, count = 2 }
friction = { values = [1, 2] }
stiffness_gn_m15 = { values = [1] }
site_0_clearance_mm = { values = [15] }
"#;

/// Texts put into files, in addition to words of the files.
static PIECES: LazyLock<Vec<String>> = LazyLock::new(|| {
    #[rustfmt::skip]
    let short = [
        "", "=", "[", "]", "[[", "{", "}", "\"", "'", "\"\"\"", ",", ".", "#", "\n", "\r\n", "\\",
        "-", "_", "0", "-0.0", "1", "-1", "1e-3", "1e9", "1e308", "-1e308", "5e-324", "1e999",
        "nan", "-nan", "inf", "-inf", "0x_1", "0xff", "0b1", "1_000_000", "1000001", "65536",
        "4294967296", "9223372036854775807", "-9223372036854775808", "99999999999999999999",
        "1000000000000000000", "true", "1979-05-27", "[]", "[[]]", "[[0, 0]]", "{}", "[{}]",
        "{ a = { b = [{ c = 1 }] } }", "\"\"", "\"a\\nb\\u001b\"", "[1, 2]", "[nan, \"\", {}]",
        "base = \"sweep.toml\"\n", "[design]\n", "a.b.c = 1\n", "é", "\u{0}", "\u{feff}",
    ];
    let long = [
        format!("[{}]", "1, ".repeat(2000)),
        format!("[{}]", "{ distance_from_bit_m = 1 }, ".repeat(200)),
        format!("{}{}", "[".repeat(200), "]".repeat(200)),
        format!("{}1{}", "{ a = ".repeat(60), " }".repeat(60)),
        format!("{}a", "a.".repeat(60)),
        format!("\"{}\"", "x".repeat(5000)),
        "9".repeat(400),
    ];
    short.map(str::to_owned).into_iter().chain(long).collect()
});

/// Every sweep file and list that is shipped, and the three above, by name.
static SHIPPED: LazyLock<BTreeMap<PathBuf, Vec<u8>>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    let files = std::fs::read_dir(folder).unwrap().map(|file| {
        let file = file.unwrap();
        let text = std::fs::read(file.path()).unwrap();
        (PathBuf::from(file.file_name()), text)
    });
    let own = [
        ("more.toml", MORE),
        ("table.toml", TABLE),
        ("strings.toml", STRINGS),
    ];
    files
        .chain(own.map(|(name, text)| (name.into(), text.into())))
        .collect()
});

/// Every sweep file together with the files that are read for it, itself first.
static SWEEPS: LazyLock<Vec<Vec<PathBuf>>> = LazyLock::new(|| {
    let is_sweep = |path: &&PathBuf| path.extension().is_some_and(|ending| ending == "toml");
    SHIPPED
        .keys()
        .filter(is_sweep)
        .map(|path| files_of(path))
        .collect()
});

fn files_of(path: &Path) -> Vec<PathBuf> {
    let read = RefCell::new(Vec::new());
    let sweep = Sweep::read_from(path, &[], &|path, _| {
        read.borrow_mut().push(path.to_owned());
        text_of(path, &BTreeMap::new())
    });
    sweep.unwrap_or_else(|error| panic!("{error}"));
    read.into_inner()
}

/// Every line of them.
static LINES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let texts = SHIPPED.values().map(|text| String::from_utf8_lossy(text));
    let lines: BTreeSet<String> = texts
        .flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>())
        .filter(|line| !line.starts_with('#') && !line.is_empty())
        .collect();
    lines.into_iter().collect()
});

/// Every key and name in them.
static WORDS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let split = |line: &String| -> Vec<String> {
        line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '-'))
            .filter(|word| word.starts_with(|c: char| c.is_ascii_lowercase()))
            .map(str::to_owned)
            .collect()
    };
    let words: BTreeSet<String> = LINES.iter().flat_map(split).collect();
    words.into_iter().collect()
});

/// A change at some place of a text.
#[derive(Debug, Clone)]
enum Change {
    DropLine(Index),
    /// A line of any file.
    AddLine(Index, String),
    /// What follows the `=` of a line.
    SetValue(Index, String),
    /// A word or a number anywhere.
    SetToken(Index, String),
    /// Some bytes.
    Replace(Index, usize, String),
    FlipBit(Index, u8),
}

fn piece() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => select(&PIECES[..]),
        1 => select(&WORDS[..]),
        1 => select(&WORDS[..]).prop_map(|word| format!("\"{word}\"")),
        1 => any::<f64>().prop_map(|number| format!("{number:e}")),
        1 => (0..200i64).prop_map(|number| number.to_string()),
    ]
}

fn change() -> impl Strategy<Value = Change> {
    let place = any::<Index>;
    prop_oneof![
        1 => place().prop_map(Change::DropLine),
        4 => (place(), select(&LINES[..])).prop_map(|(to, line)| Change::AddLine(to, line)),
        3 => (place(), piece()).prop_map(|(line, piece)| Change::SetValue(line, piece)),
        5 => (place(), piece()).prop_map(|(token, piece)| Change::SetToken(token, piece)),
        1 => (place(), 0..6usize, piece())
            .prop_map(|(at, length, piece)| Change::Replace(at, length, piece)),
        1 => (place(), 0..8u8).prop_map(|(at, bit)| Change::FlipBit(at, bit)),
    ]
}

/// Words and numbers: what stands between these.
fn is_between_tokens(byte: u8) -> bool {
    b" \t\r\n=,[]{}".contains(&byte)
}

fn changed(text: &[u8], change: &Change) -> Vec<u8> {
    if text.is_empty() {
        return Vec::new();
    }
    let mut lines: Vec<&[u8]> = text.split_inclusive(|&byte| byte == b'\n').collect();
    let count = lines.len();
    let replaced = |from: usize, to: usize, piece: &str| {
        [&text[..from], piece.as_bytes(), &text[to..]].concat()
    };
    match change {
        Change::DropLine(line) => {
            lines.remove(line.index(count));
            lines.concat()
        }
        Change::AddLine(to, line) => {
            let line = format!("{line}\n");
            lines.insert(to.index(count), line.as_bytes());
            lines.concat()
        }
        Change::SetValue(line, piece) => {
            let index = line.index(count);
            let end = lines[index].iter().position(|&byte| byte == b'=');
            let key = end.map_or(&b"x "[..], |end| &lines[index][..end]);
            let line = [key, b"= ", piece.as_bytes(), b"\n"].concat();
            lines[index] = &line;
            lines.concat()
        }
        Change::SetToken(token, piece) => {
            let starts: Vec<usize> = (0..text.len())
                .filter(|&at| {
                    !is_between_tokens(text[at]) && (at == 0 || is_between_tokens(text[at - 1]))
                })
                .collect();
            if starts.is_empty() {
                return text.to_owned();
            }
            let from = starts[token.index(starts.len())];
            let length = text[from..]
                .iter()
                .position(|&byte| is_between_tokens(byte));
            let to = length.map_or(text.len(), |length| from + length);
            replaced(from, to, piece)
        }
        Change::Replace(at, length, piece) => {
            let from = at.index(text.len());
            replaced(from, (from + length).min(text.len()), piece)
        }
        Change::FlipBit(at, bit) => {
            let at = at.index(text.len());
            [&text[..at], &[text[at] ^ 1 << bit], &text[at + 1..]].concat()
        }
    }
}

type Texts = BTreeMap<PathBuf, Vec<u8>>;

/// The text of a file, as the disk would give it.
fn text_of(path: &Path, instead: &Texts) -> std::io::Result<String> {
    let text = instead.get(path).or_else(|| SHIPPED.get(path));
    let text = text.ok_or(ErrorKind::NotFound)?.clone();
    String::from_utf8(text).map_err(|error| std::io::Error::new(ErrorKind::InvalidData, error))
}

/// Reads the sweep file at `path`, some texts being others than are shipped, and
/// does what a run does before it simulates; tells whether there is something to
/// run.
fn read(path: &Path, instead: &Texts) -> bool {
    let sweep = match Sweep::read_from(path, &[], &|path, _| text_of(path, instead)) {
        Ok(sweep) => sweep,
        Err(error) => {
            is_a_sentence(&error, instead);
            return false;
        }
    };
    let design = &sweep.design;
    assert!(design.cases() > 0 && design.strings() > 0);
    for string in [0, design.strings() - 1] {
        let cases = design.cases_of_string(string);
        for position in [0, cases - 1] {
            let index = design.case_of_string(string, position);
            assert!(index < design.cases());
            let values = design.values(index);
            assert_eq!(values.len(), design.axes().len());
            for (&axis, &value) in design.axes().iter().zip(&values) {
                assert_eq!(axis.check(value), Ok(()));
            }
            match sweep.setting_at(&values) {
                Ok(setting) => can_be_run(&sweep, &setting, index),
                Err(error) => is_a_sentence(&error, instead),
            }
        }
    }
    true
}

/// An error is one line that begins with the name of a file.
fn is_a_sentence(error: &SweepFileError, instead: &Texts) {
    let message = error.to_string();
    let mut files = instead.keys().chain(SHIPPED.keys());
    let named = files.any(|file| message.starts_with(file.to_str().unwrap()));
    assert!(named, "{message}");
    assert!(!message.contains(char::is_control), "{message:?}");
}

/// A case takes some time, or is outside its rock's table.
fn can_be_run(sweep: &Sweep, setting: &Setting, index: usize) {
    if let Ok(case) = Case::of(sweep, setting, index) {
        let duration = case.scene.timing.duration;
        assert!(duration > 0.0 && duration.is_finite(), "{duration}");
    }
}

/// Runs a test. Were too few inputs readable, it would see little more than the
/// TOML parser.
fn run<S: Strategy>(cases: u32, inputs: S, test: impl Fn(S::Value) -> bool) {
    let asked = std::env::var("INPUTS").ok();
    let cases = asked.map_or(cases, |count| count.parse().unwrap());
    let readable = Cell::new(0);
    let config = ProptestConfig {
        source_file: Some(file!()),
        ..ProptestConfig::with_cases(cases)
    };
    let result = TestRunner::new(config).run(&inputs, |input| {
        readable.set(readable.get() + u32::from(test(input)));
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
    let readable = readable.get();
    assert!(readable > cases / 20, "{readable} of {cases} could be read");
}

#[test]
fn no_change_of_a_sweep_file_brings_the_reader_down() {
    let file = prop_oneof![3 => Just(0usize), 1 => 0..8usize];
    let changes = vec((file, change()), 1..5);
    let inputs = (select(&SWEEPS[..]), changes);
    run(CHANGED, inputs, |(files, changes)| {
        let mut texts = Texts::new();
        for (file, change) in changes {
            let path = &files[file % files.len()];
            let text = texts.get(path).unwrap_or_else(|| &SHIPPED[path]);
            let text = changed(text, &change);
            texts.insert(path.clone(), text);
        }
        read(&files[0], &texts)
    });
}

/// A value of any depth.
fn value() -> impl Strategy<Value = String> {
    piece().prop_recursive(3, 12, 4, |value| {
        prop_oneof![
            vec(value.clone(), 0..4).prop_map(|items| format!("[{}]", items.join(", "))),
            vec((select(&WORDS[..]), value), 0..4).prop_map(|entries| {
                let entries: Vec<String> = (entries.iter())
                    .map(|(key, value)| format!("{key} = {value}"))
                    .collect();
                format!("{{ {} }}", entries.join(", "))
            }),
        ]
    })
}

fn line() -> impl Strategy<Value = String> {
    let word = || select(&WORDS[..]);
    prop_oneof![
        8 => select(&LINES[..]),
        2 => (word(), value()).prop_map(|(key, value)| format!("{key} = {value}")),
        1 => (word(), word(), value()).prop_map(|(one, two, value)| format!("{one}.{two} = {value}")),
        1 => vec(word(), 1..4).prop_map(|words| format!("[{}]", words.join("."))),
        1 => vec(word(), 1..4).prop_map(|words| format!("[[{}]]", words.join("."))),
        1 => ".{0,20}",
    ]
}

#[test]
fn no_made_up_text_brings_the_reader_down() {
    let base = select(vec![
        "",
        "base = \"academic.toml\"\n",
        "base = \"fig09.toml\"\n",
        "base = \"fig17.toml\"\n",
    ]);
    run(MADE_UP, (base, vec(line(), 0..6)), |(base, lines)| {
        let text = format!("{base}{}\n", lines.join("\n"));
        let path = PathBuf::from("sweep.toml");
        read(&path, &Texts::from([(path.clone(), text.into_bytes())]))
    });
}
