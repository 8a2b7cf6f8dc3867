//! Where what is written goes: links are followed, devices and pipes written to, nothing lost that
//! the command did not write; and what a check says for other programs is theirs alone to read.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{FileTypeExt, MetadataExt, symlink};
use std::process::Command;

use crate::support::{SMALL, Workplace};

/// A folder of results, and a reference of it.
fn finished() -> Workplace {
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["run", "small.toml", "--out", "results"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    fs::copy(
        place.path("results/labels.csv"),
        place.path("reference.csv"),
    )
    .unwrap();
    place
}

fn read(place: &Workplace, name: &str) -> String {
    fs::read_to_string(place.path(name)).unwrap()
}

#[test]
fn links_are_followed_and_pipes_written_to() {
    let place = finished();
    fs::create_dir(place.path("elsewhere")).unwrap();
    for (link, target) in [
        ("there.html", "elsewhere/page.html"),
        ("new.html", "elsewhere/new.html"),
    ] {
        symlink(place.path(target), place.path(link)).unwrap();
    }
    fs::write(place.path("elsewhere/page.html"), "").unwrap();
    for link in ["there.html", "new.html", "there.html"] {
        let answer = place.sweep(&["report", "results", "--out", link]);
        assert_eq!(answer.code, 0, "{answer:?}");
        assert!(fs::symlink_metadata(place.path(link)).unwrap().is_symlink());
        assert!(read(&place, link).starts_with("<!DOCTYPE html>"));
    }
    symlink("loop", place.path("loop")).unwrap();
    let answer = place.sweep(&["report", "results", "--out", "loop"]);
    assert_eq!(answer.code, 1, "{answer:?}");

    let made = Command::new("mkfifo").arg(place.path("pipe")).status();
    if !made.is_ok_and(|status| status.success()) {
        return;
    }
    let answer = place.sweep(&["report", "results", "--out", "pipe"]);
    assert_eq!(answer.code, 1, "{answer:?}");
    assert!(
        answer.errors.contains("it is a pipe without a reader"),
        "{answer:?}"
    );
    let path = place.path("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(path).unwrap());
    // Until it is there.
    let mut written = place.sweep(&["report", "results", "--out", "pipe"]);
    for _ in 0..100 {
        if written.code == 0 {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
        written = place.sweep(&["report", "results", "--out", "pipe"]);
    }
    assert_eq!(written.code, 0, "{written:?}");
    assert!(reader.join().unwrap().starts_with("<!DOCTYPE html>"));
    let kind = fs::symlink_metadata(place.path("pipe"))
        .unwrap()
        .file_type();
    assert!(kind.is_fifo());
}

#[test]
fn devices_stay_what_they_are() {
    let place = finished();
    for device in ["/dev/null", "/dev/stdout"] {
        let before = fs::symlink_metadata(device)
            .map(|it| (it.file_type(), it.ino()))
            .unwrap();
        let answer = place.sweep(&["check", "small.toml", "reference.csv", "--output", device]);
        assert_eq!(answer.code, 0, "{answer:?}");
        let after = fs::symlink_metadata(device)
            .map(|it| (it.file_type(), it.ino()))
            .unwrap();
        assert_eq!(before, after, "{device}");
    }
    // As root one may make a device elsewhere.
    let made = Command::new("mknod")
        .arg(place.path("null"))
        .args(["c", "1", "3"])
        .output();
    if made.is_ok_and(|made| made.status.success()) {
        let answer = place.sweep(&["report", "results", "--out", "null"]);
        assert_eq!(answer.code, 0, "{answer:?}");
        let kind = fs::symlink_metadata(place.path("null"))
            .unwrap()
            .file_type();
        assert!(kind.is_char_device());
    }
}

#[test]
fn what_another_wrote_is_not_lost_without_force() {
    let place = finished();
    let labels = read(&place, "results/labels.csv");
    let sweep = read(&place, "small.toml");
    fs::write(place.path("notes.html"), "<!DOCTYPE html><p>Mine").unwrap();
    for arguments in [
        &["report", "results", "--out", "results/labels.csv"][..],
        &["report", "results", "--out", "notes.html"],
        &["explore", "small.toml", "--out", "small.toml"],
        &["analyse", "results", "--out", "results/labels.csv"],
        &[
            "analyse",
            "results",
            "--by",
            "surface_speed_rpm",
            "--picture",
            "notes.svg",
        ],
        &["reference", "results", "--out", "results/labels.csv"],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--output",
            "reference.csv",
        ],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--format",
            "junit",
            "--output",
            "small.toml",
        ],
    ] {
        fs::write(place.path("notes.svg"), "mine").unwrap();
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 2, "{arguments:?}: {answer:?}");
        assert!(
            answer
                .errors
                .contains("is there already, and this command did not write it"),
            "{arguments:?}: {answer:?}"
        );
        assert_eq!(read(&place, "results/labels.csv"), labels);
        assert_eq!(read(&place, "reference.csv"), labels);
        assert_eq!(read(&place, "small.toml"), sweep);
        assert_eq!(read(&place, "notes.svg"), "mine");
    }
    for arguments in [
        &["report", "results", "--out", "notes.html", "--force"][..],
        &["report", "results", "--out", "notes.html"],
        &["explore", "small.toml", "--out", "page.html"],
        &["explore", "small.toml", "--out", "page.html"],
        &["analyse", "results", "--out", "counts.csv"],
        &["analyse", "results", "--out", "counts.csv"],
        &["reference", "results", "--out", "kept.csv"],
        &["reference", "results", "--out", "kept.csv"],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--output",
            "report.txt",
        ],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--format",
            "github",
            "--output",
            "report.txt",
        ],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--format",
            "junit",
            "--output",
            "report.txt",
        ],
        &[
            "check",
            "small.toml",
            "reference.csv",
            "--output",
            "report.txt",
        ],
    ] {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 0, "{arguments:?}: {answer:?}");
    }
}

