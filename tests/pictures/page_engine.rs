//! The engine of a page, as it is kept in the repository, against what the sources are now: the
//! sweeps that they open, the histories and rows of `sweep simulate`. It runs in Node, by the
//! client that the page has.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::support::{CUTTING, Workplace};
use serde_json::{Value, json};

/// Differences of numbers in parts of the largest of their column.
const TOLERANCE: f64 = 1e-9;

/// What to do where they differ.
const RENEW: &str =
    "the kept engine does not answer as the program does: run scripts/renew-page-engine.sh";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A shipped sweep file and its bases, by their paths.
fn texts(name: &str) -> BTreeMap<String, String> {
    let mut texts = BTreeMap::new();
    let mut next = Some(name.to_owned());
    while let Some(name) = next {
        let text = std::fs::read_to_string(root().join("sweeps").join(&name)).unwrap();
        let table: toml::Table = text.parse().unwrap();
        next = (table.get("base")).map(|base| base.as_str().unwrap().to_owned());
        texts.insert(name, text);
    }
    texts
}

/// What the engine answers to openings, each with cases.
fn asked(place: &Workplace, openings: &Value) -> Vec<Value> {
    let asked = place.path("asked.json");
    std::fs::write(&asked, openings.to_string()).unwrap();
    let answer = Command::new("node")
        .arg(root().join("tests/page/follow.mjs"))
        .arg(root().join("crates/sweep/src/page"))
        .arg(asked)
        .output()
        .expect("Node");
    let errors = String::from_utf8_lossy(&answer.stderr);
    assert!(answer.status.success(), "{errors}\n{RENEW}");
    serde_json::from_slice(&answer.stdout).unwrap()
}

/// What the engine answers to cases of a sweep.
fn followed(place: &Workplace, opening: &Value, cases: Value) -> Vec<Value> {
    let mut answers = asked(place, &json!([{ "opening": opening, "cases": cases }]));
    match answers.remove(0)["followed"].take() {
        Value::Array(followed) => followed,
        other => panic!("{other}"),
    }
}

/// `history.csv` by its columns.
fn history(place: &Workplace, folder: &str) -> BTreeMap<String, Vec<f64>> {
    let mut reader = csv::Reader::from_path(place.path(folder).join("history.csv")).unwrap();
    let names: Vec<String> = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for row in reader.records() {
        for (name, text) in names.iter().zip(&row.unwrap()) {
            if name != "case" && name != "method" {
                columns
                    .entry(name.clone())
                    .or_default()
                    .push(text.parse().unwrap());
            }
        }
    }
    columns
}

/// Holds what the engine says of a case of a shipped sweep by a method against `sweep simulate`.
#[track_caller]
fn agrees(name: &str, method: &str, case: usize, set: &[(&str, f64)]) {
    let place = Workplace::new();
    let file = root().join("sweeps").join(name);
    let (file, case_text) = (file.to_str().unwrap(), case.to_string());
    let mut arguments = vec!["simulate", file, "--out", "one", "--methods", method];
    arguments.extend(["--case", &case_text]);
    let changes: Vec<String> = set
        .iter()
        .map(|(axis, value)| format!("{axis}={value}"))
        .collect();
    arguments.extend(changes.iter().flat_map(|change| ["--set", change]));
    let done = place.sweep(&arguments);
    assert_eq!(done.code, 0, "{}", done.errors);

    let set: BTreeMap<_, _> = set.iter().copied().collect();
    let case = json!({ "case": case, "method": method, "set": set });
    let opening = json!({ "path": name, "texts": texts(name) });
    // The second time the system is there.
    let answers = followed(&place, &opening, json!([case, case]));
    let expected = history(&place, "one");
    let mut rows = csv::Reader::from_path(place.path("one").join("case.csv")).unwrap();
    let torsion = rows
        .headers()
        .unwrap()
        .iter()
        .position(|name| name == "torsion");
    let row = rows.records().next().unwrap().unwrap();
    for answer in &answers {
        assert_eq!(answer["error"], Value::Null, "{RENEW}");
        let label = answer["row"]["torsion"].as_str().unwrap_or_default();
        assert_eq!(label, &row[torsion.unwrap()], "{RENEW}");
        let found = answer["columns"].as_object().unwrap();
        assert!(found.keys().eq(expected.keys()), "{RENEW}");
        for (name, expected) in &expected {
            let found = found[name].as_array().unwrap().iter();
            let found: Vec<f64> = found.map(|value| value.as_f64().unwrap()).collect();
            assert_eq!(found.len(), expected.len(), "{name}: {RENEW}");
            let size = expected
                .iter()
                .fold(0.0, |size: f64, value| size.max(value.abs()));
            let pairs = found.iter().zip(expected);
            let off = pairs.fold(0.0, |off: f64, (one, other)| off.max((one - other).abs()));
            assert!(
                off <= TOLERANCE * size,
                "{name} is off by {off} of {size}: {RENEW}"
            );
        }
    }
}

