//! The sampling frequency: by default that of the string, and refused where it is too low.

use super::text;
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

const PARTS: &str = "{ length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.125 },\n    \
                     { length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.15 },";

/// The small sweep by two methods at its default frequency, its string these parts so often.
fn divided(repeat: usize, parts: &str) -> String {
    let text = with(SMALL, "sampling_frequency_hz = 100\n", "");
    let methods = "methods = [\"held\", \"finite-element\"]";
    let text = with(&text, "methods = [\"quadrature\"]", methods);
    let text = with(&text, "repeat = 10", &format!("repeat = {repeat}"));
    with(&text, PARTS, parts)
}

fn tube(length: f64) -> String {
    format!("{{ length_m = {length}, inner_radius_m = 0.05, outer_radius_m = 0.125 }},")
}

/// One part, cells, and parts of any length: all of 1000 m.
#[test]
fn a_string_divided_in_any_way_has_the_same_frequency_and_labels() {
    let uneven: String = [137.2, 8.1, 401.7, 453.0].map(tube).concat();
    let found = [
        divided(1, &tube(1000.0)),
        divided(100, &tube(10.0)),
        divided(1, &uneven),
    ]
    .map(|file| {
        let place = Workplace::with_small(&file);
        // Elements let its fronts overshoot, which is warned of.
        let plan = place.sweep(&["inspect", "small.toml"]);
        let row = plan.output.lines().find(|line| line.contains("f_s"));
        let answer = place.sweep(&["run", "small.toml", "--out", "results"]);
        assert_eq!(answer.code, 0, "{answer:?}");
        (row.unwrap().to_owned(), labels_of(&place))
    });
    assert!(found[0].0.contains("1000 steps a travel time"), "{found:?}");
    assert_eq!(found[0], found[1]);
    assert_eq!(found[0], found[2]);
}

/// The labels of all cases, without measures.
fn labels_of(place: &Workplace) -> Vec<String> {
    let rows = super::table(&text(place, "results/labels.csv"));
    let column = rows[0].iter().position(|name| name == "torsion").unwrap();
    rows[1..].iter().map(|row| row[column].clone()).collect()
}

/// The paper's string at 1 Hz: the bit would turn smoothly by all methods.
#[test]
fn sampling_slower_than_the_string_is_refused_with_what_to_write() {
    let slow = with(SMALL, "repeat = 10\n", "repeat = 100\n");
    let slow = with(&slow, "frequency_hz = 100", "frequency_hz = 1");
    let place = Workplace::with_small(&slow);
    let words = [
        "small.toml:5: ",
        "`sampling_frequency_hz`: 1 Hz is too low",
        "Write at least 7 Hz",
    ];
    refused(&place, &["run", "small.toml"], &words);
    // With nothing that torsion decides there is nothing to refuse.
    let free = with(&slow, "[bit]\nrock = \"sandstone\"\n", "");
    let free = with(&free, "weight_on_bit_kn = { values = [30, 70] }\n", "");
    let place = Workplace::with_small(&free);
    let answer = place.sweep(&["inspect", "small.toml"]);
    assert!(!answer.errors.contains("too low"), "{answer:?}");
}

#[test]
fn fronts_that_are_smeared_are_warned_of_with_how_far() {
    let slow = with(SMALL, "repeat = 10\n", "repeat = 100\n");
    let slow = with(&slow, "frequency_hz = 100", "frequency_hz = 20");
    let place = Workplace::with_small(&slow);
    let answer = place.answer(&["run", "small.toml", "--methods", "held", "--out", "slow"]);
    let warning = "warning: fronts are smeared by held: ";
    assert!(answer.errors.contains(warning), "{answer:?}");
    assert!(
        answer.errors.contains("% below the exact one"),
        "{answer:?}"
    );
    let usual = with(&slow, "sampling_frequency_hz = 20\n", "");
    place.write("usual.toml", usual);
    let answer = place.answer(&["run", "usual.toml", "--methods", "held", "--out", "usual"]);
    assert!(!answer.errors.contains("fronts"), "{answer:?}");
}
