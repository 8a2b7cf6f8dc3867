//! `sweep run`: the files of a results folder, threads, methods.

use std::collections::BTreeSet;

use crate::command_line::{
    RESULTS, by_two_methods, columns, is_png, labels, manifest, names, names_in, run, succeeds,
    table, text,
};
use crate::support::{SMALL, Workplace, small_with_design, with};

#[test]
fn run_writes_the_promised_files_and_no_other() {
    let place = Workplace::with_small(SMALL);
    let answer = run(&place, "small.toml", "deep/results");
    assert_eq!(names_in(&place, "deep/results"), names(RESULTS));
    assert!(
        answer.output.contains("6 cases by 1 method in "),
        "{answer:?}"
    );
    assert!(answer.output.contains("deep/results"), "{answer:?}");
    is_png(&place, "deep/results/map.png");
    assert!(text(&place, "deep/results/map.svg").starts_with("<svg"));
}

#[test]
fn results_go_to_a_folder_named_after_the_sweep() {
    let place = Workplace::with_small(SMALL);
    succeeds(&place, &["run", "small.toml"]);
    assert_eq!(names_in(&place, "results/small"), names(RESULTS));
}

#[test]
fn a_sweep_without_two_axes_has_no_map() {
    let place = Workplace::with_small(&with(
        &small_with_design(""),
        "[bit]",
        "[bit]\nweight_on_bit_kn = 50",
    ));
    run(&place, "small.toml", "results");
    let without_map: BTreeSet<String> = (RESULTS.iter())
        .filter(|name| !name.starts_with("map"))
        .map(|name| (*name).to_owned())
        .collect();
    assert_eq!(names_in(&place, "results"), without_map);
    assert_eq!(table(&text(&place, "results/labels.csv")).len(), 2);
}

#[test]
fn labels_have_a_row_for_each_case_and_method_in_order() {
    let place = Workplace::with_small(&by_two_methods("finite-element"));
    run(&place, "small.toml", "results");
    let labels = text(&place, "results/labels.csv");
    assert_eq!(
        labels.lines().next().unwrap(),
        "case,method,surface_speed_rpm,weight_on_bit_kn,torque_dynamic_nm,torsion,lateral,\
         first_slip_s,period_s,slip_time_s,sticks,bit_speed_peak_rpm,bit_speed_closing_rpm,\
         stick_slip_severity,stick_slip_margin_rpm,site_from_bit_m,first_contact_s,peak_radius_mm,mean_radius_mm,contact_fraction,\
         rolling_fraction,precession_turns_per_s,normal_force_mean_kn,ambiguous_steps,\
         predicted,simulated_s,ended,status"
    );
    let found = columns(
        &table(&labels),
        ["case", "method", "surface_speed_rpm", "weight_on_bit_kn"],
    );
    let mut expected = Vec::new();
    for (case, (speed, weight)) in ["0.02", "0.31", "0.6"]
        .iter()
        .flat_map(|speed| ["30", "70"].map(|weight| (speed, weight)))
        .enumerate()
    {
        for method in ["quadrature", "finite-element"] {
            expected.push([&case.to_string(), method, speed, weight].map(str::to_owned));
        }
    }
    assert_eq!(found, expected);
}

#[test]
fn labels_are_of_the_promised_kinds() {
    let place = Workplace::with_small(SMALL);
    run(&place, "small.toml", "results");
    for [torsion, lateral, ended, status] in
        labels(&place, "results", ["torsion", "lateral", "ended", "status"])
    {
        assert!(["stuck", "smooth", "stick_slip"].contains(&torsion.as_str()));
        assert_eq!(lateral, "");
        assert!(["end", "certain", "settled"].contains(&ended.as_str()));
        assert_eq!(status, "ok");
    }
    assert_eq!(
        text(&place, "results/failures.csv"),
        "case,method,reason,repeat_with\n"
    );
    let boundary = table(&text(&place, "results/boundary.csv"));
    let quantities = columns(
        &boundary,
        ["weight_on_bit_kn", "torque_dynamic_nm", "surface_speed_rpm"],
    );
    assert_eq!(quantities.first().unwrap()[0].parse(), Ok(30.0));
    assert_eq!(quantities.last().unwrap()[0].parse(), Ok(70.0));
    // Above the limit, by as much as `boundary.csv` says.
    let number = |text: &str| text.parse::<f64>().unwrap();
    for [weight, speed, margin] in labels(
        &place,
        "results",
        [
            "weight_on_bit_kn",
            "surface_speed_rpm",
            "stick_slip_margin_rpm",
        ],
    ) {
        let limit = quantities
            .iter()
            .find(|point| number(&point[0]) == number(&weight));
        let expected = number(&speed) - number(&limit.unwrap()[2]);
        let margin = number(&margin);
        assert!((margin - expected).abs() < 1e-12, "{margin} {expected}");
    }
}

