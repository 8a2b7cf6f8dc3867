//! `--json`: one document, with the numbers of the text and of the tables.

use std::io::Read;
use std::process::Stdio;

use serde_json::Value;

use crate::support::{Answer, SMALL, Workplace, small_with_design, with};

/// What a command says to programs; standard output is one document on one line, and standard
/// error what it is for people.
#[track_caller]
fn document(place: &Workplace, arguments: &[&str], code: i32) -> (Value, Answer) {
    let people = place.answer(arguments);
    let answer = place.answer(&[arguments, &["--json"]].concat());
    assert_eq!((people.code, answer.code), (code, code), "{answer:?}");
    assert_eq!(answer.errors, people.errors, "{arguments:?}");
    assert_eq!(answer.output.matches('\n').count(), 1, "{arguments:?}");
    let found: Value = serde_json::from_str(&answer.output).unwrap();
    assert_eq!(found["command"], arguments[0]);
    assert_eq!(found["format_version"], 1);
    assert!(found["program"].as_str().unwrap().starts_with("sweep "));
    (found, people)
}

fn done(place: &Workplace, arguments: &[&str]) {
    let answer = place.answer(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.errors);
}

/// The rows of a table that a command has written.
fn table(place: &Workplace, name: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(place.path(name)).unwrap();
    let mut rows = text
        .lines()
        .map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    (rows.next().unwrap(), rows.collect())
}

/// Every row of a table is in the document, number by number.
#[track_caller]
fn has_rows(found: &Value, place: &Workplace, name: &str) {
    let (header, rows) = table(place, name);
    let found = found.as_array().unwrap();
    assert_eq!(found.len(), rows.len(), "{name}");
    assert!(!rows.is_empty(), "{name}");
    for (object, row) in found.iter().zip(&rows) {
        assert_eq!(object.as_object().unwrap().len(), header.len(), "{name}");
        for (column, cell) in header.iter().zip(row) {
            let field = &object[column];
            match field {
                Value::Null => assert_eq!(cell, "", "{name}: {column}"),
                Value::Number(_) => {
                    let number: f64 = cell.parse().unwrap();
                    assert_eq!(field.as_f64(), Some(number), "{name}: {column}");
                }
                _ => assert_eq!(field, cell.as_str(), "{name}: {column}"),
            }
        }
    }
}

#[test]
fn a_summary_has_the_counts_of_its_tables() {
    let two = with(SMALL, "[\"quadrature\"]", "[\"quadrature\", \"held\"]");
    let place = Workplace::with_small(&two);
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    let (found, people) = document(&place, &["summary", "out"], 0);
    let (header, rows) = table(&place, "out/labels.csv");
    let column = |name: &str| header.iter().position(|known| known == name).unwrap();
    for method in ["quadrature", "held"] {
        let has = |row: &&Vec<String>| {
            row[column("method")] == method && row[column("torsion")] == "smooth"
        };
        let smooth = rows.iter().filter(has).count();
        assert_eq!(found["manifest"]["labels"][method]["smooth"], smooth);
        assert!(smooth > 0 && people.output.contains(&smooth.to_string()));
    }
    let pair = &found["agreement"]["pairs"][0];
    assert_eq!(pair["compared"], 6);
    let differing = found["agreement"]["differing"].as_u64().unwrap();
    assert_eq!(pair["same"].as_u64().unwrap() + differing, 6);
    let limit = &found["analytic_limit"];
    assert_eq!(limit["limited"], "stick_slip");
    for check in limit["checks"].as_array().unwrap() {
        let count = |side: &str, what: &str| check[side][what].as_u64().unwrap();
        let all = count("below", "vibrating")
            + count("below", "quiet")
            + count("above", "vibrating")
            + count("above", "quiet");
        assert_eq!(all, 6, "{check}");
        let text = format!("{:.3}", check["last_quiet"].as_f64().unwrap());
        assert!(people.output.contains(&text), "{text}: {}", people.output);
    }
    let written = std::fs::read_to_string(place.path("out/manifest.json")).unwrap();
    let written: Value = serde_json::from_str(&written).unwrap();
    assert_eq!(found["manifest"], written);
    assert!(found["so_far"].is_null());
}

