//! `sweep study contacts` on a short string.

use super::{columns, is_png, names, names_in, succeeds, table, text};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace};

/// 40 m of collar that hang in a hole.
const SHORT: &str = r#"title = "A short string"
surface_speed_rpm = 60
time_s = 5
sampling_frequency_hz = 200
methods = ["finite-element"]

[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }
sections = [{ repeat = 4, parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }] }]

[wall]
clearance_mm = 15
stiffness_gn_m15 = 1

[[sites]]
distance_from_bit_m = 0

[[impulses]]
distance_from_bit_m = 0
ratio = 3

[design]
kind = "grid"
axes = { friction = { values = [0.5] } }
"#;

fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("short.toml", SHORT);
    place
}

const STUDY: [&str; 10] = [
    "contacts",
    "short.toml",
    "--counts",
    "1,3",
    "--impulse-at",
    "0,20",
    "--impulses",
    "4",
    "--impulses-along",
    "400",
];

fn number(field: &str) -> f64 {
    field.parse().unwrap_or_else(|_| panic!("{field:?}"))
}

#[test]
fn limits_of_more_contacts_are_bracketed_above_their_bounds_by_any_number_of_threads() {
    let place = workplace();
    let run = |out: &str, jobs: &str| {
        let rest = ["--quiet", "--out", out, "--jobs", jobs];
        succeeds(&place, &[&STUDY[..], &rest].concat())
    };
    assert_eq!(run("one", "1").output, "");
    run("two", "2");
    let files = ["contacts.csv", "contacts_limit.png", "contacts_limit.svg"];
    assert_eq!(names_in(&place, "one"), names(files));
    for file in files {
        let [one, two] =
            ["one", "two"].map(|out| std::fs::read(place.path(&format!("{out}/{file}"))));
        assert_eq!(one.unwrap(), two.unwrap(), "{file}");
    }
    is_png(&place, "one/contacts_limit.png");
    let table = table(&text(&place, "one/contacts.csv"));
    let impulses = columns(
        &table,
        ["contacts", "spacing_m", "blow", "knocked_at_m", "note"],
    );
    let expected = [["1", "40"], ["3", "13.333333333333334"]].map(|count| {
        [["knock", "0"], ["knock", "20"], ["along", ""]]
            .map(|it| [count[0], count[1], it[0], it[1], ""].map(str::to_owned))
    });
    assert_eq!(impulses, expected.concat());
    // The impulses are the same for any number of contacts.
    let amounts = columns(&table, ["impulse_n_s"]);
    assert_eq!(amounts[..3], amounts[3..]);
    assert_eq!(amounts[2], ["16000".to_owned()]);
    let bounds = ["bound_carried", "bound_any_sites", "bound_one_site"];
    let limits = columns(
        &table,
        ["friction_does_not", "friction_whirls", "share_touching"],
    );
    for ([does_not, whirls, share], bounds) in limits.iter().zip(columns(&table, bounds)) {
        let ratio = number(whirls) / number(does_not);
        assert!((1.0..1.011).contains(&ratio), "{ratio}");
        assert!((0.0..=1.0).contains(&number(share)));
        // One contact has none of any together.
        let known = bounds.iter().filter(|bound| !bound.is_empty());
        let known: Vec<f64> = known.map(|bound| number(bound)).collect();
        assert!(known.is_sorted(), "{known:?}");
        // But for what steady whirl is not: the last of them is of one contact alone.
        let certain = known[known.len() - 2];
        assert!(certain < number(whirls), "{certain} {whirls}");
    }
}

