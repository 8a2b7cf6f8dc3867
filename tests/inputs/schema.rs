//! The JSON Schema of sweep files, which `sweep schema` prints. The tests of the Python package hold
//! files to it, by a validator of others' making.

use serde_json::Value;

use crate::support::Workplace;

/// The schema of the program.
fn schema() -> Value {
    let answer = Workplace::new().sweep(&["schema"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    serde_json::from_str(&answer.output).unwrap()
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