#[test]
fn an_analysis_has_the_rows_of_its_tables() {
    let place = Workplace::with_small(&small_with_design(
        "[design]\nkind = \"sensitivity\"\nseed = 2\ncases = 40\n[design.axes]\n\
         surface_speed_rpm = { from = 0.02, to = 0.6 }\nweight_on_bit_kn = { from = 30, to = 70 }\n",
    ));
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    let arguments = [
        "analyse",
        "out",
        "--by",
        "weight_on_bit_kn,surface_speed_rpm",
        "--width",
        "0.05",
        "--out",
        "counts.csv",
        "--indices",
        "indices.csv",
    ];
    let (found, people) = document(&place, &arguments, 0);
    has_rows(&found["counts"], &place, "counts.csv");
    has_rows(&found["indices"], &place, "indices.csv");
    assert_eq!(
        found["files"],
        serde_json::json!(["counts.csv", "indices.csv"])
    );
    assert_eq!(found["blocks"][0]["whole"], 40);
    let more = found["more_cases"].as_array().unwrap();
    let smooth = more.iter().find(|row| row["regime"] == "smooth").unwrap();
    let line = (people.output.lines())
        .find(|line| line.contains(" smooth "))
        .unwrap();
    let last = line.split_whitespace().last().unwrap();
    assert_eq!(smooth["more_cases"].to_string(), last, "{line}");
}

#[test]
fn a_window_has_the_cells_of_its_table_and_the_best_point_of_its_text() {
    let place = Workplace::with_small(&small_with_design(
        "[design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = { from = 0.02, to = 0.6, count = 5 }\n\
         weight_on_bit_kn = { from = 20, to = 80, count = 5 }\n",
    ));
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    let arguments = ["window", "small.toml", "out", "--clearance", "0.06"];
    let (found, people) = document(&place, &arguments, 0);
    has_rows(&found["cells"], &place, "out/window.csv");
    let best = &found["best"];
    let [weight, speed] =
        ["weight_on_bit_kn", "surface_speed_rpm"].map(|axis| best[axis].as_f64().unwrap());
    let line = (people.output.lines())
        .find(|line| line.contains("best point: "))
        .unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    // Three digits of each: "best point: 35.9 kN at 0.565 rpm".
    for (said, exact) in [(words[2], weight), (words[5], speed)] {
        let said: f64 = said.parse().unwrap();
        assert!((said / exact - 1.0).abs() < 5e-3, "{said} {exact}: {line}");
    }
    let safe = &found["cells"].as_array().unwrap().iter().find(|cell| {
        let holds = |axis: &str, at: f64| {
            let end = |end: &str| cell[format!("{axis}_{end}")].as_f64().unwrap();
            end("from") <= at && at <= end("to")
        };
        holds("weight_on_bit_kn", weight) && holds("surface_speed_rpm", speed)
    });
    assert_eq!(safe.unwrap()["standing"], "safe");
    let limits = found["limits"].as_array().unwrap();
    for limit in limits {
        let parts = limit["parts"].as_object().unwrap().values();
        let whole: f64 = parts.map(|part| part.as_f64().unwrap()).sum();
        assert!((whole - 1.0).abs() < 1e-9, "{limit}");
        assert!(people.output.contains(limit["name"].as_str().unwrap()));
    }
    assert!(!limits.is_empty());
}

#[test]
fn a_check_has_every_label_and_the_code_of_those_that_differ() {
    let place = Workplace::with_small(SMALL);
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    place.write("same.csv", &labels);
    let (found, _) = document(&place, &["check", "small.toml", "same.csv"], 0);
    assert_eq!(
        (&found["labels"], &found["different"]),
        (&6.into(), &0.into())
    );
    let smooth = labels.replacen(",smooth,", ",stick_slip,", 1);
    place.write("other.csv", smooth);
    let (found, people) = document(&place, &["check", "small.toml", "other.csv"], 5);
    assert_eq!(found["different"], 1);
    let compared = found["compared"].as_array().unwrap();
    assert_eq!(compared.len(), 6);
    let differs = |label: &&Value| label["expected"] != label["found"];
    let label = compared.iter().find(differs).unwrap();
    let (speed, weight) = (
        &label["values"]["surface_speed_rpm"],
        &label["values"]["weight_on_bit_kn"],
    );
    let distance = label["distance"]["times_speed_limit"].as_f64().unwrap();
    let line = format!(
        "case {} by quadrature: surface_speed_rpm = {speed}, weight_on_bit_kn = {}: expected \
         stick_slip, found smooth, at {distance:.3} times the speed of Eq. 74\n",
        label["case"],
        weight.as_f64().unwrap()
    );
    assert!(people.output.starts_with(&line), "{line}{}", people.output);
    // `--format json` is the same, and may go to a file.
    let arguments = ["check", "small.toml", "other.csv", "--format", "json"];
    let answer = place.answer(&[&arguments[..], &["--output", "check.json"]].concat());
    assert_eq!((answer.code, answer.output), (5, people.output));
    let written = std::fs::read_to_string(place.path("check.json")).unwrap();
    let written: Value = serde_json::from_str(&written).unwrap();
    assert_eq!(written, found);
    // A check that fails does not leave that of before.
    place.write("other.csv", labels.replacen("smooth", "smoth", 1));
    let answer = place.answer(&[&arguments[..], &["--output", "check.json"]].concat());
    assert_eq!((answer.code, answer.output.as_str()), (2, ""));
    let written = std::fs::read_to_string(place.path("check.json")).unwrap();
    assert!(written.contains("\"error\":\"other.csv:"), "{written}");
}