/// What the study says of the string with one contact, `run` says of the file.
#[test]
fn a_run_has_the_labels_that_the_study_brackets() {
    let place = workplace();
    let study = [
        "--counts",
        "1",
        "--impulse-at",
        "0",
        "--impulses",
        "4",
        "--impulses-along",
        "400",
    ];
    let rest = ["--quiet", "--out", "study"];
    succeeds(
        &place,
        &[&["study", "contacts", "short.toml"][..], &study, &rest].concat(),
    );
    let table = table(&text(&place, "study/contacts.csv"));
    let [row, _] = &columns(
        &table,
        ["impulse_n_s", "friction_does_not", "friction_whirls"],
    )[..] else {
        panic!("{table:?}");
    };
    let [amount, does_not, whirls] = row;
    let driven = SHORT.replace("ratio = 3", &format!("amount_ns = {amount}"));
    place.write(
        "driven.toml",
        driven.replace("[0.5]", &format!("[{does_not}, {whirls}]")),
    );
    // With a warning of its fronts, which are in torsion.
    let run = place.sweep(&["run", "driven.toml", "--out", "run"]);
    assert_eq!(run.code, 0, "{run:?}");
    let labels = super::labels(&place, "run", ["lateral"]);
    assert_eq!(labels.concat(), ["transient_contact", "backward_whirl"]);
}

/// The study of which docs/contacts.md tells.
const OF_THE_GUIDE: &str = include_str!(concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../results/reference/contacts.csv"
));

#[test]
fn limits_of_the_guide_are_above_the_bound_and_have_converged() {
    let table = table(OF_THE_GUIDE);
    let limits = columns(
        &table,
        [
            "friction_does_not",
            "friction_whirls",
            "bound_any_sites",
            "bound_carried",
        ],
    );
    assert_eq!(limits.len(), 84);
    for [does_not, whirls, any_sites, carried] in &limits {
        assert!(number(does_not) < number(whirls));
        // The search for it leaves 1 %.
        let least = if any_sites.is_empty() {
            carried
        } else {
            any_sites
        };
        assert!(number(carried) < 1.01 * number(least), "{carried} {least}");
        assert!(number(least) < number(whirls), "{least} {whirls}");
    }
    let along = columns(
        &table,
        [
            "blow",
            "string",
            "impulse_n_s_m",
            "contacts",
            "friction_whirls",
        ],
    );
    let of = |contacts: &str| -> Vec<f64> {
        let rows = along
            .iter()
            .filter(|row| row[0] == "along" && row[3] == contacts);
        rows.map(|row| number(&row[4])).collect()
    };
    let (some, more) = (of("32"), of("64"));
    assert_eq!(some.len(), 4);
    for (some, more) in some.iter().zip(&more) {
        assert!((more / some - 1.0).abs() < 0.13, "{some} {more}");
    }
}

#[test]
fn what_cannot_be_asked_of_a_string_is_refused() {
    let place = workplace();
    place.write("small.toml", SMALL);
    for (arguments, words) in [
        (
            &["short.toml", "--counts", "0"][..],
            &["0 contacts", "at least one"][..],
        ),
        (
            &["short.toml", "--counts", "1001"],
            &["1001 contacts", "1000 at most"],
        ),
        (
            &["short.toml", "--counts", "900", "--to-m", "5"],
            &["900 contacts within 5 m"],
        ),
        (
            &["short.toml", "--to-m", "41"],
            &["short.toml", "to 41 m", "from 0 to 40 m"],
        ),
        (
            &["short.toml", "--from-m", "30", "--to-m", "20"],
            &["from 30 m to 20 m"],
        ),
        (&["short.toml", "--from-m", "nan"], &["from NaN m"]),
        (
            &["short.toml", "--impulse-at", "40"],
            &["an impulse 40 m from the bit"],
        ),
        (
            &["short.toml", "--set", "friction=1"],
            &["--set friction", "looks for it"],
        ),
        (
            &["short.toml", "--set", "clearance_mm=0"],
            &["--set clearance_mm"],
        ),
        (
            &["short.toml", "--sampling-hz", "99"],
            &["99 Hz", "two samples"],
        ),
        (&["short.toml", "--time-s", "2"], &["2 s", "the last 2 s"]),
        (&["short.toml", "--memory", "1M"], &["--counts", "memory"]),
        (&["small.toml"], &["small.toml", "`wall`", "is needed"]),
    ] {
        refused(
            &place,
            &[&["study", "contacts"][..], arguments].concat(),
            words,
        );
    }
}
