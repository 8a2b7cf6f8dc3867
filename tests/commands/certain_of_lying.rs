//! Labels of strings on the low side of their holes that are certain, held to a method that has no part in it.

use rayon::prelude::*;
use results::analysis::wilson;

use crate::support::{Workplace, with};
use crate::window::{Numbers, table};
use crate::window_of_lying::{pipe, random_collar};

/// Columns of the label and of whether it is certain.
const LABEL: [&str; 2] = ["lateral", "lateral_certified"];

/// Numbers of the strings, which no other test has.
const SEED: u64 = 76_000;

/// The columns of a run, `lateral` and `lateral_certified`, of the rows by a method; none where its method may
/// chatter.
fn labels(head: &str, method: &str, string: &str) -> Option<Vec<[String; 2]>> {
    let place = Workplace::with_small(&format!("{head}\n{string}"));
    let answer = place.sweep(&["run", "small.toml", "--quiet", "--jobs", "1"]);
    if answer.code != 0 {
        let words = ["chatter", "grows", "sticking"];
        assert!(
            words.iter().any(|word| answer.errors.contains(word)),
            "{answer:?}"
        );
        return None;
    }
    let (names, rows) = table(&place, "results/small/labels.csv");
    let at = |name: &str| names.iter().position(|known| known == name);
    let of_method = rows.into_iter().filter(|row| row[1] == method);
    let column = |row: &[String], name| at(name).map_or_else(String::new, |it| row[it].clone());
    Some(
        of_method
            .map(|row| LABEL.map(|name| column(&row, name)))
            .collect(),
    )
}

/// Of three random cases of a random string, half of the strings hit at the bit: each label, whether it is
/// certain, and what it is in truth.
fn tested(number: u64) -> Vec<(String, bool, String)> {
    let mut numbers = Numbers(SEED + number);
    let (string, mass) = random_collar(&mut numbers);
    let hit = match number % 2 {
        0 => String::new(),
        _ => format!("[[impulses]]\ndistance_from_bit_m = 0\namount_ns = {mass}\n"),
    };
    let string = format!(
        "time_s = 8\n{string}{hit}[design]\nkind = \"monte-carlo\"\ncases = 3\nseed = {number}\n\
         [design.axes]\nweight_on_bit_kn = {{ from = 5, to = 20 }}\n\
         surface_speed_rpm = {{ from = 60, to = 180 }}\n"
    );
    let certified =
        "methods = [\"held\", \"finite-element\"]\nsampling_frequency_hz = 2560\ncertify = true";
    let found = labels(certified, "held", &string);
    let truth = labels(
        "methods = [\"quadrature\"]\nsampling_frequency_hz = 5120",
        "quadrature",
        &string,
    );
    let Some((found, truth)) = found.zip(truth) else {
        return Vec::new();
    };
    let both = found.into_iter().zip(truth);
    both.map(|([label, is_certain], [truth, _])| (label, is_certain == "true", truth))
        .collect()
}

/// Let go as at rest all settings say that it snakes, less from swing to swing: longer simulated it may lie still.
#[test]
fn a_swing_that_fades_is_not_certain() {
    let methods = "methods = [\"finite-element\"]";
    let text = with(
        &pipe("turning"),
        methods,
        "methods = [\"held\", \"finite-element\"]\ncertify = true",
    );
    let found = labels("", "held", &text).unwrap();
    assert_eq!(found.len(), 6);
    for label in found {
        assert_eq!(label, ["snaking", "false"]);
    }
}

/// `STRINGS=100` for what the guide says; here is one.
#[test]
fn certain_labels_of_strings_that_lie_are_those_of_a_third_method() {
    let strings = std::env::var("STRINGS").map_or(1, |text| text.parse::<u64>().unwrap());
    let all: Vec<_> = (0..strings)
        .into_par_iter()
        .flat_map(|number| {
            let found = tested(number);
            println!("{number}: {found:?}");
            found
        })
        .collect();
    let counted = |certain: bool| {
        let of = all.iter().filter(|it| it.1 == certain);
        let wrong = of.clone().filter(|(label, _, truth)| label != truth);
        (wrong.count(), of.count())
    };
    for (certain, name) in [(true, "certain"), (false, "not certain")] {
        let (wrong, of) = counted(certain);
        println!("{name}: {wrong} of {of} wrong, {:?}", wilson(wrong, of));
    }
    let (wrong, certain) = counted(true);
    assert!(certain > 0 && 20 * wrong <= certain);
}
