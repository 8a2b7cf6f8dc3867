//! What is not written as a number, a type or TOML at all.

use crate::refusals::{RUN, each_is_refused, line_of, refused, refused_at};
use crate::support::{SMALL, Workplace, small_with_design, with};

#[test]
fn what_is_no_number_is_refused_wherever_it_stands() {
    for value in ["nan", "inf", "-inf", "+nan"] {
        for (key, piece) in [
            ("surface_speed_rpm", "surface_speed_rpm = 60"),
            ("time_s", "time_s = 12"),
            ("sampling_frequency_hz", "sampling_frequency_hz = 100"),
            ("string.shear_modulus_gpa", "shear_modulus_gpa = 80"),
            ("string.density_kg_m3", "density_kg_m3 = 7840"),
            (
                "string.torsional_damping_nms_rad_m",
                "torsional_damping_nms_rad_m = 10",
            ),
            ("string.sections[0].parts[0].length_m", "length_m = 9.5"),
            (
                "string.sections[0].parts[0].inner_radius_m",
                "inner_radius_m = 0.05",
            ),
            (
                "string.sections[0].parts[0].outer_radius_m",
                "outer_radius_m = 0.125",
            ),
            ("sites[0].distance_from_bit_m", "distance_from_bit_m = 50"),
            ("design.axes.surface_speed_rpm.from", "from = 0.02"),
            ("design.axes.surface_speed_rpm.to", "to = 0.6"),
            ("map.marks[0].surface_speed_rpm", "surface_speed_rpm = 0.3"),
            ("map.marks[0].weight_on_bit_kn", "weight_on_bit_kn = 50"),
        ] {
            let name = piece.split(" = ").next().unwrap();
            let at = format!("{name} = {value}");
            refused_at(&with(SMALL, piece, &at), &at, key, "");
        }
        let key = "design.axes.weight_on_bit_kn.values[0]";
        refused_at(&with(SMALL, "[30, ", &format!("[{value}, ")), "70", key, "");
        for key in [
            "torque_static_ratio",
            "weight_on_bit_kn",
            "torque_dynamic_nm",
        ] {
            let at = format!("{key} = {value}");
            let text = with(SMALL, "[bit]", &format!("[bit]\n{at}"));
            refused_at(&text, &at, &format!("bit.{key}"), "is not between");
        }
        let at = format!("table_kn_nm = [[0, 0], [100, {value}]]");
        let text = with(
            SMALL,
            "rock = \"sandstone\"",
            &format!("rock = \"table\"\n{at}"),
        );
        refused_at(&text, &at, "bit.table_kn_nm[1]", "is not between");
    }
}

#[test]
fn a_value_of_another_type_is_refused() {
    each_is_refused(
        r#"
        rpm = 60 => rpm = "60" | surface_speed_rpm | expected a number, found
        rpm = 60 => rpm = [60] | surface_speed_rpm | expected a number, found
        time_s = 12 => time_s = "atuo" | time_s | a number or "auto"
        time_s = 12 => time_s = true | time_s | a number or "auto"
        [[sites]] => [sites] | sites | expected an array, found a table
        [bit] => [[bit]] | bit[0] | found a table
        ["quadrature"] => "quadrature" | methods | expected an array
        "sandstone" => 3 | bit.rock | expected a string
        "grid" => 3 | design.kind | expected a string
        count = 3 => count = 3.5 | design.axes.surface_speed_rpm.count | expected a whole number, zero or more, found
        count = 3 => count = -3 | design.axes.surface_speed_rpm.count | expected a whole number, zero or more, found
        repeat = 10 => repeat = 1e1 | string.sections[0].repeat | expected a whole number, zero or more, found
        title = "A small sweep" => title = 9 | title | expected a string
        title = "A small sweep" => units = 9 | units | expected a string
        "#,
    );
}

#[test]
fn an_unknown_choice_is_refused() {
    each_is_refused(
        r#"
        title = "A small sweep" => units = "feild" | units | unknown choice `feild`; did you mean `field`?
        title = "A small sweep" => units = "imperial" | units | unknown choice `imperial`; known here: si, field
        title = "A small sweep" => units = "SI" | units | unknown choice `SI`
        "#,
    );
}

#[test]
fn a_whole_number_too_large_is_refused() {
    const HUGE: &str = "99999999999999999999";
    let text = with(SMALL, "count = 3", &format!("count = {HUGE}"));
    refused_at(
        &text,
        HUGE,
        "design.axes.surface_speed_rpm.count",
        "a whole number",
    );
    let text = with(SMALL, "time_s = 12", &format!("time_s = {HUGE}"));
    refused_at(&text, HUGE, "time_s", "is not between");
    let random = format!("[design]\nkind = \"monte-carlo\"\ncases = 3\nseed = {HUGE}");
    refused_at(
        &small_with_design(&random),
        HUGE,
        "design.seed",
        "a whole number",
    );
}

#[test]
fn what_is_no_toml_is_shown_with_its_line() {
    for (piece, instead, at, meant) in [
        ("time_s = 12", "time_s = = 12", "= = 12", "`time_s = = 12`"),
        ("time_s = 12", "time_s = 1.2.3", "1.2.3", "`time_s = 1.2.3`"),
        (
            "time_s = 12",
            "time_s = 12\ntime_s = 13",
            "13",
            "duplicate key: `time_s = 13`",
        ),
        ("[bit]", "[string]", "rock", "duplicate key"),
        (
            "title = \"A small sweep\"",
            "title = \"A",
            "title",
            "`title = \"A`",
        ),
    ] {
        let text = with(SMALL, piece, instead);
        let mut line = line_of(&text, at);
        if at == "rock" {
            line -= 1;
        }
        refused(
            &Workplace::with_small(&text),
            &RUN,
            &[&format!("error: small.toml:{line}: "), meant],
        );
    }
}

#[test]
fn lines_are_counted_as_an_editor_does() {
    let windows = with(SMALL, "time_s = 12", "time_s = -12").replace('\n', "\r\n");
    refused_at(&windows, "-12", "time_s", "");
    refused_at(&format!("\u{feff}{windows}"), "-12", "time_s", "");
}

/// A title, a section or a mark that steers a terminal or turns the text around it.
#[test]
fn control_characters_in_texts_are_refused() {
    for (escape, letter) in [
        ("\\u001b[31m", "control character U+001B"),
        ("\\u0007", "control character U+0007"),
        ("\\n", "control character U+000A"),
        ("\\u009b31m", "control character U+009B"),
        ("\\u202egnp.exe", "control character U+202E"),
        ("\\u2066", "control character U+2066"),
        // No picture can hold these.
        ("\\uFFFE", "noncharacter U+FFFE"),
        ("\\uFFFF", "noncharacter U+FFFF"),
    ] {
        let meant = format!("has the {letter}: leave it out");
        for (piece, key) in [
            ("\"A small sweep\"", "title"),
            ("\"pipe\"", "string.sections[0].name"),
            ("\"A\"", "map.marks[0].name"),
        ] {
            let text = with(SMALL, piece, &format!("\"a{escape}\""));
            refused_at(&text, escape, key, &meant);
        }
    }
    // Letters of any script are no control characters.
    let text = with(
        SMALL,
        "\"A small sweep\"",
        "\"Μικρή δοκιμή, סדרה קטנה, 小さな掃引\"",
    );
    let answer = Workplace::with_small(&text).sweep(&RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
}
