//! `--shard` and `merge`: parts of a sweep on several machines, joined to the
//! bytes of one.

// Each of the tests uses a part of it.

use crate::support::{Answer, SMALL, Workplace, with};

/// Three methods' worth of rows, and a string axis so that shards get whole
/// strings.
fn with_strings() -> String {
    let text = with(SMALL, "[\"quadrature\"]", "[\"quadrature\", \"hilbert\"]");
    with(
        &text,
        "[design.axes]\n",
        "[design.axes]\ntorsional_damping_nms_rad_m = { from = 5, to = 20, count = 4 }\n\
         site_0_distance_from_bit_m = { values = [20, 50] }\n",
    )
}

#[track_caller]
fn finishes(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{answer:?}");
    answer
}

fn shards(place: &Workplace, of: usize) -> Vec<String> {
    (0..of)
        .map(|index| {
            let shard = format!("{index}/{of}");
            finishes(place, &["run", "small.toml", "--quiet", "--shard", &shard]);
            format!("results/small/shard-{index}-of-{of}")
        })
        .collect()
}

fn merge(place: &Workplace, folders: &[String], out: &str) -> Answer {
    let mut arguments = vec!["merge"];
    arguments.extend(folders.iter().map(String::as_str));
    arguments.extend(["--out", out]);
    place.sweep(&arguments)
}

#[test]
fn any_number_of_shards_gives_the_bytes_of_one_machine() {
    for text in [SMALL.to_owned(), with_strings()] {
        let place = Workplace::with_small(&text);
        finishes(&place, &["run", "small.toml", "--out", "whole"]);
        for of in [1, 3, 10] {
            let mut folders = shards(&place, of);
            if of == 1 {
                folders = vec!["results/small".to_owned()];
            }
            let out = format!("merged-{of}");
            // The order in which they are named does not matter.
            folders.reverse();
            let answer = merge(&place, &folders, &out);
            assert_eq!(answer.code, 0, "{answer:?}");
            let files = [
                "labels.csv",
                "failures.csv",
                "boundary.csv",
                "map.svg",
                "map.png",
            ];
            for file in files {
                let read = |folder: &str| std::fs::read(place.path(&format!("{folder}/{file}")));
                assert!(
                    read("whole").unwrap() == read(&out).unwrap(),
                    "{of}: {file}"
                );
            }
        }
    }
}

#[test]
fn missing_shards_are_named_for_the_scheduler() {
    let place = Workplace::with_small(SMALL);
    let folders = shards(&place, 4);
    for lost in [1, 3] {
        std::fs::remove_dir_all(place.path(&folders[lost])).unwrap();
    }
    // Named, though it is not there; and a folder that the shell did not find.
    let answer = merge(&place, &folders[..3], "merged");
    assert_eq!(answer.code, 4, "{answer:?}");
    assert_eq!(answer.errors.lines().last(), Some("run again: 1,3"));
    assert!(!place.path("merged").exists());
    finishes(&place, &["run", "small.toml", "--quiet", "--shard", "1/4"]);
    finishes(&place, &["run", "small.toml", "--quiet", "--shard", "3/4"]);
    assert_eq!(merge(&place, &folders, "merged").code, 0);
}

#[test]
fn a_shard_that_is_not_finished_is_missing() {
    let place = Workplace::with_small(SMALL);
    let folders = shards(&place, 2);
    // As a run leaves it that stopped: a log, and no manifest yet.
    let manifest = place.path(&format!("{}/manifest.json", folders[1]));
    std::fs::remove_file(manifest).unwrap();
    let answer = merge(&place, &folders, "merged");
    assert_eq!(answer.code, 4, "{answer:?}");
    assert_eq!(answer.errors.lines().last(), Some("run again: 1"));
}

