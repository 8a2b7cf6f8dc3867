//! A sweep that asks for an accuracy: what it is given is within it, by a limit found at a much
//! higher sampling frequency, and the same on every machine.

use crate::support::{Workplace, with};

/// [`FEW`], asking for an accuracy.
fn asking(accuracy: &str, text: &str) -> String {
    let own = "sampling_frequency_hz = 100\nmethods = [\"quadrature\"]\n";
    with(text, own, &format!("accuracy = {accuracy}\n"))
}

fn sweeps(name: &str) -> String {
    format!("{}/../../sweeps/{name}", env!("CARGO_MANIFEST_DIR"))
}

#[track_caller]
fn run(place: &Workplace, file: &str, out: &str) -> serde_json::Value {
    let answer = place.sweep(&["run", file, "--out", out, "--quiet"]);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""), "{answer:?}");
    manifest(place, out)
}

fn manifest(place: &Workplace, out: &str) -> serde_json::Value {
    let text = std::fs::read(place.path(out).join("manifest.json")).unwrap();
    serde_json::from_slice(&text).unwrap()
}

fn labels(place: &Workplace, out: &str) -> String {
    std::fs::read_to_string(place.path(out).join("labels.csv")).unwrap()
}

/// The axis value between the last row with `label` and the first without, along a
/// sweep of one axis whose rows begin with `label`.
#[track_caller]
fn limit(place: &Workplace, out: &str, axis: &str, label: [&str; 2]) -> f64 {
    let text = labels(place, out);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let place = |name: &str| header.iter().position(|field| field == name).unwrap();
    let (axis, column) = (place(axis), place(label[0]));
    let rows: Vec<(f64, bool)> = (reader.records())
        .map(|row| {
            let row = row.unwrap();
            (row[axis].parse().unwrap(), &row[column] == label[1])
        })
        .collect();
    let last = rows.iter().rposition(|(_, inside)| *inside == rows[0].1);
    let last = last.unwrap();
    assert!(last + 1 < rows.len(), "no limit in\n{text}");
    (rows[last].0 * rows[last + 1].0).sqrt()
}

/// The limit along one axis for an accuracy, and by a method at a much higher sampling
/// frequency; the axis is finer than the accuracy.
#[track_caller]
fn is_within(setting: &str, axis: &str, label: [&str; 2], accuracy: f64, fine: (&str, f64)) {
    let place = Workplace::new();
    place.write("asked.toml", format!("accuracy = {accuracy}\n{setting}"));
    let (method, frequency) = fine;
    let fine = format!("methods = [\"{method}\"]\nsampling_frequency_hz = {frequency}\n{setting}");
    place.write("fine.toml", fine);
    let manifest = run(&place, "asked.toml", "asked");
    run(&place, "fine.toml", "fine");
    let delivered = manifest["accuracy"]["delivered"].as_f64().unwrap();
    assert!(delivered <= accuracy, "{delivered}");
    let found = limit(&place, "asked", axis, label);
    let exact = limit(&place, "fine", axis, label);
    let error = (found / exact - 1.0).abs();
    println!(
        "{}: limit {found}, exact {exact}",
        manifest["accuracy"]["chosen"]
    );
    assert!(error <= accuracy, "{found} {exact}: {manifest}");
}

fn stick_slip(base: &str, from: f64, to: f64) -> String {
    format!(
        "base = \"{base}\"\n[bit]\nrock = \"sandstone\"\nweight_on_bit_kn = 60\n\
         [design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = {{ from = {from}, to = {to}, count = 50, spacing = \"log\" }}\n"
    )
}

const STICK_SLIP: [&str; 2] = ["torsion", "stick_slip"];

#[test]
fn the_limit_of_stick_slip_is_within_the_accuracy() {
    let setting = stick_slip(&sweeps("academic.toml"), 0.185, 0.235);
    // The quadrature comes down to the limit slowly: at 10 kHz it is 4 % below.
    for (accuracy, fine) in [(0.1, ("quadrature", 10240.0)), (0.01, ("hilbert", 20480.0))] {
        is_within(&setting, "surface_speed_rpm", STICK_SLIP, accuracy, fine);
    }
}

/// Twice as long as the paper's, of thinner pipe in cells of 12 m.
#[test]
fn the_limit_on_a_longer_string_is_within_the_accuracy() {
    let string = "[string]\nshear_modulus_gpa = 79\ndensity_kg_m3 = 7850\n\
         torsional_damping_nms_rad_m = 1.2\n\
         [[string.sections]]\nrepeat = 160\nparts = [\n\
         { length_m = 11.4, inner_radius_m = 0.08, outer_radius_m = 0.1 },\n\
         { length_m = 0.6, inner_radius_m = 0.08, outer_radius_m = 0.11 },\n]\n\
         [[string.sections]]\nrepeat = 10\n\
         parts = [{ length_m = 12, inner_radius_m = 0.04, outer_radius_m = 0.12 }]\n";
    let setting = format!(
        "[bit]\ntorque_dynamic_nm = 4000\n{string}\n[design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.25, to = 1, count = 40, spacing = \"log\" }}\n"
    );
    let fine = ("quadrature", 2560.0);
    is_within(&setting, "surface_speed_rpm", STICK_SLIP, 0.15, fine);
}