#[test]
#[ignore = "needs Node"]
fn stick_slip_of_fig_8b_is_that_of_the_command() {
    agrees("fig08b.toml", "hilbert", 0, &[]);
}

#[test]
#[ignore = "needs Node"]
fn a_case_of_fig_9_is_that_of_the_command() {
    agrees("fig09.toml", "quadrature", 7, &[]);
}

#[test]
#[ignore = "needs Node"]
fn a_case_with_quantities_set_is_that_of_the_command() {
    let set = [
        ("surface_speed_rpm", 0.13),
        ("torsional_damping_nms_rad_m", 12.0),
    ];
    agrees("fig09.toml", "quadrature", 7, &set);
}

#[test]
#[ignore = "needs Node"]
fn whirl_of_fig_12_is_that_of_the_command() {
    agrees("fig12.toml", "quadrature", 0, &[]);
}

#[test]
#[ignore = "needs Node"]
fn what_is_refused_is_refused_in_the_words_of_the_command() {
    let place = Workplace::new();
    let opening = json!({ "path": "fig09.toml", "texts": texts("fig09.toml") });
    let cases = json!([{ "set": { "surface_speed_rpm": -1.0 } }, { "case": 1_000_000 }]);
    let answers = followed(&place, &opening, cases);
    let file = root().join("sweeps/fig09.toml");
    let file = file.to_str().unwrap();
    let done = place.sweep(&["simulate", file, "--set", "surface_speed_rpm=-1"]);
    let words = answers[0]["error"].as_str().unwrap();
    assert!(
        done.errors.contains(words),
        "{words}\n{}\n{RENEW}",
        done.errors
    );
    let words = answers[1]["error"].as_str().unwrap();
    assert!(
        words.starts_with("case 1000000: there are cases 0 to"),
        "{words}\n{RENEW}"
    );
}

/// As the page of `report` opens it: by the resolved sweep of its manifest, which has every key.
#[test]
fn a_resolved_sweep_whose_bit_cuts_is_opened() {
    let place = Workplace::with_small(CUTTING);
    let done = place.sweep(&["run", "small.toml"]);
    assert_eq!(done.code, 0, "{}", done.errors);
    let manifest = std::fs::read(place.path("results/small/manifest.json")).unwrap();
    let manifest: Value = serde_json::from_slice(&manifest).unwrap();
    let opening = json!({ "path": "small.toml", "sweep": manifest["sweep"], "texts": {} });
    let request = json!({ "open": opening }).to_string();
    let answer = page::Engine::default().answer(request.as_bytes()).words;
    let answer: Value = serde_json::from_str(&answer).unwrap();
    assert_eq!(answer["ok"]["cases"], 6, "{answer}");
}

/// Every shipped sweep, with what it names: a key that the kept engine does not know, or takes for
/// something else, is found here.
#[test]
#[ignore = "needs Node"]
fn every_shipped_sweep_is_opened_as_the_sources_open_it() {
    let files = std::fs::read_dir(root().join("sweeps")).unwrap();
    let texts: BTreeMap<String, String> = files
        .map(|file| file.unwrap().path())
        .map(|file| {
            let name = file.file_name().unwrap().to_str().unwrap().to_owned();
            (name, std::fs::read_to_string(&file).unwrap())
        })
        .collect();
    let openings: Vec<Value> = (texts.keys())
        .filter(|name| name.ends_with(".toml"))
        .map(|name| json!({ "opening": { "path": name, "texts": texts }, "cases": [] }))
        .collect();
    assert!(openings.len() > 40, "{}", openings.len());
    let answers = asked(&Workplace::new(), &json!(openings));
    for (asked, answer) in openings.iter().zip(answers) {
        let request = json!({ "open": asked["opening"] }).to_string();
        let expected = page::Engine::default().answer(request.as_bytes()).words;
        let expected: Value = serde_json::from_str(&expected).unwrap();
        let name = &asked["opening"]["path"];
        assert!(expected.get("ok").is_some(), "{name}: {expected}");
        let opened = answer["opened"].clone();
        assert_eq!(floats(opened), floats(expected), "{name}: {RENEW}");
    }
}

/// With every number a double, as a script has them: 15 and 15.0 are one.
fn floats(value: Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64()),
        Value::Array(values) => values.into_iter().map(floats).collect(),
        Value::Object(fields) => (fields.into_iter())
            .map(|(name, value)| (name, floats(value)))
            .collect(),
        other => other,
    }
}
