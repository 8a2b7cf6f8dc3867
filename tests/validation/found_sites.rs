//! Sites that are found: the same labels as with every candidate, what is reported of them, and
//! cases that they do not keep within their walls.

use std::collections::BTreeMap;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::support::{Workplace, with};

/// The string of the paper, shortened, with two sites, after an impulse that makes it whirl.
const WHIRLING: &str = r#"
time_s = 3
surface_speed_rpm = 60
sampling_frequency_hz = 640
methods = ["finite-element"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }
[[string.sections]]
repeat = 20
parts = [
    { length_m = 9.5, inner_radius_m = 0.05, outer_radius_m = 0.125 },
    { length_m = 0.5, inner_radius_m = 0.05, outer_radius_m = 0.15 },
]
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }]
[wall]
clearance_mm = 15
stiffness_gn_m15 = 67.8
friction = 2
sites = "auto"
sites_every_m = 2
sites_to_m = 100
[[sites]]
distance_from_bit_m = 0
[[sites]]
distance_from_bit_m = 50
[[impulses]]
distance_from_bit_m = 50
[design.axes]
impulse_ratio = { values = [0.5, 3] }
[design]
kind = "grid"
"#;

/// Rows of a table, by column.
fn rows(place: &Workplace, table: &str) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(place.path(table)).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

#[track_caller]
fn run(place: &Workplace, text: &str, code: i32) -> Vec<BTreeMap<String, String>> {
    place.write("found.toml", text);
    let answer = place.sweep(&["run", "found.toml", "--out", "out", "--fresh"]);
    assert_eq!(answer.code, code, "{answer:?}");
    rows(place, "out/labels.csv")
}

/// The sites that were found, m from the bit.
fn sites(row: &BTreeMap<String, String>) -> Vec<f64> {
    let sites = row["found_sites_from_bit_m"].split(';');
    let sites = sites.filter(|site| !site.is_empty());
    sites.map(|site| site.parse().unwrap()).collect()
}

#[test]
fn val_sites_are_found_where_the_string_goes_through_the_wall_and_nowhere_else() {
    let place = Workplace::new();
    let found = run(&place, WHIRLING, 0);
    // Half of what brings its site to the wall brings none there.
    assert_eq!(
        (sites(&found[0]).len(), &*found[0]["found_rounds"]),
        (0, "0")
    );
    let whirls = &found[1];
    assert_eq!(whirls["lateral"], "backward_whirl");
    assert!(sites(whirls).len() > 3, "{whirls:?}");
    assert!(whirls["found_rounds"].parse::<usize>().unwrap() > 1);
    // With these by hand there is nothing left to find.
    let by_hand: String = (sites(whirls).iter())
        .map(|site| format!("[[sites]]\ndistance_from_bit_m = {site}\n"))
        .collect();
    let more = format!("{by_hand}[[impulses]]");
    let again = &run(&place, &with(WHIRLING, "[[impulses]]", &more), 0)[1];
    assert_eq!((sites(again).len(), &*again["found_rounds"]), (0, "0"));
    for (column, value) in whirls.iter().filter(|it| !it.0.starts_with("found")) {
        assert_eq!(value, &again[column], "{column}");
    }
    // Taps between the same sites whirl too.
    let auto = WHIRLING.find("sites = \"auto\"").unwrap();
    let wall = &WHIRLING[auto..WHIRLING.find("[[sites]]").unwrap()];
    let by_taps = &run(&place, &with(WHIRLING, wall, &by_hand), 0)[1];
    assert_eq!(by_taps["lateral"], "backward_whirl");
    assert!(!by_taps.contains_key("found_rounds"));
}

/// `simulate` shows the case of the run, and a string that stays within its wall.
#[test]
fn val_what_is_simulated_is_the_case_with_its_sites() {
    let place = Workplace::new();
    let found = run(&place, WHIRLING, 0);
    let simulate = ["simulate", "found.toml", "--case", "1", "--out", "case"];
    let answer = place.sweep(&simulate);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert_eq!(rows(&place, "case/case.csv"), found[1..]);
    let (count, rounds) = (sites(&found[1]).len(), &found[1]["found_rounds"]);
    let words = answer
        .output
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(
        words.starts_with(&format!("{count} sites found in {rounds} rounds, ")),
        "{words}"
    );
    // Both cases at once have not the same sites.
    let both = [
        "simulate",
        "found.toml",
        "--case",
        "0",
        "--case",
        "1",
        "--out",
        "both",
    ];
    let answer = place.sweep(&both);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(
        answer.errors.contains("one --case by one of --methods"),
        "{answer:?}"
    );
}

