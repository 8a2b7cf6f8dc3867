//! More random cases: what is done stays, and the result is that of a fresh run.

use std::io::{Read, Write};

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

/// Runs a number of random cases into a folder.
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
fn records_that_are_not_what_was_written_are_not_raised() {
    let place = Workplace::new();
    run(&place, 40, "results", &[]);
    place.write("small.toml", random(90));
    let refused = |why: &str| {
        let before = place.files();
        let answer = place.sweep(&["run", "small.toml", "--quiet", "--out", "results"]);
        assert_eq!(answer.code, 1, "{answer:?}");
        let meant = format!("{why}; begin anew with --fresh, or choose another --out");
        assert!(answer.errors.contains(&meant), "{answer:?}");
        assert!(place.files() == before);
    };
    let records = std::fs::read(place.path("results/records.jsonl.gz")).unwrap();
    let mut damaged = records.clone();
    damaged[records.len() / 2] ^= 1;
    place.write("results/records.jsonl.gz", &damaged);
    refused("records.jsonl.gz is damaged: its SHA-256 is not that of the one that was written");
    place.write("results/records.jsonl.gz", &records[..records.len() / 2]);
    refused(&format!("and the one that was written {}", records.len()));
    std::fs::remove_file(place.path("results/records.jsonl.gz")).unwrap();
    refused("results/records.jsonl.gz is missing");
    // By an earlier version, which kept none.
    let manifest = std::fs::read(place.path("results/manifest.json")).unwrap();
    let mut manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
    let files = manifest["files"].as_object_mut().unwrap();
    files.remove("records.jsonl.gz").unwrap();
    place.write("results/manifest.json", manifest.to_string());
    refused("results holds no records.jsonl.gz, from which it could continue");
}

/// With checksums that say nothing of it, as who changes records on purpose writes them.
#[test]
fn records_that_no_run_has_written_are_refused() {
    let place = Workplace::new();
    run(&place, 40, "results", &[]);
    let file = std::fs::File::open(place.path("results/records.jsonl.gz")).unwrap();
    let mut records = String::new();
    flate2::read::GzDecoder::new(file)
        .read_to_string(&mut records)
        .unwrap();
    let (first, others) = records.split_once("\"values\":[").unwrap();
    let rest = others.split_once(',').unwrap().1;
    let fewer = format!("{first}\"values\":[{rest}");
    let longer = format!("{first}\"values\":[{}{others}", "0,".repeat(1 << 23));
    place.write("small.toml", random(90));
    for (tampered, why) in [
        (fewer, "case 0 has 2 values, and the number of axes is 3"),
        (longer, "line 1 is longer than any record"),
    ] {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(tampered.as_bytes()).unwrap();
        let content = encoder.finish().unwrap();
        let manifest = std::fs::read(place.path("results/manifest.json")).unwrap();
        let mut manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
        let digest = <sha2::Sha256 as sha2::Digest>::digest(&content);
        let sha256: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        manifest["files"]["records.jsonl.gz"] =
            serde_json::json!({ "bytes": content.len(), "sha256": sha256 });
        place.write("results/records.jsonl.gz", content);
        place.write("results/manifest.json", manifest.to_string());
        for command in [
            &["analyse", "results"][..],
            &["run", "small.toml", "--quiet", "--out", "results"],
        ] {
            let answer = place.sweep(command);
            assert_eq!(answer.code, 1, "{answer:?}");
            assert!(answer.errors.contains(why), "{answer:?}");
        }
        let _ = std::fs::remove_file(place.path("results/cases.log"));
    }
}

/// A line of it is a record, whose numbers are those of the case to the last bit.
#[test]
fn the_records_of_a_run_stay_in_its_folder() {
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["run", "small.toml", "--quiet", "--out", "results"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let file = std::fs::File::open(place.path("results/records.jsonl.gz")).unwrap();
    let mut text = String::new();
    flate2::read::GzDecoder::new(file)
        .read_to_string(&mut text)
        .unwrap();
    let labels = std::fs::read_to_string(place.path("results/labels.csv")).unwrap();
    let mut rows = csv::Reader::from_reader(labels.as_bytes());
    let names = rows.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = rows.records().map(Result::unwrap).collect();
    assert_eq!(text.lines().count(), rows.len());
    for (line, row) in text.lines().zip(&rows) {
        let record: serde_json::Value = serde_json::from_str(line).unwrap();
        let field = |name: &str| &row[names.iter().position(|it| it == name).unwrap()];
        assert_eq!(record["case"].to_string(), field("case"));
        let torsion = &record["outcome"]["Ok"]["torsion"];
        assert_eq!(torsion["regime"], field("torsion"));
        let rpm = torsion["peak_speed"].as_f64().unwrap() / (std::f64::consts::TAU / 60.0);
        assert_eq!(rpm.to_string(), field("bit_speed_peak_rpm"));
    }
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
