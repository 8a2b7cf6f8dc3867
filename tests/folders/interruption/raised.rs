//! More random cases: what is done stays, and the result is that of a fresh run.

use crate::interruption::{logged, same_tables};
use crate::support::{Answer, SMALL, Workplace, small_with_design, with};

/// Random cases by two methods, of which some make no tube.
fn random(cases: usize) -> String {
    let design = format!(
        "[design]\nkind = \"monte-carlo\"\ncases = {cases}\nseed = 5\n\n[design.axes]\n\
         section_0_part_0_inner_radius_m = {{ from = 0.04, to = 0.13 }}\n\
         surface_speed_rpm = {{ from = 0.05, to = 0.6 }}\n\
         weight_on_bit_kn = {{ from = 20, to = 80 }}\n"
    );
    let methods = "[\"quadrature\", \"finite-element\"]";
    with(&small_with_design(&design), "[\"quadrature\"]", methods)
}

/// Runs so many random cases into a folder.
#[track_caller]
fn run(place: &Workplace, cases: usize, folder: &str, more: &[&str]) -> Answer {
    place.write("small.toml", random(cases));
    let arguments = [&["run", "small.toml", "--quiet", "--out", folder][..], more].concat();
    let answer = place.sweep(&arguments);
    assert_eq!(answer.code, 3, "{answer:?}");
    answer
}

/// What a run says of its start, in JSON.
fn done_before(answer: &Answer) -> u64 {
    let event: serde_json::Value =
        serde_json::from_str(answer.errors.lines().next().unwrap()).unwrap();
    assert_eq!(event["event"], "start");
    event["done"].as_u64().unwrap()
}

#[test]
fn a_complete_folder_is_raised_to_the_bytes_of_a_fresh_run() {
    let place = Workplace::new();
    run(&place, 40, "raised", &[]);
    assert_eq!(place.sweep(&["report", "raised"]).code, 0);
    place.write("small.toml", random(90));
    let dry = place.sweep(&["run", "small.toml", "--out", "raised", "--dry-run"]);
    let left = "100 of 180 simulations left: the sweep has more cases than are there";
    assert!(dry.output.contains(left), "{dry:?}");
    let answer = run(&place, 90, "raised", &["--log", "json"]);
    assert_eq!(done_before(&answer), 80);
    run(&place, 90, "fresh", &[]);
    same_tables(&place, "fresh", "raised");
    for picture in ["map.svg", "map.png"] {
        let read = |folder: &str| std::fs::read(place.path(&format!("{folder}/{picture}")));
        assert!(
            read("fresh").unwrap() == read("raised").unwrap(),
            "{picture}"
        );
    }
    assert!(!place.path("raised/report.html").exists());
    assert!(!place.path("raised/cases.log").exists());
    let failures = std::fs::read_to_string(place.path("raised/failures.csv")).unwrap();
    let of_before = |line: &str| {
        line.split(',')
            .next()
            .unwrap()
            .parse()
            .is_ok_and(|case: u32| case < 40)
    };
    assert!(failures.lines().any(of_before), "{failures}");
}

#[test]
fn a_stopped_run_is_raised_to_the_bytes_of_a_fresh_run() {
    let place = Workplace::new();
    run(&place, 90, "fresh", &[]);
    place.write("small.toml", random(40));
    // It stops at the first case that makes no tube.
    let stops = [
        "run",
        "small.toml",
        "--quiet",
        "--out",
        "raised",
        "--jobs",
        "1",
        "--fail-fast",
    ];
    let answer = place.sweep(&stops);
    assert_eq!(answer.code, 1, "{answer:?}");
    let done = logged(&place, "raised");
    assert!((4..78).contains(&done), "{done}");
    // Raised, and stopped again before any case is run.
    place.write("small.toml", random(90));
    let answer = place.sweep(&stops);
    assert_eq!(answer.code, 1, "{answer:?}");
    let so_far = format!("{done} of 180 simulations");
    assert!(answer.errors.contains(&so_far), "{answer:?}");
    let summary = place.sweep(&["summary", "raised"]);
    assert!(summary.output.contains(&so_far), "{summary:?}");
    let answer = run(&place, 90, "raised", &["--log", "json"]);
    assert_eq!(done_before(&answer), done as u64);
    same_tables(&place, "fresh", "raised");
}