#[test]
fn files_are_for_whom_the_mask_lets() {
    let place = finished();
    for (mask, mode) in [("077", 0o600), ("002", 0o664), ("022", 0o644)] {
        let script = format!("umask {mask}; exec \"$@\"");
        let program = env!("CARGO_BIN_EXE_sweep");
        let output = place.path(&format!("page-{mask}.html"));
        let arguments = ["-c", &script, "sh", program, "report"];
        let status = Command::new("sh")
            .args(arguments)
            .arg(place.path("results"))
            .arg("--out")
            .arg(&output)
            .status();
        assert!(status.unwrap().success());
        assert_eq!(
            fs::metadata(&output).unwrap().mode() & 0o777,
            mode,
            "{mask}"
        );
    }
}

/// A name that is a command of a workflow, or ends one.
#[test]
fn what_a_check_says_to_a_workflow_is_no_command_of_it() {
    let place = finished();
    let labels = read(&place, "reference.csv");
    for name in [
        "::add-mask::x",
        "a\n::add-mask::x",
        "a%0A::stop-commands::x",
    ] {
        fs::write(place.path(name), format!("# margin: 3 %\n{labels}")).unwrap();
        let answer = place.sweep(&["check", "small.toml", name, "--format", "github"]);
        assert_eq!(answer.code, 0, "{answer:?}");
        let commands = answer
            .output
            .lines()
            .filter(|line| line.trim_start().starts_with("::"));
        assert_eq!(commands.count(), 0, "{}", answer.output);
    }
    // A check that cannot begin says so, and leaves nothing of the one before.
    let ok = place.sweep(&[
        "check",
        "small.toml",
        "reference.csv",
        "--format",
        "junit",
        "--output",
        "check.xml",
    ]);
    assert_eq!(ok.code, 0, "{ok:?}");
    place.write("bad.toml", "surface_speed = 3\n");
    let bad = place.sweep(&[
        "check",
        "bad.toml",
        "reference.csv",
        "--format",
        "junit",
        "--output",
        "check.xml",
    ]);
    assert_eq!(bad.code, 2, "{bad:?}");
    let document = read(&place, "check.xml");
    assert!(
        document.contains("errors=\"1\"") && document.contains("surface_speed"),
        "{document}"
    );
    let bad = place.sweep(&["check", "bad.toml", "reference.csv", "--format", "github"]);
    assert_eq!(bad.code, 2, "{bad:?}");
    assert!(
        bad.output
            .starts_with("::error file=bad.toml,title=labels not checked::"),
        "{bad:?}"
    );
    assert_eq!(bad.output.lines().count(), 1, "{bad:?}");
}
