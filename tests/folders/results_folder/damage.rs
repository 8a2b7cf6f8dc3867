//! Tables that are missing, cut or altered.

use crate::results_folder::{
    FILES, RUN, copy, manifest, read, refuses, succeeds, with_results, without_checksums,
};
use crate::support::Workplace;

/// What becomes of a file.
type Damage = fn(Vec<u8>) -> Option<Vec<u8>>;

/// Gone, emptied, cut, and one digit another.
const DAMAGES: [Damage; 4] = [
    |_| None,
    |_| Some(Vec::new()),
    |content| Some(content[..content.len() / 2].to_vec()),
    |mut content| {
        let digit = content.iter_mut().rev().find(|byte| byte.is_ascii_digit());
        match digit {
            Some(digit) => *digit = b'0' + (*digit - b'0' + 1) % 10,
            None => content[0] ^= 1,
        }
        Some(content)
    },
];

fn damage(place: &Workplace, name: &str, damage: Damage) {
    let content = read(place, name);
    match damage(content.clone()) {
        None => std::fs::remove_file(place.path(name)).unwrap(),
        Some(damaged) => {
            assert_ne!(damaged, content);
            place.write(name, damaged);
        }
    }
}

#[test]
fn a_folder_without_its_labels_is_not_complete() {
    let place = with_results();
    let labels = read(&place, "results/labels.csv");
    for change in DAMAGES {
        damage(&place, "results/labels.csv", change);
        let words = ["results/labels.csv is ", "put back a copy", "--fresh"];
        for more in [&[][..], &["--dry-run"], &["--quiet"]] {
            refuses(&place, &[&RUN[..], more].concat(), 1, &words);
        }
        for command in ["summary", "report", "plot"] {
            refuses(&place, &[command, "results"], 1, &words);
        }
        succeeds(&place, &[&RUN[..], &["--fresh"]].concat());
        assert_eq!(read(&place, "results/labels.csv"), labels);
    }
}

#[test]
fn what_follows_from_the_labels_is_made_again() {
    let place = with_results();
    for name in ["boundary.csv", "failures.csv", "map.svg", "map.png"] {
        let path = format!("results/{name}");
        let whole = read(&place, &path);
        for change in DAMAGES {
            damage(&place, &path, change);
            let before = place.files();
            let plan = succeeds(&place, &[&RUN[..], &["--dry-run"]].concat());
            let reported = format!("would be made again: {path} is ");
            assert!(plan.output.contains(&reported), "{plan:?}");
            assert!(place.files() == before);
            if name.ends_with(".csv") {
                let words = [path.as_str(), "the same `sweep run` as before"];
                for command in ["summary", "report", "plot"] {
                    refuses(&place, &[command, "results"], 1, &words);
                }
            }
            let answer = place.sweep(&RUN);
            assert_eq!(answer.code, 0, "{answer:?}");
            let reported = answer.errors.starts_with(&format!("warning: {path} is "));
            assert!(
                reported && answer.errors.contains("made again"),
                "{answer:?}"
            );
            assert!(read(&place, &path) == whole, "{name}");
            let again = succeeds(&place, &RUN);
            assert!(again.output.starts_with("complete already"), "{again:?}");
        }
    }
}

/// The limit is made again from the linear systems, which take memory.
#[test]
fn what_is_made_again_stays_within_the_memory_allowed() {
    let place = with_results();
    std::fs::remove_file(place.path("results/boundary.csv")).unwrap();
    let before = place.files();
    let answer = place.sweep(&[&RUN[..], &["--memory", "1M"]].concat());
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("given by --memory"), "{answer:?}");
    assert!(place.files() == before);
}

/// Drawn by another hand, it is still the picture of this folder.
#[test]
fn a_map_that_is_drawn_again_is_noted() {
    let place = with_results();
    std::fs::remove_file(place.path("results/map.svg")).unwrap();
    succeeds(&place, &["plot", "results"]);
    let mut manifest = manifest(&place, "results");
    manifest["files"]["map.svg"]["sha256"] = "0".into();
    place.write("results/manifest.json", manifest.to_string());
    succeeds(&place, &["plot", "results"]);
    succeeds(&place, &RUN);
}

/// Its length and hash by another program.
#[test]
fn the_checksums_are_those_of_the_files() {
    let place = with_results();
    let manifest = manifest(&place, "results");
    let failures = "case,method,reason,repeat_with\n";
    assert_eq!(read(&place, "results/failures.csv"), failures.as_bytes());
    let noted = &manifest["files"]["failures.csv"];
    assert_eq!(noted["bytes"], failures.len());
    assert_eq!(
        noted["sha256"],
        "027f0597781820b4b671f781b54ec011522e3b32f849ca5fa4169779326b3ba0"
    );
    let names: Vec<&String> = manifest["files"].as_object().unwrap().keys().collect();
    assert_eq!(names, FILES);
}

#[test]
fn a_folder_without_checksums_is_read_and_said_to_be_unverified() {
    let place = with_results();
    copy(&place, "results", "old");
    without_checksums(&place, "old");
    for (arguments, output) in [
        (&["summary", "old"][..], "A small sweep"),
        (&["report", "old"], "old/report.html"),
        (&["plot", "old"], "old/map.png"),
        (&["run", "small.toml", "--out", "old"], "complete already"),
    ] {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 0, "{answer:?}");
        assert!(answer.output.contains(output), "{answer:?}");
        let note = "note: old was written by sweep ";
        assert!(answer.errors.starts_with(note), "{answer:?}");
        assert!(answer.errors.contains("not verified"), "{answer:?}");
        assert_eq!(answer.errors.lines().count(), 1, "{answer:?}");
    }
}
