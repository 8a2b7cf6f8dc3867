//! Pipes and devices in place of files, chains of bases, files too large, and large ones that are
//! read at once.

use std::fmt::Write;

use crate::soon::{ends_soon, start};
use crate::support::{Answer, SMALL, Workplace, small_with_design};

#[track_caller]
fn answers(place: &Workplace, arguments: &[&str]) -> Answer {
    ends_soon(start(place, arguments))
}

#[track_caller]
fn refused_soon(place: &Workplace, arguments: &[&str], meant: &str) {
    let before = place.files();
    let answer = answers(place, arguments);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains(meant), "{meant} in {answer:?}");
    assert!(place.files() == before);
}

fn listing(file: &str) -> String {
    small_with_design(&format!("[design]\nkind = \"list\"\nfile = \"{file}\"\n"))
}

/// Opening a pipe without a writer would wait for ever, and a device may have no end.
#[cfg(unix)]
#[test]
fn a_pipe_or_a_device_is_refused_by_name() {
    let elsewhere = tempfile::tempdir().unwrap();
    let pipe = elsewhere.path().join("pipe").display().to_string();
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    let place = Workplace::with_small(SMALL);
    for file in [&pipe, "/dev/zero"] {
        let meant = format!("{file}: cannot be read: it is a pipe or a device, not a file");
        refused_soon(&place, &["run", file], &meant);
        place.write("based.toml", format!("base = \"{file}\"\n"));
        let at_base = format!("based.toml:1: `base`: {meant}");
        refused_soon(&place, &["run", "based.toml"], &at_base);
        place.write("listing.toml", listing(file));
        let meant = format!("`design.file`: {file} cannot be read: it is a pipe or a device");
        refused_soon(&place, &["run", "listing.toml"], &meant);
        let meant = format!("{file} cannot be read: it is a pipe or a device");
        refused_soon(&place, &["check", "small.toml", file], &meant);
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_in_the_place_of_a_manifest_is_not_waited_for() {
    let place = Workplace::with_small(SMALL);
    assert_eq!(place.sweep(&["run", "small.toml", "--out", "out"]).code, 0);
    let manifest = place.path("out/manifest.json");
    std::fs::remove_file(&manifest).unwrap();
    let made = std::process::Command::new("mkfifo").arg(&manifest).status();
    assert!(made.unwrap().success());
    for arguments in [
        &["summary", "out"][..],
        &["plot", "out"],
        &["report", "out"],
        &["merge", "out", "--out", "merged"],
        &["run", "small.toml", "--out", "out"],
        &["run", "small.toml", "--out", "out", "--fresh"],
    ] {
        let answer = answers(&place, arguments);
        assert_ne!(answer.code, 0, "{answer:?}");
        let meant = "out/manifest.json cannot be read: it is a device or a pipe";
        let is_foreign = answer.errors.contains("out holds ");
        assert!(is_foreign || answer.errors.contains(meant), "{answer:?}");
    }
}

#[test]
fn a_file_larger_than_makes_sense_is_refused_before_it_is_read() {
    let place = Workplace::new();
    let large = |name: &str, size: u64| {
        let file = std::fs::File::create(place.path(name)).unwrap();
        file.set_len(size).unwrap();
    };
    large("large.toml", (16 << 20) + 1);
    place.write("based.toml", "base = \"large.toml\"\n");
    for file in ["large.toml", "based.toml"] {
        let meant = "large.toml: cannot be read: it is larger than 16 MiB";
        let answer = answers(&place, &["run", file]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(meant), "{answer:?}");
    }
    large("large.toml", 0);
    large("cases.csv", (1 << 30) + 1);
    place.write("listing.toml", listing("cases.csv"));
    let answer = answers(&place, &["run", "listing.toml"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    let meant = "`design.file`: cases.csv cannot be read: it is larger than 1024 MiB";
    assert!(answer.errors.contains(meant), "{answer:?}");
}

/// A sweep file and its bases count together, for they are in memory together.
#[test]
fn bases_that_are_too_large_together_are_refused() {
    let place = Workplace::new();
    let comment = format!("# {}\n", "long ".repeat(2 << 20));
    place.write("small.toml", format!("base = \"base.toml\"\n{comment}"));
    place.write("base.toml", format!("{SMALL}{comment}"));
    let meant = "`base`: base.toml: this and what it is a base of are larger than 16 MiB";
    refused_soon(&place, &["run", "small.toml"], meant);
    place.write("small.toml", format!("base = \"base.toml\"\n{SMALL}"));
    assert_eq!(answers(&place, &["run", "small.toml", "--dry-run"]).code, 0);
}

/// `small.toml` on a number of bases, the last of them whole.
fn chain(bases: usize) -> Workplace {
    let place = Workplace::with_small("base = \"base1.toml\"\n");
    for base in 1..bases {
        let next = format!("base = \"base{}.toml\"\n", base + 1);
        place.write(&format!("base{base}.toml"), next);
    }
    place.write(&format!("base{bases}.toml"), SMALL);
    place
}

#[test]
fn only_bases_that_go_in_a_circle_are_called_so() {
    let run = ["run", "small.toml", "--dry-run"];
    assert_eq!(answers(&chain(30), &run).code, 0);
    refused_soon(
        &chain(64),
        &run,
        "base63.toml:1: `base`: there are more than 64 files",
    );
    let place = chain(3);
    std::fs::create_dir(place.path("more")).unwrap();
    place.write("base3.toml", "base = \"more/../base1.toml\"\n");
    let meant = "base3.toml:1: `base`: the bases go in a circle: more/../base1.toml";
    refused_soon(&place, &run, meant);
}

/// Each of them would take minutes if every row, site or key were compared with all others.
#[test]
fn large_files_are_read_at_once() {
    let place = Workplace::new();
    let rows: String = (0..300_000)
        .map(|row| format!("{},50\n", 0.1 + 1e-7 * f64::from(row)))
        .collect();
    place.write(
        "cases.csv",
        format!("surface_speed_rpm,weight_on_bit_kn\n{rows}"),
    );
    place.write("listing.toml", listing("cases.csv"));
    let labels: String = (0..300_000)
        .map(|row| format!("{row},magic,0.1,50,smooth\n"))
        .collect();
    let header = "case,method,surface_speed_rpm,weight_on_bit_kn,torsion\n";
    place.write("labels.csv", format!("{header}{labels}"));

    let sites = |count: usize| {
        (1..count).fold(String::new(), |mut text, site| {
            let _ = writeln!(
                text,
                "[[sites]]\ndistance_from_bit_m = {}",
                1e-4 * site as f64
            );
            text
        })
    };
    place.write("small.toml", SMALL);
    let more = format!("base = \"small.toml\"\n{}", sites(200_000));
    place.write(
        "twice.toml",
        format!("{more}[[sites]]\ndistance_from_bit_m = 1\n"),
    );

    // Unknown keys are known to be so only when all files are read.
    let keys: String = (0..2000).map(|key| format!("key{key} = {key}\n")).collect();
    let marks: String = (0..100_000)
        .map(|mark| format!("{{ name = \"{mark}\", friction = 0.3, impulse_ratio = 2 }},\n"))
        .collect();
    place.write("marks.toml", format!("{keys}[map]\nmarks = [\n{marks}]\n"));
    place.write("over.toml", format!("base = \"marks.toml\"\n{keys}"));

    let answer = answers(&place, &["run", "listing.toml", "--dry-run"]);
    assert!(
        answer.output.contains("would run 300000 cases"),
        "{answer:?}"
    );
    let meant = "labels.csv:2: the sweep has no method `magic`";
    refused_soon(&place, &["check", "small.toml", "labels.csv"], meant);
    let meant = "`sites[199999].distance_from_bit_m`";
    refused_soon(&place, &["run", "twice.toml"], meant);
    refused_soon(&place, &["run", "over.toml"], "unknown key `key0`");
}