/// The small sweep, sampled coarsely, is warned of.
#[test]
fn an_inspection_has_the_numbers_of_its_text_and_tables() {
    let place = Workplace::with_small(SMALL);
    let arguments = [
        "inspect",
        "small.toml",
        "--out",
        "out",
        "--modes=3",
        "--orders",
        "900",
    ];
    let answer = place.answer(&arguments);
    assert!(answer.errors.contains("warning: "), "{}", answer.errors);
    let json = place.answer(&[&arguments[..], &["--json"]].concat());
    assert_eq!((json.code, json.errors), (0, answer.errors));
    let found: Value = serde_json::from_str(&json.output).unwrap();
    let (text, string) = (&answer.output, &found["string"]);
    let number = |value: &Value| value.as_f64().unwrap();
    let travel = number(&string["travel_time_s"]);
    for expected in [
        format!(
            "length                     {:.3} m",
            number(&string["length_m"])
        ),
        format!("{travel:.4} s, and back {:.4} s", 2.0 * travel),
        format!("{:.3} 1/s", number(&string["torsional_decay_rate_1_s"])),
        format!(
            "{:.1} N m/rad",
            number(&string["torsional_stiffness_nm_rad"])
        ),
        format!("{:.2} Hz (given", number(&string["sampling_frequency_hz"])),
        format!(
            "{:.4e}",
            number(&found["methods"][0]["undershoot_rad_s_per_nm"])
        ),
        format!(
            "by 1 method, the longest {} s",
            found["cost"]["longest_case_s"].as_f64().unwrap()
        ),
        format!("  {}\n", found["left_out"][0].as_str().unwrap()),
        format!("picture: {}\n", found["pictures"][0].as_str().unwrap()),
    ] {
        assert!(text.contains(&expected), "{expected:?} in\n{text}");
    }
    // By hand: τ = L / √(G/ρ).
    let exact = 100.0 / (80e9_f64 / 7840.0).sqrt();
    assert!((travel / exact - 1.0).abs() < 1e-12, "{travel} {exact}");
    has_rows(
        &found["modes"]["critical_speeds"],
        &place,
        "out/critical_speeds.csv",
    );
    let (_, rows) = table(&place, "out/modes.csv");
    let listed = found["modes"]["families"].as_array().unwrap().iter();
    let frequencies = listed.flat_map(|family| family["frequencies_hz"].as_array().unwrap());
    let frequencies: Vec<f64> = frequencies.map(number).collect();
    let written: Vec<f64> = rows.iter().map(|row| row[2].parse().unwrap()).collect();
    assert_eq!(frequencies, written);
}

/// The dry run begins at the start, and continues; it finds nothing left of what is complete.
#[test]
fn a_dry_run_has_the_counts_of_its_text() {
    let place = Workplace::with_small(SMALL);
    let dry = ["run", "small.toml", "--out", "out", "--dry-run"];
    let (found, people) = document(&place, &dry, 0);
    assert_eq!(found["methods"], serde_json::json!(["quadrature"]));
    assert_eq!((&found["cases"], &found["strings"]), (&6.into(), &1.into()));
    assert_eq!(
        (&found["simulations"], &found["simulations_left"]),
        (&6.into(), &6.into())
    );
    let why = found["why"].as_str().unwrap();
    let line = format!("6 of 6 simulations left: {why}\n");
    assert!(people.output.contains(&line), "{line}{}", people.output);
    let number = |name: &str| found[name].as_f64().unwrap();
    // Six cases of 12 s, as the file has them.
    assert_eq!(
        (number("simulated_time_s"), number("longest_case_s")),
        (72.0, 12.0)
    );
    let bytes = |name: &str| found[name].as_u64().unwrap();
    assert!(bytes("memory_bytes") > 0 && bytes("memory_bytes") < bytes("memory_limit_bytes"));
    assert!(number("wall_time_s") > 0.0 && found["never_finishes"].is_null());
    assert!(!place.path("out").exists());

    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    std::fs::remove_file(place.path("out/boundary.csv")).unwrap();
    let (found, people) = document(&place, &dry, 0);
    assert_eq!(found["simulations_left"], 0);
    assert!(found["wall_time_s"].is_null() && found["memory_bytes"].is_null());
    let lost = found["made_again"][0].as_str().unwrap();
    assert!(
        lost.contains("boundary.csv") && people.output.contains(lost),
        "{people:?}"
    );
    // It is of a dry run alone.
    let run = place.answer(&["run", "small.toml", "--json"]);
    assert_eq!((run.code, run.output.as_str()), (2, ""));
}

