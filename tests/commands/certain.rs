//! `certify`: which labels are certain, in the same bytes however a run comes about.

use std::time::Duration;

use crate::support::{Answer, SMALL, Workplace, small_with_design, with};

/// Columns that a run has only where it certifies.
const CERTIFICATE: [&str; 11] = [
    "finer_torsion",
    "finer_lateral",
    "finer_stick_slip_margin_rpm",
    "finer_contact_fraction",
    "finer_precession_turns_per_s",
    "torsion_certified",
    "lateral_certified",
    "nearby_torsion_agrees",
    "finer_normal_force_mean_kn",
    "whirl_rate_and_force_agree",
    "finer_swing_deg",
];

const THREE: &str = "methods = [\"held\", \"hilbert\", \"finite-element\"]\n";

/// Random cases of a bit, by three methods, at a sampling frequency, Hz.
fn of_a_bit(cases: usize, frequency: f64, more: &str) -> String {
    let design = format!(
        "[design]\nkind = \"monte-carlo\"\ncases = {cases}\nseed = 5\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.02, to = 0.6 }}\n\
         weight_on_bit_kn = {{ from = 20, to = 80 }}\n"
    );
    let text = with(
        &small_with_design(&design),
        "sampling_frequency_hz = 100",
        &format!("sampling_frequency_hz = {frequency}"),
    );
    with(
        &text,
        "methods = [\"quadrature\"]\n",
        &format!("{THREE}{more}"),
    )
}

/// Random cases of a bit and a wall.
fn at_a_wall(cases: usize, frequency: f64, more: &str) -> String {
    let text = of_a_bit(cases, frequency, more);
    let text = with(
        &text,
        "torsional_damping_nms_rad_m = 10\n",
        "torsional_damping_nms_rad_m = 10\n\
         bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }\n",
    );
    let text = with(
        &text,
        "distance_from_bit_m = 50\n",
        "distance_from_bit_m = 0\n[[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n\
         [wall]\nclearance_mm = 15\n",
    );
    text + "friction = { from = 0.5, to = 3 }\n"
}

#[track_caller]
fn run(place: &Workplace, text: &str, folder: &str, more: &[&str]) -> Answer {
    place.write("small.toml", text);
    let answer = place.sweep(&[&["run", "small.toml", "--out", folder][..], more].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    answer
}

fn read(place: &Workplace, name: &str) -> String {
    std::fs::read_to_string(place.path(name)).unwrap()
}

/// A table without some columns at its end.
fn without_last(table: &str, columns: usize) -> String {
    let cut = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        fields[..fields.len() - columns].join(",") + "\n"
    };
    table.lines().map(cut).collect()
}

/// A column of a table, by its name.
fn column<'a>(table: &'a str, name: &str) -> Vec<&'a str> {
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let place = header.iter().position(|other| *other == name).unwrap();
    lines.map(|line| line[place]).collect()
}

/// The rows are those of a run that does not certify; what is added is what a run of its own
/// says at twice the frequency, and of `held` in torsion alone at that of exact fronts.
#[test]
fn certificates_are_what_a_run_in_shorter_steps_says() {
    const CASES: usize = 12;
    for scene in [of_a_bit, at_a_wall] {
        let place = Workplace::new();
        let reported = run(
            &place,
            &scene(CASES, 100.0, "certify = true\n"),
            "certified",
            &[],
        );
        run(&place, &scene(CASES, 100.0, ""), "plain", &[]);
        run(&place, &scene(CASES, 200.0, ""), "finer", &[]);
        let manifest = read(&place, "certified/manifest.json");
        let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
        let exact = manifest["certified_by"]["exact_fronts_hz"].as_f64();
        let exact = exact.unwrap_or(200.0);
        run(&place, &scene(CASES, exact, ""), "exact", &[]);
        let [certified, plain, finer, exact] = ["certified", "plain", "finer", "exact"]
            .map(|folder| read(&place, &format!("{folder}/labels.csv")));
        let header = certified.lines().next().unwrap();
        assert!(header.ends_with(&CERTIFICATE.join(",")), "{header}");
        assert_eq!(without_last(&certified, CERTIFICATE.len()), plain);
        for own in [
            "torsion",
            "lateral",
            "stick_slip_margin_rpm",
            "contact_fraction",
            "precession_turns_per_s",
            "normal_force_mean_kn",
        ] {
            let [reported, finer, exact] = [
                (&certified, format!("finer_{own}")),
                (&finer, own.to_owned()),
                (&exact, own.to_owned()),
            ]
            .map(|(table, name)| column(table, &name));
            for (row, method) in column(&certified, "method").into_iter().enumerate() {
                let expected = match method {
                    // The digital filter has no part in it.
                    "hilbert" => "",
                    "held" => exact[row],
                    _ => finer[row],
                };
                assert_eq!(reported[row], expected);
            }
        }
        // A row is certain where it has the label that is, which both methods have.
        let mut certain = [0, 0];
        for (count, motion) in certain.iter_mut().zip(["torsion", "lateral"]) {
            let labels = column(&certified, motion);
            let flags = column(&certified, &format!("{motion}_certified"));
            for (labels, flags) in labels.chunks(3).zip(flags.chunks(3)) {
                assert_eq!(flags[0], flags[2]);
                let filter_is = flags[0] == "true" && labels[1] == labels[0];
                assert_eq!(flags[1] == "true", filter_is, "{labels:?} {flags:?}");
                *count += usize::from(flags[0] == "true");
            }
        }
        for (count, word) in certain.into_iter().zip(["torsional", "lateral"]) {
            let words = format!("certain, {word}: {count} of {CASES} cases");
            assert_eq!(
                reported.output.contains(&words),
                count > 0,
                "{}",
                reported.output
            );
        }
        // Of the bit's rotation some are and some are not.
        assert!((1..CASES).contains(&certain[0]), "{certain:?}");
    }
}

