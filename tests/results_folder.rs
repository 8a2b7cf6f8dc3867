//! What a results folder holds is what was written, by this program, by one command
//! at a time; what is someone else's stays.

#[path = "results_folder/damage.rs"]
mod damage;
#[path = "results_folder/foreign.rs"]
mod foreign;
#[cfg(unix)]
#[path = "results_folder/killed.rs"]
mod killed;
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[path = "results_folder/locks.rs"]
mod locks;
// Each of the tests uses a part of it.
#[allow(dead_code)]
mod support;

use support::{Answer, SMALL, Workplace};

const RUN: [&str; 4] = ["run", "small.toml", "--out", "results"];

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
    let name = format!("{folder}/manifest.json");
    let mut manifest: serde_json::Value = serde_json::from_slice(&read(place, &name)).unwrap();
    let files = manifest.as_object_mut().unwrap().remove("files");
    assert!(files.is_some());
    place.write(&name, serde_json::to_vec_pretty(&manifest).unwrap());
}
