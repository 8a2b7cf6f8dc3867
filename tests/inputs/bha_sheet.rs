//! A string from a BHA sheet: the same string however the sheet is written, and mistakes in one
//! refused with file and line.

use crate::refusals::{RUN, refused};
use crate::support::Workplace;

/// A sweep of a string of these lines of `[string]`.
fn sweep(string: &str) -> String {
    format!(
        "time_s = 20\nmethods = [\"quadrature\"]\nsampling_frequency_hz = 100\n\n[string]\n\
         shear_modulus_gpa = 80\ndensity_kg_m3 = 7850\ntorsional_damping_nms_rad_m = 1\n{string}\n\
         [bit]\nrock = \"sandstone\"\n\n[design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = {{ values = [1, 20] }}\nweight_on_bit_kn = {{ values = [30, 90] }}\n"
    )
}

const SHEET: &str = "\
# a string
Element,Joints,OD (in),ID (mm),Length [m],thread
Drillpipe,100,5,100,950,NC50
Collar,10,8,75,95,
";

/// `labels.csv` of a sweep, with these files in its folder.
#[track_caller]
fn labels(string: &str, files: &[(&str, &[u8])]) -> String {
    let place = Workplace::with_small(&sweep(string));
    for (name, content) in files {
        place.write(name, content);
    }
    let answer = place.sweep(&RUN);
    assert_eq!(answer.code, 0, "{answer:?}");
    std::fs::read_to_string(place.path("results/labels.csv")).unwrap()
}

#[test]
fn a_string_is_the_same_however_its_sheet_is_written() {
    let by_hand = "[[string.sections]]\nrepeat = 100\n\
        parts = [{ length_m = 9.5, outer_diameter_in = 5, inner_diameter_mm = 100 }]\n\
        [[string.sections]]\nrepeat = 10\n\
        parts = [{ length_m = 9.5, outer_diameter_in = 8, inner_diameter_mm = 75 }]\n";
    let expected = labels(by_hand, &[]);
    let file = "file = \"bha.csv\"";
    assert_eq!(labels(file, &[("bha.csv", SHEET.as_bytes())]), expected);
    let semicolons = SHEET.replace(',', ";").replace("OD (in);", "od_mm;");
    let semicolons = semicolons.replace(";5;", ";127;").replace(";8;", ";203,2;");
    assert_eq!(
        labels(file, &[("bha.csv", semicolons.as_bytes())]),
        expected
    );
    let mut lines: Vec<&str> = SHEET.lines().collect();
    lines[2..].reverse();
    let upwards = lines.join("\n");
    let from_bit = format!("{file}\norder = \"from-bit\"");
    assert_eq!(
        labels(&from_bit, &[("bha.csv", upwards.as_bytes())]),
        expected
    );
    let rows: Vec<Vec<&str>> = SHEET
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect())
        .collect();
    let workbook = crate::workbook::xlsx(&rows);
    assert_eq!(
        labels("file = \"bha.xlsx\"", &[("bha.xlsx", &workbook)]),
        expected
    );
}