/// The run, its manifest and its report say how many sites were found, and in how many rounds; so
/// do shards that are merged, which read it from their tables.
#[test]
fn what_was_found_is_reported_for_the_whole_sweep() {
    let place = Workplace::new();
    place.write("found.toml", WHIRLING);
    let manifest = |folder: &str| -> serde_json::Value {
        let text = std::fs::read_to_string(place.path(&format!("{folder}/manifest.json")));
        serde_json::from_str(&text.unwrap()).unwrap()
    };
    let done = |arguments: &[&str]| {
        let answer = place.sweep(arguments);
        assert_eq!(answer.code, 0, "{answer:?}");
        let words: Vec<&str> = answer.output.split_whitespace().collect();
        words.join(" ")
    };
    let reported = done(&["run", "found.toml", "--out", "out"]);
    let whirls = &rows(&place, "out/labels.csv")[1];
    let (sites, rounds) = (sites(whirls).len(), &whirls["found_rounds"]);
    let expected = format!(
        "finite-element: sites were found in 1 of 2 cases, up to {sites} sites in up to {rounds} \
         rounds"
    );
    assert!(reported.contains(&expected), "{reported}");
    done(&["report", "out"]);
    let report = std::fs::read_to_string(place.path("out/report.html")).unwrap();
    assert!(report.contains(&expected));
    let found = &manifest("out")["found_sites"]["finite-element"];
    assert_eq!(found["most_sites"], sites);
    assert_eq!(found["most_rounds"], rounds.parse::<usize>().unwrap());
    for shard in ["0/2", "1/2"] {
        let folder = format!("part{}", &shard[..1]);
        done(&["run", "found.toml", "--out", &folder, "--shard", shard]);
    }
    assert!(done(&["merge", "part0", "part1", "--out", "merged"]).contains(&expected));
    assert_eq!(&manifest("merged")["found_sites"]["finite-element"], found);
}

/// A run that was complete is read again, a failed case with what was found of it too.
#[test]
fn a_case_that_does_not_end_is_kept_aside() {
    let place = Workplace::new();
    let once = "sites = \"auto\"\nsites_rounds = 1";
    let text = with(WHIRLING, "sites = \"auto\"", once);
    let design = &WHIRLING[WHIRLING.find("[design.axes]").unwrap()..];
    let random = "[design]\nkind = \"monte-carlo\"\nseed = 3\ncases = 2\n[design.axes]\n\
                  impulse_ratio = { from = 2.9, to = 3 }\n";
    let text = with(&text, design, random);
    let found = run(&place, &text, 3);
    assert_eq!(found[1]["status"], "failed");
    assert!(!sites(&found[1]).is_empty());
    let reason = &rows(&place, "out/failures.csv")[0]["reason"];
    for reported in [
        "found in 1 round",
        "mm beyond the wall",
        "`sites_rounds` allows no more",
    ] {
        assert!(reason.contains(reported), "{reason}");
    }
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    place.write("found.toml", with(&text, "cases = 2", "cases = 3"));
    let answer = place.sweep(&["run", "found.toml", "--out", "out"]);
    assert_eq!(answer.code, 3, "{answer:?}");
    let more = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    assert!(more.starts_with(&labels) && more.len() > labels.len());
}

#[test]
fn the_same_is_found_on_however_many_threads() {
    let place = Workplace::new();
    let [one, two] = ["1", "2"].map(|threads| {
        place.write("found.toml", WHIRLING);
        let run = [
            "run",
            "found.toml",
            "--out",
            "out",
            "--fresh",
            "--jobs",
            threads,
        ];
        assert_eq!(place.sweep(&run).code, 0);
        std::fs::read(place.path("out/labels.csv")).unwrap()
    });
    assert_eq!(one, two);
}