#[test]
fn a_merge_has_the_manifest_of_the_whole_or_the_shards_that_it_lacks() {
    let place = Workplace::with_small(SMALL);
    let shard = |index: usize| {
        let part = format!("{index}/3");
        let out = format!("part{index}");
        done(
            &place,
            &[
                "run",
                "small.toml",
                "--quiet",
                "--out",
                &out,
                "--shard",
                &part,
            ],
        );
    };
    shard(1);
    let merge = ["merge", "part1", "--out", "out"];
    let (found, people) = document(&place, &merge, 4);
    assert_eq!(
        (&found["shards"], &found["finished"]),
        (&3.into(), &1.into())
    );
    assert_eq!(found["run_again"], "0,2");
    let command = found["run_again_with"].as_str().unwrap();
    assert!(people.errors.contains(command), "{command}: {people:?}");
    assert!(found["manifest"].is_null() && !place.path("out").exists());
    for index in [0, 2] {
        shard(index);
    }
    let merge = ["merge", "part0", "part1", "part2", "--out", "out"];
    let (found, people) = document(&place, &merge, 0);
    assert_eq!(
        (&found["finished"], &found["run_again"]),
        (&3.into(), &"".into())
    );
    assert_eq!(found["folder"], "out");
    let written = std::fs::read_to_string(place.path("out/manifest.json")).unwrap();
    let written: Value = serde_json::from_str(&written).unwrap();
    assert_eq!(found["manifest"], written);
    let smooth = &found["manifest"]["labels"]["quadrature"]["smooth"];
    assert!(
        people.output.contains(&format!("{smooth} smooth")),
        "{people:?}"
    );
}

#[test]
fn a_reference_has_the_counts_of_its_first_line() {
    let place = Workplace::with_small(SMALL);
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    let reference = [
        "reference",
        "out",
        "--margin",
        "2%",
        "--along",
        "surface_speed_rpm",
    ];
    let (found, people) = document(&place, &reference, 0);
    let [kept, dropped] = ["kept", "dropped"].map(|name| found[name].as_u64().unwrap());
    assert_eq!((kept + dropped, &found["cases"]), (6, &6.into()));
    let line = format!("{kept} of 6 cases kept, {dropped} dropped");
    assert!(people.output.starts_with(&line), "{people:?}");
    assert_eq!(found["margin"], 0.02);
    assert_eq!(found["along"], serde_json::json!(["surface_speed_rpm"]));
    assert_eq!(found["file"], "out/reference.csv");
    let (_, rows) = table(&place, "out/reference.csv");
    let cases = rows.iter().filter(|row| row[0].parse::<usize>().is_ok());
    assert_eq!(cases.count() as u64, kept);
}

#[test]
fn an_error_is_on_standard_error_alone() {
    let place = Workplace::with_small(&with(SMALL, "time_s = 12", "time_s = -12"));
    for arguments in [
        &["summary", "nowhere"][..],
        &["analyse", "nowhere"],
        &["inspect", "small.toml"],
        &["window", "small.toml"],
        &["check", "small.toml", "nowhere.csv"],
        &["run", "small.toml", "--dry-run"],
        &["merge", "nowhere", "--out", "out"],
        &["reference", "nowhere"],
    ] {
        let people = place.answer(arguments);
        let answer = place.answer(&[arguments, &["--json"]].concat());
        assert_eq!((people.code, answer.code), (2, 2), "{answer:?}");
        assert_eq!(
            (answer.output.as_str(), &answer.errors),
            ("", &people.errors)
        );
        assert!(answer.errors.starts_with("error: "), "{answer:?}");
    }
}

/// A reader that has seen enough is no error.
#[test]
fn a_closed_pipe_is_no_error() {
    let place = Workplace::with_small(SMALL);
    let arguments = ["inspect", "small.toml", "--out", "out", "--json"];
    let mut command = place.command(&arguments);
    let mut running = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(running.stdout.take());
    let status = running.wait().unwrap();
    let mut errors = String::new();
    running.stderr.unwrap().read_to_string(&mut errors).unwrap();
    assert!(status.success(), "{errors}");
    assert!(!errors.contains("panicked"), "{errors}");
}
