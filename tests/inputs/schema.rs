//! The JSON Schema of sweep files, which `sweep schema` prints, against shipped files and wrong
//! ones.

use std::path::Path;

use jsonschema::Validator;
use serde_json::Value;

use crate::support::{SMALL, Workplace, with};

/// The schema of the program.
fn schema() -> Value {
    let answer = Workplace::new().sweep(&["schema"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    serde_json::from_str(&answer.output).unwrap()
}

/// What checks files by it.
fn validator() -> Validator {
    let schema = schema();
    assert!(jsonschema::meta::is_valid(&schema));
    jsonschema::draft202012::new(&schema).unwrap()
}

/// A file as JSON has it.
fn json(text: &str) -> Value {
    let table: toml::Table = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}: {text}"));
    serde_json::to_value(table).unwrap()
}

/// What is wrong with a file by the schema.
fn faults(validator: &Validator, text: &str) -> Vec<String> {
    let file = json(text);
    let errors = validator.iter_errors(&file);
    errors
        .map(|error| format!("{}: {error}", error.instance_path()))
        .collect()
}

#[test]
fn every_shipped_sweep_is_one_by_the_schema() {
    let validator = validator();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    let mut files = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            let text = std::fs::read_to_string(&path).unwrap();
            let faults = faults(&validator, &text);
            assert!(faults.is_empty(), "{}: {faults:#?}", path.display());
            files += 1;
        }
    }
    assert!(files > 30, "{files}");
}

#[test]
fn the_file_of_sweep_new_is_one_by_the_schema() {
    let place = Workplace::new();
    assert_eq!(place.sweep(&["new", "my-sweep.toml"]).code, 0);
    let text = std::fs::read_to_string(place.path("my-sweep.toml")).unwrap();
    assert_eq!(faults(&validator(), &text), [""; 0]);
}

/// What the program refuses, an editor underlines.
#[test]
fn what_the_program_refuses_is_none() {
    let validator = validator();
    assert_eq!(faults(&validator, SMALL), [""; 0]);
    for (piece, replacement) in [
        // Misspelt keys and choices, also of an axis.
        ("title =", "titel ="),
        ("repeat =", "repeats ="),
        ("rock = \"sandstone\"", "rock = \"sand\""),
        ("methods = [\"quadrature\"]", "methods = [\"quadratur\"]"),
        ("weight_on_bit_kn = { values", "weight_on_bit = { values"),
        ("surface_speed_rpm = { from", "site_00_friction = { from"),
        // A unit that the key has not, and a quantity in two units.
        ("shear_modulus_gpa = 80", "shear_modulus_mpa = 80e3"),
        ("{ length_m = 9.5,", "{ length_m = 9.5, length_ft = 31,"),
        // Out of range, another kind of value, missing.
        ("shear_modulus_gpa = 80", "shear_modulus_gpa = 80e9"),
        ("time_s = 12", "time_s = \"long\""),
        ("repeat = 10\n", ""),
        ("shear_modulus_gpa = 80\n", ""),
        ("kind = \"grid\"", ""),
        // Two keys that say the same.
        (
            "methods = [\"quadrature\"]",
            "accuracy = \"1 %\"\nmethods = [\"held\"]",
        ),
    ] {
        let text = with(SMALL, piece, replacement);
        assert!(!faults(&validator, &text).is_empty(), "{replacement}");
    }
}

/// Over a base a file says only what it changes; in field units it says the same in others.
#[test]
fn what_the_program_reads_is_one() {
    let validator = validator();
    for text in [
        "base = \"other.toml\"\n[string]\nshear_modulus_gpa = 75\n",
        "base = \"other.toml\"\n[string]\nfile = \"bha.csv\"\n",
        &with(
            SMALL,
            "shear_modulus_gpa = 80",
            "shear_modulus_psi = 11.6e6",
        ),
        &with(SMALL, "{ length_m = 9.5,", "{ length_ft = 31,"),
        &with(SMALL, "outer_radius_m = 0.125", "outer_diameter_in = 9.84"),
        &with(
            SMALL,
            "weight_on_bit_kn = { values",
            "weight_on_bit_klbf = { values",
        ),
        &with(
            SMALL,
            "surface_speed_rpm = { from",
            "section_0_part_1_outer_diameter_in = { from",
        ),
        &with(SMALL, "time_s = 12", "time_s = \"auto\""),
        &with(SMALL, "methods = [\"quadrature\"]\n", "")
            .replace("sampling_frequency_hz = 100", "accuracy = \"1.5 %\""),
    ] {
        assert_eq!(faults(&validator, text), [""; 0], "{text}");
    }
}

/// What an editor shows of a key says in which unit it is.
#[test]
fn every_key_with_a_unit_states_it() {
    let schema = schema();
    let tube = &schema["$defs"]["TubeTable"]["properties"];
    let description = |key: &str| tube[key]["description"].as_str().unwrap();
    assert_eq!(description("length_m"), "Length. Unit: m.");
    assert_eq!(
        description("length_ft"),
        "Length. Unit: ft, in place of `length_m`."
    );
    assert_eq!(
        description("inner_diameter_in"),
        "Internal diameter. Unit: in, in place of `inner_radius_m`."
    );
    let radius = tube["inner_radius_m"]["maximum"].as_f64().unwrap();
    let diameter = tube["inner_diameter_in"]["maximum"].as_f64().unwrap();
    assert!((diameter * 0.0254 - 2.0 * radius).abs() < 1e-9);
}
