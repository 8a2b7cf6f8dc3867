//! Lists of cases as spreadsheets export them: read where they mean one thing, else
//! refused with the cause.

use crate::bad_input::other_files::with_list;
use crate::refusals::{RUN, refused};
use crate::support::Workplace;

/// `labels.csv` of the small sweep over a list.
#[track_caller]
fn labels_of(place: &Workplace) -> String {
    let answer = place.sweep(&RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
    std::fs::read_to_string(place.path("results/labels.csv")).unwrap()
}

#[test]
fn a_list_is_the_same_from_any_program() {
    let plain = "surface_speed_rpm,weight_on_bit_kn\n0.125,50\n0.5,150.5\n";
    let expected = labels_of(&with_list(plain));
    let quoted = "\"surface_speed_rpm\",\"weight_on_bit_kn\"\n\"0.125\",\"50\"\n0.5,\"150.5\"\n";
    for text in [
        quoted.to_owned(),
        plain.replace(',', ";"),
        plain.replace(',', "\t"),
        plain.replace(',', ";").replace('.', ","),
        // Lines of other systems, and the mark of a third.
        format!("\u{feff}{}", plain.replace('\n', "\r\n")),
        plain.replace('\n', "\r"),
        // A range of cells that was once larger.
        format!("{}\n,,,\n,,,\n", plain.trim_end().replace('\n', ",,\n")),
        format!(
            "# cases;;\n\"# slow; fast\";;\n;;\n{}",
            plain.replace(',', ";")
        ),
        plain.replacen('\n', ",,\n", 1),
        plain.replace(',', " , "),
    ] {
        assert_eq!(labels_of(&with_list(&text)), expected, "{text:?}");
    }
}

#[test]
fn an_export_that_may_mean_two_things_is_refused_with_the_cause() {
    let commas = "surface_speed_rpm,weight_on_bit_kn\n";
    let semicolons = "surface_speed_rpm;weight_on_bit_kn\n";
    let decimal = "numbers with decimal commas need semicolons between them";
    for (text, line, meant) in [
        (
            format!("{commas}0.1,50\n0,1,50\n"),
            3,
            format!("3 values, but 2 columns; {decimal}"),
        ),
        (
            "surface_speed_rpm\n0,1\n".to_owned(),
            2,
            format!("2 values, but 1 column; {decimal}"),
        ),
        (
            format!("{semicolons}\n;\n0,1;1,500\n"),
            4,
            "weight_on_bit_kn: `1,500` may be 1.5 or 1500: write it without a comma".to_owned(),
        ),
        (
            format!("{semicolons}0,1;15.00,5\n"),
            2,
            "weight_on_bit_kn: `15.00,5` is not a number".to_owned(),
        ),
        (
            format!("{semicolons}0,1;50;3\n"),
            2,
            "3 values, but 2 columns".to_owned(),
        ),
    ] {
        let at = format!("small.toml:29: `design.file`: cases.csv:{line}: {meant}\n");
        refused(&with_list(text), &RUN, &[&at]);
    }
}

#[test]
fn a_list_in_another_encoding_is_refused_by_its_name() {
    let text = "# vérifié\nsurface_speed_rpm,weight_on_bit_kn\n0.1,50\n";
    let latin: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    let at = "`design.file`: cases.csv cannot be read: ";
    let meant = "byte 0xE9 on line 1 is not UTF-8; if this is text, it may be Latin-1: save it";
    refused(&with_list(latin), &RUN, &[at, meant]);
    for order in [u16::to_le_bytes, u16::to_be_bytes] {
        let units = std::iter::once(0xfeff).chain(text.encode_utf16());
        let bytes: Vec<u8> = units.flat_map(order).collect();
        refused(
            &with_list(bytes),
            &RUN,
            &[at, "it is UTF-16; save it as UTF-8"],
        );
    }
}
