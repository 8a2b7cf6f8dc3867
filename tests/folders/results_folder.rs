//! What a results folder holds is what was written, by this program, by one command
//! at a time; what is someone else's stays.

mod damage;
mod foreign;
#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod locks;
#[cfg(unix)]
mod stopped;
// Each of the tests uses a part of it.

use crate::support::{Answer, SMALL, Workplace, with};

const RUN: [&str; 4] = ["run", "small.toml", "--out", "results"];

/// The files of a run that its manifest lists.
const FILES: [&str; 6] = [
    "boundary.csv",
    "failures.csv",
    "labels.csv",
    "map.png",
    "map.svg",
    "records.jsonl.gz",
];

/// Runs what must succeed without a word of warning.
#[track_caller]
fn succeeds(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.sweep(arguments);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""), "{answer:?}");
    answer
}

/// Refused in one line with all these words, and nothing changed.
#[track_caller]
fn refuses(place: &Workplace, arguments: &[&str], code: i32, words: &[&str]) {
    let before = place.files();
    let answer = place.sweep(arguments);
    assert_eq!(
        (answer.code, answer.output.as_str()),
        (code, ""),
        "{answer:?}"
    );
    assert_eq!(answer.errors.lines().count(), 1, "{answer:?}");
    for word in words {
        assert!(answer.errors.contains(word), "{word}: {answer:?}");
    }
    assert!(place.files() == before, "{arguments:?} changed something");
}

/// A place with a run that is complete.
fn with_results() -> Workplace {
    let place = Workplace::with_small(SMALL);
    succeeds(&place, &RUN);
    place
}

/// Runs both halves of the small sweep, into `0` and `1`.
fn run_shards(place: &Workplace) {
    for (out, shard) in [("0", "0/2"), ("1", "1/2")] {
        let run = ["run", "small.toml", "--shard", shard, "--out", out];
        succeeds(place, &run);
    }
}

fn manifest(place: &Workplace, folder: &str) -> serde_json::Value {
    serde_json::from_slice(&read(place, &format!("{folder}/manifest.json"))).unwrap()
}

fn read(place: &Workplace, name: &str) -> Vec<u8> {
    std::fs::read(place.path(name)).unwrap()
}

fn copy(place: &Workplace, from: &str, to: &str) {
    std::fs::create_dir(place.path(to)).unwrap();
    for entry in std::fs::read_dir(place.path(from)).unwrap() {
        let entry = entry.unwrap();
        std::fs::copy(entry.path(), place.path(to).join(entry.file_name())).unwrap();
    }
}

/// As version 0.1.0 wrote it.
fn without_checksums(place: &Workplace, folder: &str) {
    let mut manifest = manifest(place, folder);
    let files = manifest.as_object_mut().unwrap().remove("files");
    assert!(files.is_some());
    place.write(&format!("{folder}/manifest.json"), manifest.to_string());
}

#[test]
fn a_page_does_not_outlive_the_title_or_the_tables_it_shows() {
    let place = with_results();
    succeeds(&place, &["report", "results"]);
    succeeds(&place, &RUN);
    assert!(place.path("results/report.html").exists());
    place.write("small.toml", with(SMALL, "A small sweep\"", "Another\""));
    succeeds(&place, &RUN);
    assert!(!place.path("results/report.html").exists());
    run_shards(&place);
    let merge = ["merge", "0", "1", "--out", "merged"];
    succeeds(&place, &merge);
    succeeds(&place, &["report", "merged"]);
    succeeds(&place, &merge);
    assert!(!place.path("merged/report.html").exists());
}

#[test]
fn a_shard_that_is_complete_is_not_said_to_have_a_map() {
    let place = Workplace::with_small(SMALL);
    run_shards(&place);
    let run = ["run", "small.toml", "--shard", "0/2", "--out", "0"];
    let again = succeeds(&place, &run).output;
    assert!(
        again.contains("\nlabels.csv and more are in 0\n"),
        "{again}"
    );
}

/// Analysis, reports and windows read what the log held; without it, the same from the text of
/// `labels.csv`: a grid that certifies, a file with walls and found sites, and measures of each.
#[test]
fn rows_from_records_are_those_of_the_table() {
    use campaign::records::{Measure, Needs};
    use results::folder::{LabelRow, Manifest, label_rows};

    let sweeps = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    let certified = "certify = true\nmethods = [\"held\", \"finite-element\"]\n";
    let few = "[design]\nkind = \"monte-carlo\"\ncases = 12\nseed = 3\n[design.axes]\n";
    let bit = "weight_on_bit_kn = { from = 20, to = 200 }\n\
               surface_speed_rpm = { from = 20, to = 150 }\n";
    let wall = "impulse_ratio = { from = 0.9, to = 5 }\nfriction = { from = 0.5, to = 3 }\n";
    for (base, more) in [
        ("fig09_certified.toml", format!("{certified}{few}{bit}")),
        ("fig14.toml", format!("{few}{wall}")),
        // Long enough for what follows the impulse at 1 s to find its sites.
        ("fig16b_found.toml", "time_s = 1.2\n".to_owned()),
        ("well_b.toml", String::new()),
    ] {
        let place = Workplace::new();
        let file = sweeps.join(base).display().to_string();
        place.write("a.toml", format!("base = \"{file}\"\n{more}"));
        let output = place.sweep(&["run", "a.toml", "--out", "out", "--quiet"]);
        assert_eq!(output.code, 0, "{base}: {}", output.errors);
        let folder = place.path("out");
        let axes = Manifest::read(&folder).unwrap().axes;
        // Without a bit that cuts there are no columns of the axis, in an upright well none of a string
        // that lies, nor of what is not asked for.
        let is_there = |measure: &Measure| {
            let absent = [Needs::Cutting, Needs::Lying, Needs::Shocks, Needs::Stress];
            !measure.needs().is_some_and(|needs| absent.contains(&needs))
        };
        let measures: Vec<Measure> = Measure::severities().filter(is_there).collect();
        let rows = || -> Vec<LabelRow> {
            let rows = label_rows(&folder.join("labels.csv"), &axes, &measures).unwrap();
            rows.map(|row| row.unwrap()).collect()
        };
        let recorded = rows();
        std::fs::remove_file(folder.join("records.jsonl.gz")).unwrap();
        assert!(!recorded.is_empty());
        assert_eq!(recorded, rows(), "{base}");
    }
}