/// Whirl that all four find says whether no two of their rates and forces differ by more than a
/// quarter and half: at three walls of the paper both happen.
#[test]
fn whirl_says_whether_rate_and_force_agree() {
    let place = Workplace::new();
    let base = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig17.toml");
    let text = format!(
        "base = {base:?}\nmethods = [\"held\", \"finite-element\"]\ncertify = true\n[design]\n\
         kind = \"monte-carlo\"\ncases = 40\nseed = 17\n[design.axes]\nimpulse_ratio = {{ from = 0.9, to = 5 }}\n\
         friction = {{ from = 0.5, to = 3 }}\n"
    );
    let reported = run(&place, &text, "certified", &[]);
    let table = read(&place, "certified/labels.csv");
    let numbers = |name: &str| -> Vec<f64> {
        let fields = column(&table, name).into_iter();
        fields
            .map(|field| field.parse().unwrap_or(f64::NAN))
            .collect()
    };
    let labels = ["lateral", "finer_lateral"].map(|name| column(&table, name));
    let agrees = column(&table, "whirl_rate_and_force_agree");
    let of_kind = [
        ("precession_turns_per_s", 0.25),
        ("normal_force_mean_kn", 0.5),
    ]
    .map(|(name, part)| ([numbers(name), numbers(&format!("finer_{name}"))], part));
    let mut counts = [0, 0];
    for (case, agrees) in agrees.chunks(2).enumerate() {
        let rows = [2 * case, 2 * case + 1];
        let of_case = rows
            .iter()
            .flat_map(|&row| labels.iter().map(move |list| list[row]));
        let all_whirl = of_case.clone().all(|label| label == "backward_whirl");
        let is_alike = |([own, finer], part): &([Vec<f64>; 2], f64)| {
            let four = rows.map(|row| [own[row], finer[row]]);
            let [least, most] = four
                .as_flattened()
                .iter()
                .fold([f64::MAX, 0.0], |ends, one| {
                    [ends[0].min(one.abs()), ends[1].max(one.abs())]
                });
            most - least <= part * most
        };
        let are_alike = of_kind.iter().all(is_alike);
        let expected = if all_whirl {
            are_alike.to_string()
        } else {
            String::new()
        };
        assert_eq!(agrees, [&expected; 2], "case {case}");
        if all_whirl {
            counts[usize::from(are_alike)] += 1;
        }
    }
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    let words = format!("in {} cases all four settings whirl", counts[0]);
    let output = reported
        .output
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(output.contains(&words), "{output}");
}

/// A case is simulated in the sweep at each of the speeds that its certificate looks at: what that
/// says of nearby speeds is what the rows of these say.
#[test]
fn a_label_that_changes_at_nearby_speeds_is_not_certain() {
    const FRACTIONS: [f64; 15] = [
        1.0, 0.9, 0.93, 0.95, 0.97, 0.98, 0.99, 0.995, 1.005, 1.01, 1.02, 1.03, 1.05, 1.07, 1.1,
    ];
    const CENTRES: usize = 12;
    let speeds = (0..CENTRES).flat_map(|centre| {
        let speed = 0.53 * 1.035f64.powi(centre as i32);
        FRACTIONS.map(|fraction| (fraction * speed).to_string())
    });
    let speeds: Vec<String> = speeds.collect();
    let design = format!(
        "[design]\nkind = \"grid\"\n[design.axes]\nsurface_speed_rpm = {{ values = [{}] }}\n\
         weight_on_bit_kn = {{ values = [60] }}\n",
        speeds.join(", ")
    );
    let text = with(
        &small_with_design(&design),
        "sampling_frequency_hz = 100\n",
        "sampling_frequency_hz = 1000\n",
    );
    // As long at each speed, or the rows of nearby speeds would be other cases than those asked.
    let text = with(&text, "time_s = 12\n", "time_s = 20\n");
    let pair = "methods = [\"held\", \"finite-element\"]\ncertify = true\n";
    let text = with(&text, "methods = [\"quadrature\"]\n", pair);
    let place = Workplace::new();
    run(&place, &text, "results", &[]);
    let table = read(&place, "results/labels.csv");
    let of_held = |name: &str| -> Vec<String> {
        let methods = column(&table, "method");
        let rows = column(&table, name).into_iter().zip(methods);
        let own = rows.filter(|(_, method)| *method == "held");
        own.map(|(field, _)| field.to_owned()).collect()
    };
    let [labels, nearby, certain] =
        ["torsion", "nearby_torsion_agrees", "torsion_certified"].map(of_held);
    let (mut changed, mut kept) = (0, 0);
    for centre in (0..labels.len()).step_by(FRACTIONS.len()) {
        let at_speeds = &labels[centre..centre + FRACTIONS.len()];
        let agree = at_speeds.iter().all(|label| *label == at_speeds[0]);
        if nearby[centre].is_empty() {
            continue;
        }
        assert_eq!(nearby[centre], agree.to_string(), "{at_speeds:?}");
        *if agree { &mut kept } else { &mut changed } += 1;
    }
    assert!(changed > 2 && kept > 2, "{changed} {kept}");
    for (nearby, certain) in nearby.iter().zip(&certain) {
        assert!(nearby != "false" || certain == "false");
    }
}

