//! What commands say to people: parts of the string as on a BHA sheet, numbers of a few
//! digits, plurals, and lines that fit a terminal.

use crate::command_line::{complaints, succeeds};
use crate::support::{Answer, SMALL, Workplace, with};

/// 5-inch pipe of 19.5 lb/ft with its joint, and 8-inch collars, from makers' tables;
/// `factor` 2 is what comes of diameters for radii.
fn five_inch(factor: f64) -> String {
    let part = |length: f64, inner: f64, outer: f64| {
        let [inner, outer] = [inner, outer].map(|inches| factor * 0.5 * 0.0254 * inches);
        format!("{{ length_m = {length}, inner_radius_m = {inner}, outer_radius_m = {outer} }}")
    };
    let sections = format!(
        "repeat = 10\nparts = [\n{},\n{},\n]\n[[string.sections]]\nname = \"collar\"\n\
         repeat = 2\nparts = [{}]\n",
        part(9.05, 4.276, 5.0),
        part(0.45, 3.25, 6.625),
        part(9.5, 2.8125, 8.0)
    );
    let (before, rest) = SMALL.split_once("repeat = 10\n").unwrap();
    let (_, after) = rest.split_once("]\n\n").unwrap();
    format!("{before}{sections}\n{after}")
}

/// The words of each line that begins with a number.
fn numbers(output: &str) -> Vec<Vec<&str>> {
    let lines = output.lines().map(|line| line.split_whitespace().collect());
    lines
        .filter(|words: &Vec<&str>| words.len() == 7 && words[0].parse::<f64>().is_ok())
        .collect()
}

#[test]
fn inspect_shows_every_part_as_a_bha_sheet_does() {
    let place = Workplace::with_small(&five_inch(1.0));
    let answer = succeeds(&place, &["inspect", "small.toml"]);
    assert!(answer.output.contains("10 × 9.500 m, pipe\n"), "{answer:?}");
    assert!(
        answer.output.contains("2 × 9.500 m, collar\n"),
        "{answer:?}"
    );
    // Plain ends of the pipe have 17.93 lb/ft; the collar, 150 lb/ft.
    assert_eq!(
        numbers(&answer.output),
        [
            ["127.0", "5.000", "108.6", "4.276", "26.7", "17.9", "9.050"],
            ["168.3", "6.625", "82.5", "3.250", "132.4", "89.0", "0.450"],
            ["203.2", "8.000", "71.4", "2.812", "222.8", "149.7", "9.500"],
        ]
    );
}

#[test]
fn diameters_for_radii_are_warned_of_and_stop_nothing() {
    let text = five_inch(2.0);
    let place = Workplace::with_small(&text);
    let line = |piece: &str| 1 + text[..text.find(piece).unwrap()].matches('\n').count();
    let (pipe, collar) = (line("{ length_m = 9.05"), line("parts = [{"));
    let expected = |line: usize, section: usize, meant: &str| {
        let key = format!("string.sections[{section}].parts[0].outer_radius_m");
        format!("warning: small.toml:{line}: `{key}`: the part {meant}")
    };
    let expected = [
        expected(pipe, 0, "is 254.0 mm (10.000 in) wide with a thin wall, "),
        expected(collar, 1, "has 891 kg/m (599 lb/ft), "),
    ];
    for command in ["inspect", "run", "simulate"] {
        let answer = place.sweep(&[command, "small.toml"]);
        assert_eq!(answer.code, 0, "{answer:?}");
        let lines: Vec<&str> = answer.errors.lines().collect();
        assert_eq!(lines.len(), 2, "{answer:?}");
        for (line, expected) in lines.iter().zip(&expected) {
            assert!(line.starts_with(expected), "no {expected:?} in {answer:?}");
        }
    }
    let answer = succeeds(&place, &["run", "small.toml", "--quiet", "--fresh"]);
    assert_eq!(answer.output, "");
}

