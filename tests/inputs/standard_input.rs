//! A sweep file from standard input: `-` in the place of its name.

use std::io::Write;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use crate::refusals::line_of;
use crate::support::{Answer, SMALL, Workplace, with, without_coarse_sampling};

fn start(place: &Workplace, arguments: &[&str]) -> Child {
    place
        .command(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// What a command answers that reads this text.
fn given(place: &Workplace, text: &str, arguments: &[&str]) -> Answer {
    let mut child = start(place, arguments);
    child
        .stdin
        .take()
        .unwrap()
        .write_all(text.as_bytes())
        .unwrap();
    let output = child.wait_with_output().unwrap();
    Answer {
        code: output.status.code().expect("no signal ended it"),
        output: String::from_utf8(output.stdout).unwrap(),
        errors: without_coarse_sampling(&String::from_utf8(output.stderr).unwrap()),
    }
}

#[track_caller]
fn done(place: &Workplace, text: &str, arguments: &[&str]) -> Answer {
    let answer = given(place, text, arguments);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""), "{answer:?}");
    answer
}

fn read(place: &Workplace, name: &str) -> String {
    std::fs::read_to_string(place.path(name)).unwrap()
}

/// The small sweep by the name `piped`, above its first table.
fn named() -> String {
    format!("name = \"piped\"\n{SMALL}")
}