/// A sheet lies over the sections of a base, and sections over its sheet.
#[test]
fn a_sheet_and_sections_replace_one_another_over_a_base() {
    let place = Workplace::with_small("base = \"other.toml\"\n[string]\nfile = \"bha.csv\"\n");
    let sections = "[[string.sections]]\nrepeat = 1\n\
        parts = [{ length_m = 95, outer_radius_m = 0.1, inner_radius_m = 0.04 }]\n";
    place.write("other.toml", sweep(sections));
    place.write("bha.csv", SHEET);
    let answer = place.sweep(&["inspect", "small.toml", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(answer.output.contains("1045.000 m"), "{}", answer.output);
    // Ignored columns are reported.
    assert!(answer.errors.contains("ignored columns: `thread`"));
    place.write("other.toml", sweep("file = \"bha.csv\""));
    place.write("small.toml", format!("base = \"other.toml\"\n{sections}"));
    let answer = place.sweep(&["inspect", "small.toml", "--out", "looked"]);
    assert!(answer.output.contains(" 95.000 m"), "{answer:?}");
}

#[test]
fn a_weight_makes_tool_joints_and_a_doubtful_one_is_reported() {
    let sheet = "element,joints,od_in,id_in,length_m,weight_kg\n\
        Drillpipe,100,5,4.276,950,32000\nCollar,10,8,3,95,30000\n";
    let place = Workplace::with_small(&sweep("file = \"bha.csv\""));
    place.write("bha.csv", sheet);
    let answer = place.sweep(&["inspect", "small.toml", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let words = answer
        .output
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(words.contains("100 tool joints of 6.25 in"), "{words}");
    let reported = "warning: bha.csv:3: Collar: its weight is 44.3 % more than that of its \
                dimensions, which are taken";
    assert!(answer.errors.contains(reported), "{}", answer.errors);
}

#[test]
fn mistakes_in_a_sheet_are_refused_with_file_and_line() {
    let file = "file = \"bha.csv\"";
    let header = "element,od_in,id_in,length_m\n";
    for (sheet, words) in [
        (
            String::new(),
            "bha.csv:1: there is no column with an outer diameter",
        ),
        (header.to_owned(), "bha.csv has no row"),
        (
            "od_in,od_mm,id_in,length_m\n".to_owned(),
            "bha.csv:1: the columns `od_in` and `od_mm` say the same",
        ),
        (
            format!("{header}pipe,5,,9\n"),
            "bha.csv:2: id_in: the cell is empty",
        ),
        (
            format!("{header}pipe,5,4,9\n\npipe,5,4,x\n"),
            "bha.csv:4: length_m: `x` is not a number",
        ),
        (
            format!("{header}pipe,5,6,9\n"),
            "bha.csv:2: an inner diameter of 6.000 in",
        ),
        (
            format!("{header}pipe,5,4,-9\n"),
            "bha.csv:2: length_m: -9 is not a positive number",
        ),
        (
            format!("{header}pipe,5,4,9,3\n"),
            "bha.csv:2: 5 values, but 4 columns",
        ),
        (
            "od_in,id_in,length_m,tj_od_in,tj_length_m\n5,4,9,6,9\n".to_owned(),
            "bha.csv:2: a tool joint of 9.000 m is not shorter than the joint, 9.000 m",
        ),
        (
            format!("{header}pipe,500,4,9\n"),
            "bha.csv:2: half the outer diameter: 6.35 m",
        ),
    ] {
        let place = Workplace::with_small(&sweep(file));
        place.write("bha.csv", &sheet);
        refused(
            &place,
            &RUN,
            &["error: small.toml:9: `string.file`: ", words],
        );
    }
    for (string, words) in [
        ("file = \"none.csv\"", "none.csv cannot be read"),
        ("file = \"none.xlsx\"", "none.xlsx cannot be read"),
        ("order = \"from-bit\"", "small.toml:9: `string.order`"),
        (
            "sections = []\nfile = \"a.csv\"",
            "small.toml:10: `file`: conflicts with `sections`: give only one",
        ),
    ] {
        refused(&Workplace::with_small(&sweep(string)), &RUN, &[words]);
    }
    let place = Workplace::with_small(&sweep("file = \"bha.xlsx\""));
    place.write("bha.xlsx", "no workbook");
    refused(
        &place,
        &RUN,
        &["small.toml:9: `string.file`: bha.xlsx cannot be read"],
    );
}

#[test]
fn the_sheet_that_is_shipped_is_a_string() {
    let sheet = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/bha_12in.csv");
    let place = Workplace::with_small(&sweep("file = \"bha_12in.csv\""));
    std::fs::copy(sheet, place.path("bha_12in.csv")).unwrap();
    let answer = place.sweep(&["inspect", "small.toml", "--out", "looked"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(answer.output.contains("4182.420 m"), "{}", answer.output);
    assert!(
        answer.output.contains("424 tool joints"),
        "{}",
        answer.output
    );
}