/// Strings of pipe, of pipe with joints and of either above collars, light and heavy damping, in a
/// wall that gives way, or is rigid where the scheme allows it.
fn scenes() -> impl Strategy<Value = String> {
    let pipe = (any::<bool>(), 5..60_usize, 0.055..0.075_f64);
    let collars = (0..12_usize, 0.09..0.12_f64);
    let damping = (2.3..3.6_f64).prop_map(|power| 10_f64.powf(power));
    let wall = (5.0..40.0_f64, prop::option::of(-1.0..2.0_f64), 1..=3_usize);
    let scene = (40.0..180.0_f64, 10.0..50.0_f64, any::<u32>());
    (pipe, collars, damping, wall, scene).prop_map(|(pipe, collars, damping, wall, scene)| {
        let ((has_joints, repeat, radius), (count, collar)) = (pipe, collars);
        let ((clearance, stiffness, every), (speed, place, seed)) = (wall, scene);
        let part = |length: f64, outer: f64| {
            format!("{{ length_m = {length}, inner_radius_m = 0.04, outer_radius_m = {outer} }}")
        };
        let mut parts = vec![part(9.0, radius)];
        parts.extend(has_joints.then(|| part(0.5, radius + 0.02)));
        let section = |repeat: usize, parts: &[String]| match repeat {
            0 => String::new(),
            _ => format!(
                "[[string.sections]]\nrepeat = {repeat}\nparts = [{}]\n",
                parts.join(",")
            ),
        };
        let place = (place / every as f64).round() * every as f64;
        // On a rigid wall Newmark's scheme needs more numerical damping.
        let (stiffness, gamma) = match stiffness {
            Some(power) => (format!("stiffness_gn_m15 = {}", 10_f64.powf(power)), 0.52),
            None => (String::new(), 0.7),
        };
        format!(
            "surface_speed_rpm = {speed}\ntime_s = 4\nsampling_frequency_hz = 1280\n\
             methods = [\"finite-element\"]\nmethod.finite-element.gamma = {gamma}\n\
             [string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 10\n\
             bending = {{ youngs_modulus_gpa = 210, damping_ns_m2 = {damping} }}\n{}{}\
             [wall]\nclearance_mm = {clearance}\n{stiffness}\nsites = \"auto\"\n\
             sites_every_m = {every}\nsites_to_m = 100\n\
             [[sites]]\ndistance_from_bit_m = 0\n[[sites]]\ndistance_from_bit_m = {place}\n\
             [[impulses]]\ndistance_from_bit_m = {place}\n\
             [design]\nkind = \"monte-carlo\"\ncases = 5\nseed = {seed}\n[design.axes]\n\
             impulse_ratio = {{ from = 1, to = 6 }}\nfriction = {{ from = 0.1, to = 2 }}\n",
            section(repeat, &parts),
            section(count, &[part(9.3, collar)])
        )
    })
}

/// `STRINGS=20` for a hundred cases.
#[test]
fn val_labels_are_those_of_every_candidate() {
    let strings = std::env::var("STRINGS").map_or(2, |count| count.parse().unwrap());
    let mut runner = TestRunner::deterministic();
    let (mut cases, mut others, mut failed, mut whirls, mut most) = (0, 0, 0, 0, 0);
    for _ in 0..strings {
        let text = scenes().new_tree(&mut runner).unwrap().current();
        let place = Workplace::new();
        let of = |text: &str| {
            place.write("found.toml", text);
            let answer = place.sweep(&["run", "found.toml", "--out", "out", "--fresh"]);
            assert!([0, 3].contains(&answer.code), "{answer:?}\n{text}");
            rows(&place, "out/labels.csv")
        };
        let [found, all] = [of(&text), of(&with(&text, "\"auto\"", "\"all\""))];
        for (found, all) in found.iter().zip(&all) {
            cases += 1;
            most = most.max(sites(found).len());
            whirls += usize::from(all["lateral"].ends_with("whirl"));
            if [found, all].iter().any(|row| row["status"] != "ok") {
                failed += 1;
            } else if found["lateral"] != all["lateral"] {
                others += 1;
                println!("{} {} {text}", found["lateral"], all["lateral"]);
            }
        }
    }
    println!(
        "{cases} cases, {whirls} whirl, {others} others, {failed} without an answer, {most} sites"
    );
    assert!(
        whirls > 0 && most > 5,
        "a scene without contact shows nothing"
    );
    // Between two regimes what touches by less than the tolerance may decide, and rounding.
    assert!(10 * others <= cases && 10 * failed <= cases);
}
