//! `scripts/slurm.sh` on a real Slurm: arrays of shards, stopped and requeued.

mod cluster;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use crate::support::{SMALL, Workplace};
use cluster::{Cluster, SOON, field};

/// For all cases of Fig. 14, on a busy machine and with the program not optimised.
const SIMULATIONS: Duration = Duration::from_secs(600);

/// The names of folders that a script is likely to get wrong.
const SWEEPS: &str = "my sweeps";
const RESULTS: &str = "100% of \"it\"";

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn script() -> String {
    let path = repository().join("scripts/slurm.sh");
    path.to_str().unwrap().to_owned()
}

/// Submits with the script; the numbers of the array and of the merge.
#[track_caller]
fn submit(cluster: &Cluster, arguments: &[&str]) -> (String, String) {
    let said = cluster.does(&script(), arguments);
    let number = |job: &str| {
        said.lines()
            .find_map(|line| Some(line.strip_prefix(job)?.split(':').next()?.to_owned()))
            .unwrap_or_else(|| panic!("no {job}in {said}"))
    };
    (number("array "), number("merge "))
}

fn text(place: &Workplace, file: &str) -> String {
    std::fs::read_to_string(place.path(file)).unwrap_or_default()
}

/// Both hold the same labels, to the byte.
#[track_caller]
fn labels_agree(place: &Workplace, one: &str, other: &str) {
    let [one, other] = [one, other].map(|folder| text(place, &format!("{folder}/labels.csv")));
    assert!(!one.is_empty());
    assert!(one == other, "{one}\nand\n{other}");
}

#[test]
#[ignore = "needs Slurm"]
fn fig_14_in_shards_with_one_requeued_gives_the_labels_of_one_machine() {
    let cluster = Cluster::start();
    let place = &cluster.place;
    std::fs::create_dir(place.path(SWEEPS)).unwrap();
    for name in ["fig14.toml", "fig10.toml", "academic.toml"] {
        let original = repository().join("sweeps").join(name);
        std::fs::copy(original, place.path(SWEEPS).join(name)).unwrap();
    }
    let file = format!("{SWEEPS}/fig14.toml");
    let single = place.sweep(&["run", &file, "--out", "single", "--quiet"]);
    assert_eq!(single.code, 0, "{single:?}");

    let (array, merge) = submit(&cluster, &[&file, "4", RESULTS]);
    let log = format!("{RESULTS}/shard-1-of-4/cases.log");
    cluster.wait_until("case of shard 1", SIMULATIONS, || {
        (text(place, &log).lines().count() > 3).then_some(())
    });
    cluster.does("scontrol", &["requeue", &format!("{array}_1")]);

    let state = cluster.end_of(&merge, SIMULATIONS);
    assert_eq!(state, "COMPLETED", "{}", cluster.report());
    let reported = text(place, &format!("{RESULTS}/slurm/shard-1.log"));
    assert!(reported.contains("stopped: "), "{}", cluster.report());
    let requeued = cluster.job(&format!("{array}_1"));
    assert_eq!(field(&requeued, "Restarts"), "1", "{requeued}");
    labels_agree(place, "single", RESULTS);
}

#[test]
#[ignore = "needs Slurm"]
fn an_incomplete_merge_names_the_shards_to_submit_again() {
    let cluster = Cluster::start();
    let place = &cluster.place;
    place.write("small.toml", SMALL);
    let single = place.sweep(&["run", "small.toml", "--out", "single", "--quiet"]);
    assert_eq!(single.code, 0, "{single:?}");

    let (array, merge) = submit(&cluster, &["small.toml", "3", "out", "--", "--hold"]);
    cluster.does("scancel", &[&format!("{array}_1")]);
    cluster.does("scontrol", &["release", &array, &merge]);
    let state = cluster.end_of(&merge, SOON);
    assert_eq!(state, "FAILED", "{}", cluster.report());
    assert_eq!(field(&cluster.job(&merge), "ExitCode"), "4:0");
    let reported = text(place, "out/slurm/merge.log");
    assert_eq!(reported.lines().last(), Some("run again: 1"), "{reported}");

    // As docs/cluster.md says. The scripts are held as they were submitted.
    let again = |arguments: &[&str]| {
        let job = cluster.does("sbatch", &[&["--parsable"], arguments].concat());
        job.trim().to_owned()
    };
    let array = again(&["--array=1", "out/slurm/shards.sh"]);
    let after = format!("--dependency=afterany:{array}");
    let merge = again(&[&after, "out/slurm/merge.sh"]);
    cluster.does("scontrol", &["release", &array, &merge]);
    let state = cluster.end_of(&merge, SOON);
    assert_eq!(state, "COMPLETED", "{}", cluster.report());
    labels_agree(place, "single", "out");
}

/// A program that never gets through before its time limit, but once started
/// again is done at once. It tells whose child it is: on a cluster with cgroups,
/// Slurm signals its own children only.
const SLOW: &str = r#"#!/bin/sh
[ "$1" = merge ] && exit
[ "${SLURM_RESTART_COUNT:-0}" -gt 0 ] && exec echo "$@"
trap 'echo terminated, child of $(cat /proc/$PPID/comm); exit 143' TERM
while :; do sleep 0.1; done
"#;

#[test]
#[ignore = "needs Slurm"]
fn a_task_near_its_time_limit_goes_back_to_the_queue() {
    let cluster = Cluster::start();
    let place = &cluster.place;
    place.write("small.toml", SMALL);
    place.write("slow", SLOW);
    cluster.does("chmod", &["+x", "slow"]);
    let submitted = cluster
        .command(&script())
        .args(["small.toml", "1", "out", "--", "--time=1"])
        .env("SWEEP", place.path("slow"))
        .env("MARGIN_S", "58")
        .output()
        .unwrap();
    assert!(submitted.status.success(), "{submitted:?}");
    let expected = format!(
        "--shard 0/1 --out {}",
        place.path("out/shard-0-of-1").display()
    );
    let reported = cluster.wait_until("second start", SOON, || {
        let reported = text(place, "out/slurm/shard-0.log");
        reported.contains(&expected).then_some(reported)
    });
    let stopped = "terminated, child of slurmstepd\n";
    assert_eq!(reported.matches(stopped).count(), 1, "{reported}");
}

#[test]
fn what_cannot_be_submitted_is_refused_in_a_line() {
    let place = Workplace::with_small(SMALL);
    for (arguments, word) in [
        ("small.toml", "usage: "),
        ("small.toml 2 out more", "usage: "),
        ("other.toml 2", "no sweep file other.toml"),
        ("small.toml none", "from 1 to 1000, not none"),
        ("small.toml 0", "from 1 to 1000, not 0"),
        ("small.toml 1001", "at most 1000 shards, not 1001"),
        ("small.toml 2 -- --array=1", "--array=1 is for this script"),
        ("small.toml 2 -- --time 60", "not apart: 60"),
    ] {
        let output = Command::new(script())
            .args(arguments.split(' '))
            .current_dir(place.path(""))
            .output()
            .unwrap();
        let reported = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {reported}");
        assert!(reported.contains(word), "{arguments}: {reported}");
        assert_eq!(reported.lines().count(), 1, "{arguments}: {reported}");
        assert!(!place.path("out").exists() && !place.path("results").exists());
    }
}
