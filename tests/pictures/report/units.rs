//! `units = "field"`: what people read is in oilfield units, and what programs read stays
//! as it is.

use crate::report::{copy_with_labels, succeeds, text, with_first_label_swapped};
use crate::support::{SMALL, Workplace, with};

/// [`SMALL`] by two methods, with a mark outside its map.
fn small() -> String {
    let two = with(
        SMALL,
        "\"quadrature\"",
        "\"quadrature\", \"finite-element\"",
    );
    with(&two, "weight_on_bit_kn = 50", "weight_on_bit_kn = 200")
}

fn in_field_units() -> String {
    format!("units = \"field\"\n{}", small())
}

/// A workplace with the same sweep in both units, each run into a folder.
fn with_both() -> Workplace {
    let place = Workplace::new();
    place.write("si.toml", small());
    place.write("field.toml", in_field_units());
    for units in ["si", "field"] {
        let file = format!("{units}.toml");
        succeeds(&place, &["run", &file, "--out", units]);
    }
    place
}

/// The words of a picture, a line each.
fn words(place: &Workplace, picture: &str) -> Vec<String> {
    let svg = text(place, picture);
    let texts = svg.split("<text").skip(1).map(|text| {
        let content = text.split_once('>').unwrap().1;
        content.split("</text>").next().unwrap().trim().to_owned()
    });
    texts.collect()
}

#[track_caller]
fn assert_said(text: &str, said: &[&str], unsaid: &[&str]) {
    for words in said {
        assert!(text.contains(words), "no {words:?} in\n{text}");
    }
    for words in unsaid {
        assert!(!text.contains(words), "{words:?} in\n{text}");
    }
}

/// 30, 70 and 200 kN are 6.744, 15.74 and 44.96 klbf.
#[test]
fn a_run_has_the_same_tables_and_other_maps() {
    let place = with_both();
    for table in ["labels.csv", "boundary.csv", "failures.csv"] {
        let [si, field] = ["si", "field"].map(|folder| text(&place, &format!("{folder}/{table}")));
        assert_eq!(si, field, "{table}");
    }
    let [si, field] = ["si", "field"].map(|folder| words(&place, &format!("{folder}/map.svg")));
    let [said_in_si, said_in_field] = [&si, &field].map(|words| words.join(" "));
    let outside = ["A (200 kN, 0.3 rpm)", "A (45 klbf, 0.3 rpm)"];
    assert_said(
        &said_in_si,
        &["Weight on bit W (kN)", outside[0]],
        &["klbf"],
    );
    assert_said(
        &said_in_field,
        &["Weight on bit W (klbf)", outside[1]],
        &["kN"],
    );
    // Round numbers on either axis.
    for (words, ticks) in [(si, ["30", "70"]), (field, ["8", "14"])] {
        let are_there = ticks
            .iter()
            .all(|tick| words.iter().any(|word| word == tick));
        assert!(are_there, "{ticks:?} in {words:?}");
    }
}

#[test]
fn summary_and_report_are_in_the_units_of_the_sweep() {
    let place = with_both();
    let [si, field] = ["si", "field"].map(|folder| succeeds(&place, &["summary", folder]).output);
    assert_said(
        &si,
        &["      30 70\n      Weight on bit W (kN)\n"],
        &["klbf"],
    );
    assert_said(
        &field,
        &["6.744 15.74\n", " Weight on bit W (klbf)\n"],
        &["kN"],
    );
    // A table of cases: of the first of several folders, if they are held against each other.
    std::fs::rename(place.path("field"), place.path("results")).unwrap();
    copy_with_labels(&place, "other", with_first_label_swapped);
    succeeds(
        &place,
        &["report", "results", "other", "--out", "both.html"],
    );
    let page = text(&place, "both.html");
    let (_, table) = page.rsplit_once("Labels that differ, all 1").unwrap();
    assert_said(
        table,
        &["weight_on_bit_klbf", "6.744"],
        &["weight_on_bit_kn<"],
    );
}

/// As with another title: nothing is run again, and everything is drawn again.
#[test]
fn other_units_are_no_other_run() {
    let place = Workplace::with_small(&small());
    let run = ["run", "small.toml", "--out", "results"];
    succeeds(&place, &run);
    let hash = |place: &Workplace| {
        let manifest = text(place, "results/manifest.json");
        let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
        manifest["meaning_sha256"].clone()
    };
    let (in_si, before) = (text(&place, "results/map.svg"), hash(&place));
    succeeds(&place, &["report", "results"]);
    place.write("small.toml", in_field_units());
    let again = succeeds(&place, &run).output;
    assert!(again.starts_with("complete already"), "{again}");
    assert!(text(&place, "results/map.svg").contains("klbf"));
    assert!(!place.path("results/report.html").exists());
    assert_eq!(hash(&place), before);
    place.write("small.toml", small());
    succeeds(&place, &run);
    assert_eq!(text(&place, "results/map.svg"), in_si);
}

/// 100 m of string, a site 50 m above the bit.
#[test]
fn a_case_and_the_linear_system_are_shown_in_units_of_the_field() {
    let place = Workplace::new();
    place.write("si.toml", small());
    place.write("field.toml", in_field_units());
    let simulate = |units: &str| {
        let file = format!("{units}.toml");
        let out = format!("{units}-case");
        let case = ["simulate", &file, "--case", "1", "--out", &out];
        succeeds(&place, &case).output
    };
    let [si, field] = ["si", "field"].map(simulate);
    assert_said(&si, &["T_d = ", " N m\n"], &["lbf"]);
    assert_said(&field, &["T_d = ", " lbf ft\n"], &["N m"]);
    for table in ["case.csv", "history.csv"] {
        let [si, field] =
            ["si-case", "field-case"].map(|it| text(&place, &format!("{it}/{table}")));
        assert_eq!(si, field, "{table}");
    }
    let drawn = words(&place, "field-case/history.svg").join(" ");
    let labels = [
        "Torque on bit (klbf ft)",
        "Speed 164.04 ft above the bit (rpm)",
    ];
    assert_said(&drawn, &labels, &["kN"]);
    let inspected = succeeds(&place, &["inspect", "field.toml", "--out", "inspected"]).output;
    let lines = [
        "length                     328.084 ft\n",
        "  10 × 32.808 ft, pipe\n",
        " lbf ft/rad\n",
        " ft/s\n",
        " rad/s per lbf ft\n",
    ];
    assert_said(&inspected, &lines, &[" N m", "m/s"]);
    let drawn = words(&place, "inspected/inspect.svg").join(" ");
    assert_said(&drawn, &["rad/s per lbf ft)"], &["N m"]);
}
