//! `sweep summary` and `sweep report`: the numbers they show, and a page that needs
//! nothing but itself.

mod large;
mod opening;
mod page;
mod units;

use crate::support::{Answer, SMALL, Workplace, small_with_design, with};
use crate::tables::write_table;

/// A workplace with a small sweep by two methods, run into `results`.
fn with_results() -> Workplace {
    let two = "\"quadrature\", \"finite-element\"";
    let place = Workplace::with_small(&with(SMALL, "\"quadrature\"", two));
    succeeds(&place, &["run", "small.toml", "--out", "results"]);
    place
}

#[track_caller]
fn succeeds(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.sweep(arguments);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""), "{answer:?}");
    answer
}

fn text(place: &Workplace, file: &str) -> String {
    std::fs::read_to_string(place.path(file)).unwrap()
}

/// A text of the terminal with its paragraphs on one line each.
fn unwrapped(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Copies a results folder, with `labels.csv` changed.
fn copy_with_labels(place: &Workplace, folder: &str, change: impl Fn(String) -> String) {
    std::fs::create_dir(place.path(folder)).unwrap();
    for entry in std::fs::read_dir(place.path("results")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let content = std::fs::read(place.path(&format!("results/{name}"))).unwrap();
        place.write(&format!("{folder}/{name}"), content);
    }
    let labels = change(text(place, "results/labels.csv"));
    write_table(place, folder, "labels.csv", labels);
}

/// Swaps the label of the first row.
fn with_first_label_swapped(labels: String) -> String {
    let row = labels.lines().nth(1).unwrap();
    let swapped = if row.contains(",stick_slip,") {
        row.replace(",stick_slip,", ",smooth,")
    } else {
        row.replace(",smooth,", ",stick_slip,")
    };
    assert_ne!(row, swapped);
    with(&labels, row, &swapped)
}

#[test]
fn the_summary_counts_the_rows_of_labels() {
    let place = with_results();
    let summary = succeeds(&place, &["summary", "results"]).output;
    let labels = text(&place, "results/labels.csv");
    let count = |method: &str, label: &str| {
        let of_both = |row: &&str| row.contains(&format!(",{method},")) && row.contains(label);
        labels.lines().filter(of_both).count().to_string()
    };
    let regimes = summary.split("Cases of each regime").nth(1).unwrap();
    for method in ["quadrature", "finite-element"] {
        let row = regimes.lines().find(|line| line.trim().starts_with(method));
        let cells: Vec<&str> = row.unwrap().split_whitespace().collect();
        let expected = [",smooth,", ",stick_slip,"].map(|label| count(method, label));
        assert_eq!(cells[1..3], expected, "{summary}");
        assert_eq!(cells[3], "0");
    }
    let asked = "6 cases on a grid, by 2 methods: quadrature and finite-element.";
    assert!(unwrapped(&summary).contains(asked), "{summary}");
    assert!(
        summary.lines().all(|line| line.chars().count() <= 100),
        "{summary}"
    );
    for said in [
        "Weight on bit W (kN)",
        "x86_64",
        "hash of the sweep",
        "threads",
    ] {
        let is_other_machine = said == "x86_64" && !cfg!(target_arch = "x86_64");
        assert!(
            is_other_machine || summary.contains(said),
            "{said}: {summary}"
        );
    }
}

#[test]
fn a_case_on_which_methods_differ_is_listed_with_its_axes() {
    let place = with_results();
    let only_first_differs =
        |labels: String| with_first_label_swapped(labels.replace(",stick_slip,", ",smooth,"));
    copy_with_labels(&place, "other", only_first_differs);
    let summary = succeeds(&place, &["summary", "other"]).output;
    let listed = summary
        .split("Cases on which the methods differ, all 1")
        .nth(1);
    let row: Vec<&str> = (listed.unwrap().lines().nth(2).unwrap())
        .split_whitespace()
        .collect();
    assert_eq!(row, ["0", "0.02", "30", "stick_slip", "smooth"]);
    assert!(summary.contains("83.3 %"), "{summary}");
}

#[test]
fn folders_of_the_same_cases_are_held_against_each_other() {
    let place = with_results();
    copy_with_labels(&place, "other", with_first_label_swapped);
    let page = report(&place, &["results", "other", "results"]);
    let same = "results and other have the same labels for 11 of 12 simulations (91.7 %).";
    assert!(page.contains(same), "{page}");
    assert!(page.contains("Labels that differ, all 1"));
    assert!(page.contains("results and results have the same labels for 12 of 12"));
}

#[test]
fn folders_of_other_cases_are_said_to_be_so() {
    let place = with_results();
    let other = with(SMALL, "values = [30, 70]", "values = [30, 71]");
    place.write("values.toml", other);
    let design = "[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = { values = [30] }\n";
    place.write("axes.toml", small_with_design(design));
    succeeds(&place, &["run", "values.toml", "--out", "values"]);
    succeeds(&place, &["run", "axes.toml", "--out", "axes"]);
    let page = report(&place, &["results", "values", "axes"]);
    for why in ["case 1 has other values", "their axes are different"] {
        assert!(page.contains(why), "{why}");
    }
    assert!(page.contains("axes: No map: the cases differ in fewer than two quantities."));
}

/// The page about some folders.
#[track_caller]
fn report(place: &Workplace, folders: &[&str]) -> String {
    let arguments = [&["report"][..], folders, &["--out", "page.html"]].concat();
    assert_eq!(succeeds(place, &arguments).output, "page.html\n");
    text(place, "page.html")
}

#[test]
fn a_report_goes_into_its_folder_or_here_if_there_are_several() {
    let place = with_results();
    let answer = succeeds(&place, &["report", "results"]);
    assert_eq!(answer.output, "results/report.html\n");
    assert!(place.path("results/report.html").exists());
    let answer = succeeds(&place, &["report", "results", "results"]);
    assert_eq!(answer.output, "report.html\n");
    assert!(place.path("report.html").exists());
    // A run from the beginning does not leave the report of what was there before.
    succeeds(
        &place,
        &["run", "small.toml", "--out", "results", "--fresh"],
    );
    assert!(!place.path("results/report.html").exists());
}

#[test]
fn a_shard_is_reported_as_a_part_without_a_picture() {
    let place = Workplace::with_small(SMALL);
    succeeds(
        &place,
        &["run", "small.toml", "--shard", "1/2", "--out", "part"],
    );
    let page = report(&place, &["part"]);
    assert!(page.contains("This is shard 1/2, a part of it."));
    assert!(page.contains("The picture is drawn when the shards are merged."));
    assert!(!page.contains("class=\"area\""));
    succeeds(&place, &["summary", "part"]);
}

#[test]
fn a_folder_without_results_is_refused_in_one_line() {
    let place = with_results();
    std::fs::create_dir(place.path("empty")).unwrap();
    std::fs::create_dir(place.path("stopped")).unwrap();
    place.write("stopped/cases.log", "");
    let before = place.files();
    for (folder, why) in [
        ("nowhere", "nowhere is not a folder"),
        (
            "empty",
            "empty holds no results: there is no manifest.json in it",
        ),
        (
            "stopped",
            "stopped holds a run that has only just begun (cases.log): the same `sweep run`",
        ),
    ] {
        for command in ["summary", "report"] {
            let answer = place.sweep(&[command, folder]);
            assert_eq!((answer.code, answer.output.as_str()), (2, ""), "{answer:?}");
            assert!(
                answer.errors.starts_with(&format!("error: {why}")),
                "{answer:?}"
            );
            assert_eq!(answer.errors.lines().count(), 1);
        }
    }
    assert!(place.files() == before);
}

#[test]
fn files_that_are_not_of_one_run_are_refused() {
    let place = with_results();
    let without_last_row = |labels: String| {
        let end = labels.trim_end().rfind('\n').unwrap();
        labels[..=end].to_owned()
    };
    copy_with_labels(&place, "cut", without_last_row);
    let answer = place.sweep(&["summary", "cut"]);
    assert_eq!(answer.code, 1, "{answer:?}");
    let why = "cut holds 11 rows, 0 of them failed, but manifest.json speaks of 12 and 0";
    assert!(answer.errors.contains(why), "{answer:?}");
    let broken = |labels: String| labels.replacen("0.02,30", "0.02,thirty", 1);
    copy_with_labels(&place, "broken", broken);
    let answer = place.sweep(&["report", "broken"]);
    assert_eq!(answer.code, 1, "{answer:?}");
    assert!(
        answer
            .errors
            .contains("broken/labels.csv:2: weight_on_bit_kn: `thirty` is not a number")
    );
}

#[test]
fn a_map_of_other_axes_than_the_cases_have_is_reported_with_its_folder() {
    let place = with_results();
    let manifest = text(&place, "results/manifest.json");
    let mut manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    manifest["map"]["x"] = "friction".into();
    place.write("results/manifest.json", manifest.to_string());
    let answer = place.sweep(&["summary", "results"]);
    assert_eq!(answer.code, 1, "{answer:?}");
    let reported = "error: results: the map of manifest.json has an axis";
    assert!(answer.errors.starts_with(reported), "{answer:?}");
}