#[test]
fn threads_shards_and_raising_do_not_change_certificates() {
    let place = Workplace::new();
    let all = at_a_wall(12, 100.0, "certify = true\n");
    run(&place, &all, "whole", &["--quiet", "--jobs", "1"]);
    let same = |folder: &str| {
        for file in ["labels.csv", "map.svg"] {
            let [one, other] =
                ["whole", folder].map(|folder| read(&place, &format!("{folder}/{file}")));
            assert!(one == other, "{folder}/{file}");
        }
    };
    run(&place, &all, "threads", &["--quiet", "--jobs", "3"]);
    same("threads");
    let few = at_a_wall(5, 100.0, "certify = true\n");
    run(&place, &few, "raised", &["--quiet"]);
    run(&place, &all, "raised", &["--quiet"]);
    same("raised");
    let shards = ["0/2", "1/2"].map(|shard| {
        let folder = format!("shard-{}", &shard[..1]);
        run(&place, &all, &folder, &["--quiet", "--shard", shard]);
        folder
    });
    let merge = place.sweep(&["merge", &shards[0], &shards[1], "--out", "merged"]);
    assert_eq!(merge.code, 0, "{merge:?}");
    same("merged");
    let count = |folder: &str| {
        let manifest = read(&place, &format!("{folder}/manifest.json"));
        let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
        manifest["certified"].clone()
    };
    assert!(count("whole").is_object());
    assert_eq!(count("whole"), count("merged"));
}

/// Killed with some of its cases done.
#[test]
fn a_run_that_is_killed_continues_with_its_certificates() {
    let place = Workplace::new();
    let text = of_a_bit(80, 100.0, "certify = true\n");
    run(&place, &text, "whole", &["--quiet"]);
    let arguments = [
        "run",
        "small.toml",
        "--quiet",
        "--out",
        "stopped",
        "--jobs",
        "1",
    ];
    let mut child = place.command(&arguments).spawn().unwrap();
    let log = place.path("stopped/cases.log");
    let lines = || std::fs::read_to_string(&log).map_or(0, |log| log.lines().count());
    while lines() < 20 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!((20..240).contains(&lines()), "{}", lines());
    // What is done can be summarised.
    let answer = place.sweep(&["summary", "stopped"]);
    let reported = "Cases whose label is certain";
    assert!(answer.output.contains(reported), "{answer:?}");
    run(&place, &text, "stopped", &["--quiet"]);
    let [whole, stopped] =
        ["whole", "stopped"].map(|folder| read(&place, &format!("{folder}/labels.csv")));
    assert!(whole == stopped);
}

#[test]
fn a_run_that_cannot_certify_is_refused() {
    let place = Workplace::with_small(&of_a_bit(4, 100.0, "certify = true\n"));
    let refused = |more: &[&str], words: &str| {
        let answer = place.sweep(&[&["run", "small.toml"][..], more].concat());
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(words), "{}", answer.errors);
        assert!(!place.path("results").exists());
    };
    refused(
        &["--methods", "held,hilbert"],
        "`certify`: takes two methods that share no equation, `held` and `finite-element`: \
         `methods` lacks `finite-element`",
    );
    refused(
        &["--allow-unstable"],
        "methods that chatter certify nothing",
    );
    // Who only looks at a case needs no second method.
    let arguments = [
        "simulate",
        "small.toml",
        "--case",
        "1",
        "--methods",
        "hilbert",
    ];
    let answer = place.sweep(&arguments);
    assert_eq!(answer.code, 0, "{answer:?}");
    place.write(
        "small.toml",
        with(SMALL, "time_s = 12", "time_s = 12\ncertify = true"),
    );
    let answer = place.sweep(&["inspect", "small.toml"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    let words = "small.toml:5: `certify`: takes two methods";
    assert!(answer.errors.contains(words), "{}", answer.errors);
}