#[test]
fn shards_of_something_else_are_refused() {
    let place = Workplace::with_small(SMALL);
    let mine = shards(&place, 2);
    finishes(
        &place,
        &["run", "small.toml", "--shard", "1/3", "--out", "third"],
    );
    place.write("other.toml", with(SMALL, "[30, 70]", "[30, 60]"));
    finishes(
        &place,
        &["run", "other.toml", "--shard", "1/2", "--out", "other"],
    );
    let random = |seed: u64| {
        let design = format!(
            "[design]\nkind = \"monte-carlo\"\ncases = 4\nseed = {seed}\n\n[design.axes]\n\
             surface_speed_rpm = {{ from = 0.1, to = 0.2 }}\n\
             weight_on_bit_kn = {{ from = 10, to = 20 }}\n"
        );
        crate::support::small_with_design(&design)
    };
    for seed in [1, 2] {
        let file = format!("random{seed}.toml");
        place.write(&file, random(seed));
        let out = format!("random{seed}");
        let shard = format!("{}/2", seed - 1);
        finishes(&place, &["run", &file, "--shard", &shard, "--out", &out]);
    }
    let altered = place.path("altered");
    std::fs::create_dir(&altered).unwrap();
    for entry in std::fs::read_dir(place.path(&mine[1])).unwrap() {
        let entry = entry.unwrap();
        std::fs::copy(entry.path(), altered.join(entry.file_name())).unwrap();
    }
    let manifest = std::fs::read_to_string(altered.join("manifest.json")).unwrap();
    let manifest = manifest.replace("\"program\": \"sweep ", "\"program\": \"sweep 0.0.1 ");
    std::fs::write(altered.join("manifest.json"), manifest).unwrap();
    for (one, other, meant) in [
        (
            mine[0].as_str(),
            "third",
            "different divisions, shard 0/2 and shard 1/3",
        ),
        (
            &mine[0],
            "other",
            "different sweeps (design.axes.weight_on_bit_kn.values[1]: 70.0 → 60.0)",
        ),
        (
            "random1",
            "random2",
            "different sweeps (design.seed: 1 → 2)",
        ),
        (&mine[0], "altered", "different programs"),
        (&mine[0], &mine[0], "there twice"),
        ("nowhere", "nothing", "none of these folders"),
    ] {
        let folders = [one, other].map(str::to_owned);
        let answer = merge(&place, &folders, "merged");
        assert_eq!(answer.code, 2, "{other}: {answer:?}");
        assert!(answer.errors.contains(meant), "{other}: {answer:?}");
        assert!(!place.path("merged").exists());
    }
    // The results of something else are not replaced.
    finishes(&place, &["run", "other.toml", "--quiet", "--out", "taken"]);
    let answer = merge(&place, &mine, "taken");
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("holds other results"), "{answer:?}");
}

#[test]
fn a_shard_with_a_damaged_number_is_refused() {
    let place = Workplace::with_small(SMALL);
    let folders = shards(&place, 3);
    let mut damaged = 0;
    for (shard, folder) in folders.iter().enumerate() {
        for table in ["labels.csv", "boundary.csv", "failures.csv"] {
            let path = format!("{folder}/{table}");
            let whole = std::fs::read(place.path(&path)).unwrap();
            // Places all over the table.
            for at in (0..whole.len()).step_by(1 + whole.len() / 8) {
                let mut content = whole.clone();
                content[at] ^= 1;
                place.write(&path, content);
                let answer = merge(&place, &folders, "merged");
                assert_eq!(answer.code, 1, "{path}, byte {at}: {answer:?}");
                let again = format!("run these shards again with --fresh: {shard}\n");
                for words in [&format!("{path} is damaged"), &again] {
                    assert!(answer.errors.contains(words), "{answer:?}");
                }
                damaged += 1;
            }
            std::fs::remove_file(place.path(&path)).unwrap();
            let answer = merge(&place, &folders, "merged");
            assert_eq!(answer.code, 1, "{answer:?}");
            let missing = format!("{path} is missing");
            assert!(answer.errors.contains(&missing), "{answer:?}");
            place.write(&path, whole);
        }
    }
    assert!(damaged >= 24 && !place.path("merged").exists());
    assert_eq!(merge(&place, &folders, "merged").code, 0);
}

#[test]
fn a_stopped_run_is_not_merged_over() {
    let place = Workplace::with_small(SMALL);
    let folders = shards(&place, 2);
    let manifest = std::fs::read(place.path(&format!("{}/manifest.json", folders[0]))).unwrap();
    let manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
    let header = serde_json::json!({
        "format": 1,
        "program": manifest["program"],
        "shard": { "index": 0, "of": 1 },
        "meaning": { "time_s": 1.0 },
    });
    let header = format!("sweep-log\t{header}");
    let log = format!("{:08x}\t{header}\n", crate::crc32::crc32(header.as_bytes()));
    std::fs::create_dir(place.path("out")).unwrap();
    place.write("out/cases.log", log);
    let before = place.files();
    let answer = merge(&place, &folders, "out");
    assert_eq!(answer.code, 2, "{answer:?}");
    let words = "out holds a stopped run (cases.log)";
    assert!(answer.errors.contains(words), "{answer:?}");
    assert!(place.files() == before);
}

#[test]
fn an_invalid_shard_is_refused() {
    let place = Workplace::with_small(SMALL);
    for (shard, meant) in [
        ("2/2", "I from 0 to N − 1"),
        ("x", "I from 0 to N − 1"),
        ("1", "I from 0 to N − 1"),
        ("0/0", "I from 0 to N − 1"),
        ("0/1000000000000000", "N is more than 10000000"),
    ] {
        let answer = place.sweep(&["run", "small.toml", "--shard", shard]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(meant), "{answer:?}");
    }
    assert!(!place.path("results").exists());
}