#[test]
fn numbers_read_back_exactly() {
    let awkward = [
        0.1 + 0.2,
        1.0 / 3.0,
        f64::from_bits(0.02f64.to_bits() + 1),
        123.456_789_012_345_68,
    ];
    let values = format!("{{ values = {awkward:?} }}");
    let place = Workplace::with_small(&with(
        SMALL,
        "{ from = 0.02, to = 0.6, count = 3 }",
        &values,
    ));
    run(&place, "small.toml", "results");
    let speeds = labels(&place, "results", ["surface_speed_rpm"]);
    for (case, [speed]) in speeds.iter().enumerate() {
        assert_eq!(speed.parse(), Ok(awkward[case / 2]));
    }
    let mut numbers = 0;
    for field in table(&text(&place, "results/labels.csv")).concat() {
        if let Ok(number) = field.parse::<f64>() {
            assert_eq!(number.to_string(), field);
            numbers += 1;
        }
    }
    assert!(numbers > 60, "{numbers}");
}

#[test]
fn the_same_sweep_gives_the_same_bytes_on_any_number_of_threads() {
    let place = Workplace::with_small(&with(SMALL, "count = 3", "count = 9"));
    run(&place, "small.toml", "one");
    for (out, jobs) in [("again", None), ("alone", Some("1")), ("two", Some("2"))] {
        let mut arguments = vec!["run", "small.toml", "--out", out];
        arguments.extend(jobs.iter().flat_map(|jobs| ["--jobs", jobs]));
        succeeds(&place, &arguments);
        for file in RESULTS.iter().filter(|name| **name != "manifest.json") {
            let same = std::fs::read(place.path(&format!("one/{file}"))).unwrap()
                == std::fs::read(place.path(&format!("{out}/{file}"))).unwrap();
            assert!(same, "{out}/{file}");
        }
    }
    assert_eq!(manifest(&place, "alone")["threads"], 1);
    assert_eq!(manifest(&place, "two")["threads"], 2);
}

#[test]
fn the_cluster_says_how_many_threads_unless_a_flag_does() {
    let place = Workplace::with_small(SMALL);
    for (out, per_task, on_node, flag, expected) in [
        ("node", None, Some("3"), None, 3),
        ("task", Some("2"), Some("3"), None, 2),
        ("flag", Some("2"), Some("3"), Some("1"), 1),
    ] {
        let mut command = place.command(&["run", "small.toml", "--quiet", "--out", out]);
        command.args(flag.iter().flat_map(|jobs| ["--jobs", jobs]));
        command.envs(per_task.map(|threads| ("SLURM_CPUS_PER_TASK", threads)));
        command.envs(on_node.map(|threads| ("SLURM_CPUS_ON_NODE", threads)));
        assert!(command.status().unwrap().success());
        assert_eq!(manifest(&place, out)["threads"], expected);
    }
}

#[test]
fn methods_on_the_command_line_replace_those_of_the_file() {
    let place = Workplace::with_small(SMALL);
    let methods = "finite-element,quadrature,finite-element";
    succeeds(
        &place,
        &[
            "run",
            "small.toml",
            "--out",
            "results",
            "--methods",
            methods,
        ],
    );
    let labels = table(&text(&place, "results/labels.csv"));
    let found: Vec<[String; 1]> = columns(&labels, ["method"]);
    assert_eq!(found[..2], [["finite-element"], ["quadrature"]]);
    assert_eq!(found.len(), 12);
}

#[test]
fn a_dry_run_writes_nothing_and_says_how_much_there_is_to_do() {
    let place = Workplace::with_small(SMALL);
    let before = place.files();
    let answer = succeeds(&place, &["run", "small.toml", "--dry-run"]);
    assert!(
        answer
            .output
            .contains("would run 6 cases by 1 (quadrature)"),
        "{answer:?}"
    );
    assert!(answer.output.contains("results/small"), "{answer:?}");
    assert!(place.files() == before);
}

/// A string that is rubbed all along needs 128 steps a travel time: of 100 m, 4 kHz, and this file
/// has a hundred times as many.
#[test]
fn a_long_dry_run_says_what_would_make_it_cheaper() {
    let long = SMALL
        .replace(
            "sampling_frequency_hz = 100",
            "sampling_frequency_hz = 400000",
        )
        .replace("count = 3", "count = 90000")
        .replace(
            "[[sites]]\ndistance_from_bit_m = 50\n",
            "[string_friction]\nstatic_coefficient = 0.2\n[well]\nsurvey = \"survey.csv\"\n",
        );
    let place = Workplace::with_small(&long);
    std::fs::write(
        place.path("survey.csv"),
        "MD (m),Inc (deg),Azi (deg)\n0,0,0\n200,30,0\n",
    )
    .unwrap();
    let answer = succeeds(&place, &["run", "small.toml", "--dry-run"]);
    for line in [
        "what would make it cheaper:",
        "without `sampling_frequency_hz` it is 4",
        "times fewer steps",
    ] {
        assert!(answer.output.contains(line), "no {line:?} in {answer:?}");
    }
    let short = succeeds(
        &Workplace::with_small(SMALL),
        &["run", "small.toml", "--dry-run"],
    );
    assert!(!short.output.contains("cheaper"), "{short:?}");
}

#[test]
fn quiet_prints_nothing() {
    let place = Workplace::with_small(SMALL);
    let answer = succeeds(&place, &["run", "small.toml", "--quiet"]);
    assert_eq!(answer.output, "");
}