#[test]
fn the_limit_of_whirl_is_within_the_accuracy() {
    let setting = format!(
        "base = \"{}\"\n[design]\nkind = \"grid\"\n[design.axes]\n\
         friction = {{ from = 1.0, to = 1.5, count = 80, spacing = \"log\" }}\n",
        sweeps("fig10.toml")
    );
    let whirl = ["lateral", "backward_whirl"];
    for (accuracy, frequency) in [(0.1, 1280.0), (0.03, 2560.0)] {
        let fine = ("quadrature", frequency);
        is_within(&setting, "friction", whirl, accuracy, fine);
    }
}

/// A few cases of Fig. 9.
const FEW: &str = r#"surface_speed_rpm = 60
sampling_frequency_hz = 100
methods = ["quadrature"]

[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10

[[string.sections]]
repeat = 60
parts = [
    { length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.125 },
    { length_m = 0.5, inner_radius_m = 0.05, outer_radius_m = 0.15 },
]

[bit]
rock = "sandstone"

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { values = [0.08, 0.5] }
weight_on_bit_kn = { values = [40, 70] }
"#;

#[test]
fn the_choice_is_the_same_for_any_threads_and_spelling() {
    let place = Workplace::new();
    for (name, accuracy) in [("a", "\"30 %\""), ("b", "0.3"), ("c", "\"30%\"")] {
        place.write(&format!("{name}.toml"), asking(accuracy, FEW));
        run(&place, &format!("{name}.toml"), name);
    }
    let alone = ["run", "a.toml", "--out", "alone", "--jobs", "1"];
    assert_eq!(place.sweep(&alone).code, 0);
    let first = manifest(&place, "a");
    let tried = first["accuracy"]["tried"].as_array().unwrap();
    assert!(!tried.is_empty());
    assert_eq!(first["sampling_frequency_by_rule"], false);
    for other in ["b", "c", "alone"] {
        assert!(labels(&place, other) == labels(&place, "a"), "{other}");
        for key in ["accuracy", "meaning_sha256"] {
            assert_eq!(manifest(&place, other)[key], first[key], "{other}");
        }
    }
    // The same sweep continues, and another accuracy is another sweep.
    let again = place.sweep(&["run", "b.toml", "--out", "a"]);
    assert!(again.output.starts_with("complete already"), "{again:?}");
    place.write("d.toml", asking("0.4", FEW));
    let other = place.sweep(&["run", "d.toml", "--out", "a"]);
    assert_eq!(other.code, 2);
    assert!(other.errors.contains("accuracy: 0.3 → 0.4"), "{other:?}");
}

#[test]
fn shards_choose_alike_and_merge() {
    let place = Workplace::with_small(&asking("\"30 %\"", FEW));
    run(&place, "small.toml", "whole");
    for shard in ["0/2", "1/2"] {
        let out = format!("part-{}", &shard[..1]);
        let answer = place.sweep(&["run", "small.toml", "--shard", shard, "--out", &out]);
        assert_eq!(answer.code, 0, "{answer:?}");
    }
    let merged = place.sweep(&["merge", "part-0", "part-1", "--out", "joined"]);
    assert_eq!(merged.code, 0);
    assert!(labels(&place, "whole") == labels(&place, "joined"));
}

#[test]
fn what_was_chosen_is_reported() {
    let place = Workplace::with_small(&asking("\"30 %\"", FEW));
    for arguments in [
        &["run", "small.toml", "--dry-run"][..],
        &["inspect", "small.toml"],
        &["run", "small.toml"],
    ] {
        let answer = place.sweep(arguments);
        for reported in ["accuracy 30 %: ", "reference: held at"] {
            assert!(answer.output.contains(reported), "{answer:?}");
        }
    }
    // The other commands use it too, and say on the error stream what it took.
    let simulated = place.sweep(&["simulate", "small.toml", "--case", "1"]);
    assert_eq!(simulated.code, 0);
    let reported = simulated.errors.lines().last().unwrap_or_default();
    assert!(
        reported.starts_with("accuracy: ") && reported.contains(" Hz, chosen in "),
        "{simulated:?}"
    );
}

/// Where axes change the string, every probe has its own.
#[test]
fn the_strings_of_a_sweep_count() {
    let axis = "[design.axes]\ntorsional_damping_nms_rad_m = { values = [10, 11] }\n";
    let place = Workplace::with_small(&asking("\"30 %\"", &with(FEW, "[design.axes]\n", axis)));
    let manifest = run(&place, "small.toml", "results");
    let probes = manifest["accuracy"]["probes"].as_array().unwrap();
    assert_eq!(probes.len(), 8);
}

#[test]
fn what_is_given_last_replaces_the_other_and_both_at_once_are_refused() {
    let place = Workplace::with_small(&asking("\"30 %\"", FEW));
    place.write("asks.toml", "base = \"plain.toml\"\naccuracy = 0.3\n");
    place.write("plain.toml", FEW);
    let names = "methods = [\"quadrature\"]\nsampling_frequency_hz = 100\n";
    place.write("names.toml", format!("base = \"small.toml\"\n{names}"));
    assert!(run(&place, "asks.toml", "asks")["accuracy"].is_object());
    assert!(run(&place, "names.toml", "names")["accuracy"].is_null());
    for (line, key) in [
        ("methods = [\"hilbert\"]", "methods"),
        ("sampling_frequency_hz = 200", "sampling_frequency_hz"),
        ("method.hilbert.transform_s = 3", "method"),
    ] {
        let both = format!("base = \"plain.toml\"\naccuracy = 0.3\n{line}\n");
        place.write("both.toml", both);
        let answer = place.sweep(&["run", "both.toml"]);
        assert_eq!(answer.code, 2);
        let meant = format!("both.toml:2: `accuracy`: conflicts with `{key}`: give only one");
        assert!(answer.errors.contains(&meant), "{answer:?}");
    }
}

#[test]
fn an_invalid_accuracy_is_refused() {
    let form = "expected an accuracy such as \"1 %\" or 0.01";
    for (accuracy, meant) in [
        ("\"1 percent\"", form),
        ("\"0.01\"", form),
        ("\"high\"", form),
        ("true", form),
        ("1", "100 % is not between 0.01 % and 50 %"),
        ("\"-1 %\"", "-1 % is not between 0.01 % and 50 %"),
        ("nan", "is not between 0.01 % and 50 %"),
    ] {
        let place = Workplace::with_small(&asking(accuracy, FEW));
        let before = place.files();
        let answer = place.sweep(&["run", "small.toml"]);
        assert_eq!(answer.code, 2, "{answer:?}");
        for said in ["small.toml:2: `accuracy`: ", meant] {
            assert!(answer.errors.contains(said), "{answer:?}");
        }
        assert!(place.files() == before);
    }
    let place = Workplace::with_small(&asking("0.3", FEW));
    let answer = place.sweep(&["run", "small.toml", "--methods", "hilbert"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("leave out --methods"), "{answer:?}");
}

/// The reference is certain to so little, and nothing else comes as near to it.
#[test]
fn an_accuracy_that_nothing_delivers_is_refused_with_the_best() {
    let place = Workplace::with_small(&asking("\"0.01 %\"", FEW));
    let answer = place.sweep(&["run", "small.toml"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    let refusal = "nothing delivers 0.01 %; the best, ";
    assert!(answer.errors.contains(refusal), "{answer:?}");
}

/// Columns of the rows of a run.
fn columns(place: &Workplace, out: &str, names: [&str; 2]) -> Vec<[f64; 2]> {
    let text = labels(place, out);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let places = names.map(|name| header.iter().position(|field| field == name).unwrap());
    let rows = reader.records().map(Result::unwrap);
    rows.map(|row| places.map(|place| row[place].parse().unwrap()))
        .collect()
}

/// Mean rates of penetration at each of two speeds.
fn rates(place: &Workplace, out: &str, speeds: [f64; 2]) -> [f64; 2] {
    let rows = columns(place, out, ["surface_speed_rpm", "rate_of_penetration_m_h"]);
    speeds.map(|speed| {
        let of_speed = rows.iter().filter(|row| row[0] == speed).map(|row| row[1]);
        let found: Vec<f64> = of_speed.collect();
        assert_eq!(found.len(), 12);
        found.iter().sum::<f64>() / found.len() as f64
    })
}

/// Above a bit that cuts: means of starts that the choice has not seen are those of much finer steps by
/// another method, and chance is known to be a part of what is uncertain.
#[test]
fn rates_of_penetration_are_within_the_accuracy() {
    let place = Workplace::new();
    let speeds = [60.0, 150.0];
    let setting = format!(
        "base = \"{}\"\n[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = {{ values = [90] }}\n\
         surface_speed_rpm = {{ values = [60, 150] }}\nstart_number = {{ from = 101, to = 112, count = 12 }}\n",
        sweeps("axial.toml")
    );
    place.write("asked.toml", format!("accuracy = 0.1\n{setting}"));
    let fine = "methods = [\"quadrature\"]\nsampling_frequency_hz = 5000\n";
    place.write("fine.toml", format!("{fine}{setting}"));
    let chosen = run(&place, "asked.toml", "asked");
    run(&place, "fine.toml", "fine");
    let accuracy = &chosen["accuracy"];
    let uncertain = accuracy["reference_uncertainty"].as_f64().unwrap();
    assert!(uncertain > 0.0 && uncertain <= 0.05, "{accuracy}");
    assert!(
        accuracy["chosen"]["sampling_frequency_hz"].as_f64() < Some(1000.0),
        "{accuracy}"
    );
    let [found, exact] = ["asked", "fine"].map(|out| rates(&place, out, speeds));
    let squares = found
        .iter()
        .zip(&exact)
        .map(|(one, other)| (one / other - 1.0).powi(2));
    let error = (squares.sum::<f64>() / 2.0).sqrt();
    println!("{error} {found:?} {exact:?} {accuracy}");
    assert!(error <= 0.1, "{found:?} {exact:?} {accuracy}");
}