#[test]
fn a_raised_folder_may_be_stopped_at_once() {
    let place = Workplace::new();
    run(&place, 90, "fresh", &[]);
    run(&place, 40, "raised", &[]);
    place.write("small.toml", random(90));
    let answer = place.sweep(&[
        "run",
        "small.toml",
        "--quiet",
        "--out",
        "raised",
        "--fail-fast",
    ]);
    assert_eq!(answer.code, 1, "{answer:?}");
    let summary = place.sweep(&["summary", "raised"]);
    let so_far = "unfinished: 80 of 180 simulations";
    assert!(summary.output.contains(so_far), "{summary:?}");
    run(&place, 90, "raised", &[]);
    same_tables(&place, "fresh", "raised");
}

#[test]
fn shards_are_raised_one_by_one() {
    for (before, after, of) in [(40, 90, 3), (2, 20, 4)] {
        let place = Workplace::new();
        place.write("small.toml", random(after));
        place.sweep(&["run", "small.toml", "--quiet", "--out", "fresh"]);
        let mut merge = vec!["merge".to_owned()];
        for index in 0..of {
            let (shard, folder) = (format!("{index}/{of}"), format!("part{index}"));
            for cases in [before, after] {
                place.write("small.toml", random(cases));
                let arguments = [
                    "run",
                    "small.toml",
                    "--quiet",
                    "--out",
                    &folder,
                    "--shard",
                    &shard,
                ];
                let answer = place.sweep(&arguments);
                assert!([0, 3].contains(&answer.code), "{answer:?}");
            }
            merge.push(folder);
        }
        merge.extend(["--out", "raised"].map(str::to_owned));
        let arguments: Vec<&str> = merge.iter().map(String::as_str).collect();
        let answer = place.sweep(&arguments);
        assert!([0, 3].contains(&answer.code), "{answer:?}");
        same_tables(&place, "fresh", "raised");
    }
}

/// The responses in bending are built for the longest case: not of those drawn, or a
/// slower one among the further would change the last digits of all.
#[test]
fn a_case_does_not_depend_on_the_longest_of_those_drawn() {
    let text = |cases: usize| {
        let design = format!(
            "[wall]\nclearance_mm = 15\nstiffness_gn_m15 = 1\nfriction = 0.5\n\n\
             [[sites]]\ndistance_from_bit_m = 0\n\n\
             [[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n\n\
             [design]\nkind = \"monte-carlo\"\ncases = {cases}\n\n[design.axes]\n\
             surface_speed_rpm = {{ from = 0.0005, to = 0.01 }}\n\
             weight_on_bit_kn = {{ from = 20, to = 80 }}\n"
        );
        let text = with(
            &small_with_design(&design),
            "[[sites]]\ndistance_from_bit_m = 50\n",
            "",
        );
        let text = with(&text, "time_s = 12", "time_s = \"auto\"");
        let bending = "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n";
        with(
            &text,
            "[[string.sections]]",
            &format!("{bending}[[string.sections]]"),
        )
    };
    let place = Workplace::with_small(&text(3));
    let run = |folder: &str| {
        let answer = place.sweep(&["run", "small.toml", "--quiet", "--out", folder]);
        assert_eq!(answer.code, 0, "{answer:?}");
        std::fs::read_to_string(place.path(&format!("{folder}/labels.csv"))).unwrap()
    };
    let few = run("raised");
    place.write("small.toml", text(12));
    let raised = run("raised");
    assert_eq!(raised, run("fresh"));
    assert!(raised.starts_with(&few), "{few}{raised}");
    // The last of them is no longer than the first three, or nothing was shown.
    let times = |labels: &str| -> Vec<f64> {
        let speeds = labels
            .lines()
            .skip(1)
            .map(|row| row.split(',').nth(2).unwrap().parse());
        speeds.map(Result::unwrap).collect()
    };
    let slowest = |labels: &str| times(labels).into_iter().fold(f64::INFINITY, f64::min);
    assert!(slowest(&raised) < slowest(&few), "{raised}");
}