#[test]
fn a_body_wider_than_its_joint_is_warned_of() {
    let place = Workplace::with_small(&with(
        SMALL,
        "outer_radius_m = 0.15 ",
        "outer_radius_m = 0.1 ",
    ));
    let answer = place.sweep(&["run", "small.toml"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let place = "warning: small.toml:17: `string.sections[0].parts[0].outer_radius_m`: ";
    assert!(answer.errors.starts_with(place), "{answer:?}");
    assert!(
        answer
            .errors
            .contains("wider than its joint of 200.0 mm (7.874 in)"),
        "{answer:?}"
    );
}

/// Lines of at most 80 columns, but for one that ends with a path or is a command to
/// copy; numbers of few digits; no plural of one.
#[track_caller]
fn is_for_people(answer: &Answer) {
    assert_eq!(
        (answer.code, complaints(&answer.errors).as_str()),
        (0, ""),
        "{answer:?}"
    );
    for line in answer.output.lines() {
        let is_copied = line.contains("sweep simulate ");
        assert!(
            line.chars().count() <= 80 || is_copied,
            "{line:?} in {answer:?}"
        );
        for word in line.split_whitespace() {
            let number = word.trim_matches(|c: char| !c.is_ascii_digit());
            let is_number = number.parse::<f64>().is_ok();
            let decimals = number.split_once('.').map_or("", |(_, decimals)| decimals);
            let digits = decimals.split('e').next().unwrap().len();
            assert!(!is_number || digits <= 8, "{word} in {answer:?}");
            assert_ne!(number, "0.0e0", "{answer:?}");
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        for pair in words.windows(2) {
            let thing = pair[1].trim_matches(|c: char| !c.is_alphabetic());
            let plurals = [
                "methods",
                "cases",
                "rows",
                "labels",
                "simulations",
                "steps",
                "sticks",
            ];
            let is_plural = pair[0] == "1" && plurals.contains(&thing);
            assert!(!is_plural, "{line:?} in {answer:?}");
        }
    }
}

/// At a frequency of many digits, as one by rule has; by rule itself so short a string would take
/// minutes.
fn many_digits(text: &str) -> String {
    with(
        &with(
            text,
            "sampling_frequency_hz = 100\n",
            "sampling_frequency_hz = 638.7945123\n",
        ),
        "length_m = 9.5",
        "length_m = 9.05",
    )
}

#[test]
fn words_and_numbers_are_for_people() {
    let grid = many_digits(SMALL);
    let one = many_digits(&crate::support::small_with_design(
        "[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = { values = [70] }\n",
    ));
    let long_title = "A sweep with a title that says everything that there is to say of it at once";
    let titled = with(
        &grid,
        "title = \"A small sweep\"",
        &format!("title = \"{long_title}\""),
    );
    let own = "methods = [\"quadrature\"]\n";
    let accurate = with(&titled, own, "accuracy = \"30 %\"\n");
    let accurate = with(&accurate, "repeat = 10", "repeat = 60");
    let accurate = with(&accurate, "sampling_frequency_hz = 638.7945123\n", "");
    let commands = [
        &["run", "small.toml", "--dry-run"][..],
        &["inspect", "small.toml"],
        &["simulate", "small.toml"],
        &["run", "small.toml"],
        &["summary", "results/small"],
    ];
    // These say nothing of an accuracy that those above do not, and each searches for it anew.
    let others = [
        &[
            "inspect",
            "small.toml",
            "--modes",
            "--orders",
            "1,2,3,4,6,12",
        ][..],
        &["run", "small.toml"],
        &["check", "small.toml", "results/small/labels.csv"],
    ];
    for (text, others) in [(one, &others[..]), (titled, &others), (accurate, &[])] {
        let place = Workplace::with_small(&text);
        for arguments in commands.iter().chain(others) {
            is_for_people(&place.sweep(arguments));
        }
    }
}

#[test]
fn whirl_is_described_in_as_many_columns() {
    let whirl = format!(
        "base = \"{}/../../sweeps/academic.toml\"\nmethods = [\"quadrature\"]\n\
         [wall]\nclearance_mm = 15\nfriction = 2\n[[sites]]\ndistance_from_bit_m = 0\n\
         [[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n",
        env!("CARGO_MANIFEST_DIR")
    );
    let place = Workplace::with_small(&whirl);
    for command in ["simulate", "inspect"] {
        is_for_people(&place.sweep(&[command, "small.toml"]));
    }
}

#[test]
fn help_fits_a_terminal() {
    let place = Workplace::new();
    let help = succeeds(&place, &["--help"]).output;
    let commands: Vec<&str> = (help.lines())
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next())
        .filter(|name| !name.is_empty())
        .collect();
    assert!(commands.len() > 10, "{help}");
    for command in commands {
        for line in succeeds(&place, &["help", command]).output.lines() {
            assert!(line.chars().count() <= 80, "{command}: {line:?}");
        }
    }
}
