//! `manifest.json`: what was run, by its meaning; and what stands in the way of
//! running something else.

use std::collections::BTreeSet;

use crate::command_line::{
    RESULTS, columns, manifest, names, names_in, run, succeeds, table, text,
};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace, with};

#[test]
fn the_manifest_says_what_was_run() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    let manifest = manifest(&place, "results");
    assert_eq!(manifest["name"], "small");
    assert_eq!(manifest["cases"], 6);
    assert_eq!(manifest["failed"], 0);
    assert_eq!(manifest["sampling_frequency_hz"], 100.0);
    assert_eq!(manifest["program_version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(manifest["methods"][0]["method"], "quadrature");
    assert!(manifest["methods"][0]["taps"].as_u64().unwrap() > 100);
    assert!(manifest["methods"][0]["positive_real_margin"].is_number());
    let labels = table(&text(&place, "results/labels.csv"));
    for (label, count) in manifest["labels"]["quadrature"].as_object().unwrap() {
        let found = columns(&labels, ["torsion"])
            .iter()
            .filter(|[torsion]| torsion == label)
            .count();
        assert_eq!(found as u64, count.as_u64().unwrap(), "{label}");
    }
}

/// The hash of a sweep's meaning.
fn hash(text: &str) -> String {
    let place = Workplace::with_small(text);
    run(&place, "small.toml", "results");
    manifest(&place, "results")["meaning_sha256"]
        .as_str()
        .unwrap()
        .to_owned()
}

#[test]
fn a_sweep_spelt_otherwise_has_the_same_hash() {
    let original = hash(SMALL);
    assert_eq!(original.len(), 64);
    let (damping, density) = (
        "torsional_damping_nms_rad_m = 10\n",
        "density_kg_m3 = 7840\n",
    );
    let swapped = with(
        &with(SMALL, damping, ""),
        density,
        &format!("{damping}{density}"),
    );
    for spelling in [
        with(SMALL, "[bit]", "# The bit.\n[bit] # here"),
        swapped,
        with(SMALL, "rad_m = 10", "rad_m = 10.0"),
        with(SMALL, "rad_m = 10", "rad_m = 1e1"),
        with(SMALL, "[30, 70]", "[3.0e1, +7_0]"),
        with(SMALL, "\"A small sweep\"", "'Another title'"),
        with(SMALL, "name = \"pipe\"\n", ""),
        with(
            SMALL,
            "[bit]\nrock = \"sandstone\"",
            "bit.rock = \"sandstone\"",
        )
        .replace("bit.rock = \"sandstone\"\n", "")
        .replacen("title", "bit.rock = \"sandstone\"\ntitle", 1),
        SMALL.replace('\n', "\r\n"),
    ] {
        assert_eq!(hash(&spelling), original, "{spelling}");
    }
}

#[test]
fn a_sweep_of_another_meaning_has_another_hash() {
    let mut hashes = BTreeSet::from([hash(SMALL)]);
    for (piece, instead) in [
        ("rad_m = 10", "rad_m = 10.000000000000002"),
        ("repeat = 10", "repeat = 11"),
        ("\"sandstone\"", "\"shale\""),
        ("[30, 70]", "[70, 30]"),
        ("count = 3", "count = 4"),
        ("time_s = 12", "time_s = \"auto\""),
        ("from_bit_m = 50", "from_bit_m = 51"),
        ("\"quadrature\"", "\"finite-element\""),
        ("[bit]", "[bit]\ntorque_static_ratio = 1.3"),
    ] {
        assert!(
            hashes.insert(hash(&with(SMALL, piece, instead))),
            "{instead}"
        );
    }
}

/// Seventeen digits, as programs write them, which some readers round.
#[test]
fn a_sweep_of_numbers_with_all_their_digits_is_known_again() {
    let values = "[9.043936266016381, 9.386864817836715, 42.211277889141556, 99.25434867419433]";
    let place = Workplace::with_small(&with(SMALL, "[30, 70]", values));
    let run = ["run", "small.toml", "--out", "results"];
    succeeds(&place, &run);
    let before = place.files();
    let again = succeeds(&place, &run);
    assert!(again.output.starts_with("complete already"), "{again:?}");
    succeeds(&place, &["plot", "results"]);
    assert!(place.files() == before);
}

#[test]
fn another_sweep_is_refused_in_the_same_folder_and_fresh_replaces_it() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    place.write("other.toml", with(SMALL, "[30, 70]", "[30, 60]"));
    let words = [
        "results holds the results of another sweep",
        "design.axes.weight_on_bit_kn.values[1]: 70.0 → 60.0",
        "--fresh",
    ];
    refused(&place, &["run", "other.toml", "--out", "results"], &words);
    succeeds(
        &place,
        &["run", "other.toml", "--out", "results", "--fresh"],
    );
    assert_eq!(manifest(&place, "results")["name"], "other");
    assert!(text(&place, "results/labels.csv").contains(",60,"));
    assert_eq!(names_in(&place, "results"), names(RESULTS));
    run(&place, "other.toml", "results");
}