#[test]
fn fewer_cases_or_other_ones_are_refused() {
    let place = Workplace::new();
    run(&place, 40, "results", &[]);
    let refused = |text: String, meant: &str| {
        place.write("small.toml", text);
        let before = place.files();
        let answer = place.sweep(&["run", "small.toml", "--out", "results"]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(meant), "{answer:?}");
        assert!(place.files() == before);
    };
    let lowered = "holds the results of 40 cases of this sweep, and 39 are fewer: `design.cases` \
                   may be raised, not lowered; choose another --out, or begin anew with --fresh";
    refused(random(39), lowered);
    let other_seed = with(&random(90), "seed = 5", "seed = 6");
    refused(
        other_seed,
        "another sweep (design.cases: 40 → 90; design.seed: 5 → 6)",
    );
    let grid = with(SMALL, "[30, 70]", "[30, 70, 80]");
    place.write("small.toml", SMALL);
    place.sweep(&["run", "small.toml", "--quiet", "--out", "grid"]);
    place.write("small.toml", grid);
    let answer = place.sweep(&["run", "small.toml", "--out", "grid"]);
    assert_eq!(answer.code, 2, "{answer:?}");
}

#[test]
fn results_that_are_not_what_was_written_are_not_raised() {
    let place = Workplace::new();
    run(&place, 40, "results", &[]);
    // Without checksums, as version 0.1.0 kept none.
    let manifest = std::fs::read(place.path("results/manifest.json")).unwrap();
    let mut manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
    manifest.as_object_mut().unwrap().remove("files").unwrap();
    place.write("results/manifest.json", manifest.to_string());
    let labels = std::fs::read_to_string(place.path("results/labels.csv")).unwrap();
    let row = labels.lines().nth(5).unwrap();
    let cut = labels.trim_end().rfind('\n').unwrap() + 1;
    for (damaged, why) in [
        (labels[..cut].to_owned(), "it has 79 rows, not 80"),
        (
            with(&labels, row, &row.replacen("2,", "3,", 1)),
            "line 6 is no row of it",
        ),
        (labels.replace(",status", ",state"), "it has other columns"),
    ] {
        place.write("results/labels.csv", damaged);
        place.write("small.toml", random(90));
        let before = place.files();
        let answer = place.sweep(&["run", "small.toml", "--quiet", "--out", "results"]);
        assert_eq!(answer.code, 1, "{answer:?}");
        let meant = format!("results/labels.csv is not what the run has written: {why}");
        assert!(answer.errors.contains(&meant), "{answer:?}");
        assert!(place.files() == before);
    }
    // A reason that is gone.
    place.write("results/labels.csv", labels);
    place.write("results/failures.csv", "case,method,reason,repeat_with\n");
    let answer = place.sweep(&["run", "small.toml", "--quiet", "--out", "results"]);
    assert_eq!(answer.code, 1, "{answer:?}");
    assert!(answer.errors.contains("is no row of it"), "{answer:?}");
}

/// A number that is read back a digit off would make another sweep of it.
#[test]
fn numbers_are_compared_to_their_last_digit() {
    let values = "values = [0.09321885624698875, 0.10893126209409987, 0.046814680009972444]";
    let place = Workplace::with_small(&with(SMALL, "from = 0.02, to = 0.6, count = 3", values));
    let run = || place.sweep(&["run", "small.toml", "--out", "results"]);
    assert_eq!(run().code, 0);
    let again = run();
    assert!(again.output.starts_with("complete already"), "{again:?}");
}