#[test]
fn a_run_is_that_of_the_file_and_goes_to_the_folder_of_its_name() {
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["run", "small.toml", "--quiet"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    done(&place, SMALL, &["run", "-", "--quiet"]);
    done(&place, &named(), &["run", "-", "--quiet"]);
    for table in ["labels.csv", "boundary.csv", "failures.csv"] {
        let own = read(&place, &format!("results/small/{table}"));
        assert_eq!(own, read(&place, &format!("results/sweep/{table}")));
        assert_eq!(own, read(&place, &format!("results/piped/{table}")));
    }
    let again = done(&place, &named(), &["run", "-"]);
    assert!(again.output.starts_with("complete already"), "{again:?}");
    let other = with(&named(), "time_s = 12", "time_s = 13");
    let refused = given(&place, &other, &["run", "-"]);
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(
        refused.errors.contains("time_s: 12.0 → 13.0"),
        "{refused:?}"
    );
}

#[test]
fn what_it_names_is_in_the_current_folder_and_a_base_gives_no_name() {
    let place = Workplace::with_small(&named());
    place.write(
        "cases.csv",
        "surface_speed_rpm,weight_on_bit_kn\n0.1,50\n0.5,50\n",
    );
    let text = "base = \"small.toml\"\n[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";
    done(&place, text, &["run", "-", "--quiet"]);
    assert_eq!(read(&place, "results/sweep/labels.csv").lines().count(), 3);
    place.write("child.toml", text);
    let answer = place.sweep(&["run", "child.toml", "--quiet"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(place.path("results/child/labels.csv").exists());
}

#[test]
fn an_error_names_line_and_key() {
    let place = Workplace::new();
    let wrong = with(SMALL, "time_s = 12", "time_s = -12");
    let line = line_of(&wrong, "time_s = -12");
    for arguments in [
        &["run", "-"][..],
        &["run", "-", "--dry-run"],
        &["simulate", "-"],
        &["inspect", "-"],
        &["explore", "-"],
        &["window", "-"],
        &["check", "-", "reference.csv"],
        &["study", "contacts", "-"],
    ] {
        let answer = given(&place, &wrong, arguments);
        assert_eq!(answer.code, 2, "{arguments:?}: {answer:?}");
        let place = format!("error: <standard input>:{line}: `time_s`: ");
        assert!(answer.errors.starts_with(&place), "{answer:?}");
    }
    for (text, words) in [
        ("name = \"a/b\"\n", "`name`: names a folder"),
        ("name = \"..\"\n", "`name`: names a folder"),
        (
            "name = \"a\\u001b[0m\"\n",
            "`name`: has the control character",
        ),
        ("base = \"none.toml\"\n", "<standard input>:1: `base`"),
        ("x\u{0}", "<standard input>:1"),
    ] {
        let answer = given(&place, &format!("{text}{SMALL}"), &["run", "-"]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(words), "{words}: {answer:?}");
    }
    assert!(place.files().is_empty());
}

#[test]
fn every_command_that_reads_a_sweep_file_reads_it() {
    let place = Workplace::new();
    let text = named();
    done(&place, &text, &["run", "-", "--quiet"]);
    let labels = "results/piped/labels.csv";
    let checked = done(&place, &text, &["check", "-", labels]);
    assert_eq!(
        checked.output,
        format!("{labels}: 6 of 6 labels as expected\n")
    );
    // With a method that the file does not name, which is read twice.
    done(
        &place,
        &text,
        &["run", "-", "--quiet", "--methods", "held", "--out", "held"],
    );
    done(&place, &text, &["check", "-", "held/labels.csv"]);
    done(&place, &text, &["window", "-"]);
    let inspected = done(&place, &text, &["inspect", "-"]);
    assert!(inspected.output.starts_with("piped: "), "{inspected:?}");
    done(&place, &text, &["simulate", "-", "--case", "2"]);
    done(&place, &text, &["explore", "-"]);
    let page = read(&place, "explore.html");
    assert!(page.contains("sweep simulate - --case 0"));
    done(
        &place,
        &text,
        &["reference", "results/piped", "--sweep", "-"],
    );
    let refused = given(
        &place,
        "",
        &["reference", "results/piped", "--out", "other.csv"],
    );
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(
        refused.errors.contains("read from standard input"),
        "{refused:?}"
    );
}

/// What repeats a case, or runs a shard, reads the same text again.
#[test]
fn commands_that_are_given_read_it_again() {
    let place = Workplace::new();
    let failing = with(
        &named(),
        "[design.axes]\n",
        "[design.axes]\nsection_0_part_0_inner_radius_m = { values = [0.04, 0.2] }\n",
    );
    let answer = given(&place, &failing, &["run", "-", "--quiet"]);
    assert_eq!(answer.code, 3, "{answer:?}");
    let failures = read(&place, "results/piped/failures.csv");
    let row = failures.lines().nth(1).unwrap();
    let command = "sweep simulate - --case 6 --methods quadrature";
    assert!(row.ends_with(command), "{row}");
    let words: Vec<&str> = command.split(' ').skip(1).collect();
    let repeated = given(&place, &failing, &words);
    assert_eq!(repeated.code, 3, "{repeated:?}");
    assert!(
        repeated
            .errors
            .contains("internal radius < external radius")
    );
    let text = named();
    done(&place, &text, &["run", "-", "--quiet", "--out", "whole"]);
    done(
        &place,
        &text,
        &["run", "-", "--quiet", "--shard", "0/2", "--out", "a"],
    );
    let missing = place.sweep(&["merge", "a", "--out", "all"]);
    assert_eq!(missing.code, 4, "{missing:?}");
    assert!(
        missing.errors.contains("`sweep run - --shard 1/2`"),
        "{missing:?}"
    );
    done(
        &place,
        &text,
        &["run", "-", "--quiet", "--shard", "1/2", "--out", "b"],
    );
    let merged = place.sweep(&["merge", "a", "b", "--out", "all"]);
    assert_eq!(merged.code, 0, "{merged:?}");
    assert_eq!(
        read(&place, "all/labels.csv"),
        read(&place, "whole/labels.csv")
    );
    let report = place.sweep(&["report", "all"]);
    assert_eq!(report.code, 0, "{report:?}");
    assert!(read(&place, "all/report.html").contains("sweep simulate - --case "));
}

/// A writer that never ends is waited for, until a signal comes.
#[cfg(unix)]
#[test]
fn a_signal_ends_the_wait() {
    let place = Workplace::new();
    let child = start(&place, &["run", "-"]);
    std::thread::sleep(Duration::from_millis(300));
    let begun = Instant::now();
    let sent = std::process::Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let mut child = child;
    let pipe = child.stdin.take();
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(143));
    assert!(begun.elapsed() < Duration::from_secs(2));
    drop(pipe);
}
