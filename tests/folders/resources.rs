//! Memory and time are known before they are spent: what would take too much is
//! refused with the key that is to blame, and what is promised holds.

mod peaks;

use crate::refusals::{RUN, line_of, refused};
use crate::support::{SMALL, Workplace, small_with_design, with};

/// SMALL with a wall and sites every `spacing` metres, `count` of them.
fn lateral(count: usize, spacing: f64) -> String {
    let setting = &SMALL[..SMALL.find("[bit]").unwrap()];
    let setting = with(
        setting,
        "[[string.sections]]",
        "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n[[string.sections]]",
    );
    let sites: String = (0..count)
        .map(|site| {
            format!(
                "[[sites]]\ndistance_from_bit_m = {}\n",
                site as f64 * spacing
            )
        })
        .collect();
    format!(
        "{setting}\n[wall]\nclearance_mm = 15\nfriction = 1.5\n\n{sites}\n\
         [[impulses]]\ndistance_from_bit_m = 0\namount_ns = 900\n"
    )
}

/// A sweep is refused at the line that holds `at`, naming `key`, the amount and the
/// limit, before anything is written.
#[track_caller]
fn too_large(text: &str, at: &str, key: &str) {
    let place = format!("small.toml:{}: `{key}`: ", line_of(text, at));
    for command in ["run", "simulate", "inspect"] {
        let arguments = [command, "small.toml", "--out", "results", "--memory", "8G"];
        let words = [
            &place,
            "would take",
            "GiB of memory, more than 8.0 GiB",
            "--memory",
        ];
        refused(&Workplace::with_small(text), &arguments, &words);
    }
}

#[test]
fn a_time_that_fills_the_memory_is_refused() {
    let text = with(SMALL, "time_s = 12", "time_s = 1000000");
    too_large(&text, "time_s", "time_s");
    let text = with(
        &text,
        "sampling_frequency_hz = 100",
        "sampling_frequency_hz = 600000",
    );
    too_large(&text, "time_s", "time_s");
}

#[test]
fn a_sampling_frequency_that_fills_the_memory_is_refused() {
    let text = with(
        SMALL,
        "sampling_frequency_hz = 100",
        "sampling_frequency_hz = 1000000",
    );
    let text = with(&text, "time_s = 12", "time_s = 900");
    too_large(&text, "sampling_frequency_hz", "sampling_frequency_hz");
}

/// The time of a case follows from its speed; the message says which case it is.
#[test]
fn a_speed_that_makes_cases_last_for_ever_is_refused() {
    let axes = "[design]\nkind = \"grid\"\n[design.axes]\n\
                surface_speed_rpm = { values = [10, 0.0001] }\n\
                weight_on_bit_kn = { values = [10, 300] }\n";
    let text = with(&small_with_design(axes), "time_s = 12\n", "");
    let text = with(
        &text,
        "sampling_frequency_hz = 100",
        "sampling_frequency_hz = 10000",
    );
    let place = Workplace::with_small(&text);
    let words = [
        "`design.axes.surface_speed_rpm`: case 3 (surface_speed_rpm = 0.0001, \
         weight_on_bit_kn = 300) lasts ",
        "more than 8.0 GiB",
    ];
    refused(&place, &[&RUN[..], &["--memory", "8G"]].concat(), &words);
}

#[test]
fn more_sites_than_memory_holds_are_refused() {
    let text = lateral(2000, 0.04);
    // The list begins there.
    let line = 1 + text[..text.find("[[sites]]").unwrap()]
        .matches('\n')
        .count();
    let place = format!("small.toml:{line}: `sites`: would take");
    refused(&Workplace::with_small(&text), &RUN, &[&place]);
}

/// Cells are joined, and none is held: only the shape of a whole string has all elements.
#[test]
fn shapes_of_elements_that_fill_the_memory_are_refused() {
    let text = lateral(1, 0.04)
        .replace("[\"quadrature\"]", "[\"finite-element\"]")
        .replace("repeat = 10\n", "repeat = 30\n")
        + "[method.finite-element]\nelements_per_cell = 10000\n";
    let place = Workplace::with_small(&text);
    let limited = |command: &[&str]| place.sweep(&[command, &["--memory", "400M"]].concat());
    let ran = limited(&RUN);
    assert_eq!(ran.code, 0, "{ran:?}");
    let simulated = limited(&[
        "simulate",
        "small.toml",
        "--case",
        "0",
        "--out",
        "histories",
    ]);
    let place = "`method.finite-element.elements_per_cell`: would take";
    assert_eq!(simulated.code, 2, "{simulated:?}");
    assert!(simulated.errors.contains(place), "{simulated:?}");
}

/// Modes need no responses, and are said without them.
#[test]
fn modes_take_no_memory_of_responses() {
    let text = with(SMALL, "time_s = 12", "time_s = 1000000");
    let place = Workplace::with_small(&text);
    let inspect = ["inspect", "small.toml", "--modes=3", "--memory", "1G"];
    let answer = place.sweep(&inspect);
    assert_eq!(answer.code, 0, "{answer:?}");
    let warning = "warning: responses are left out: small.toml:4: `time_s`: would take";
    assert!(answer.errors.starts_with(warning), "{answer:?}");
    place.write("small.toml", SMALL);
    let with_responses = place.sweep(&inspect);
    let modes = |output: &str| {
        let modes = output.split("\nmethods\n").next().unwrap();
        modes.to_owned()
    };
    assert_eq!(modes(&answer.output), modes(&with_responses.output));
}

#[test]
fn responses_longer_than_any_method_gives_are_refused() {
    let text = with(SMALL, "rad_m = 10", "rad_m = 0");
    let text = with(&text, "time_s = 12", "time_s = 200000");
    let words = [
        "small.toml:4: `time_s`: asks for responses of ",
        "steps, more than any method gives",
    ];
    let arguments = [&RUN[..], &["--memory", "900G"]].concat();
    refused(&Workplace::with_small(&text), &arguments, &words);
}

/// The curves of a look last for some round trips of a wave, however short the cases are.
#[test]
fn curves_that_fill_the_memory_are_refused() {
    let text = with(SMALL, "repeat = 10", "repeat = 1900");
    let text = with(&text, "time_s = 12", "time_s = 0.1");
    let frequency = "sampling_frequency_hz = 100000";
    let text = with(&text, "sampling_frequency_hz = 100", frequency);
    let words = ["small.toml:5: `sampling_frequency_hz`: would take"];
    let arguments = ["inspect", "small.toml", "--memory", "400M"];
    refused(&Workplace::with_small(&text), &arguments, &words);
}

#[test]
fn an_impulse_is_short() {
    let text = lateral(1, 0.0) + "duration_s = 100\n";
    let answer = Workplace::with_small(&text).sweep(&RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
    for duration in ["100.1", "1e7", "1e308"] {
        let text = lateral(1, 0.0) + &format!("duration_s = {duration}\n");
        let words = [
            "`impulses[0].duration_s`: ",
            "an impulse lasts 100 s at most",
        ];
        refused(&Workplace::with_small(&text), &RUN, &words);
    }
}

/// Reference labels are rerun in the setting of the sweep.
#[test]
fn a_check_that_fills_the_memory_is_refused() {
    let place = Workplace::with_small(SMALL);
    assert_eq!(place.sweep(&RUN).code, 0);
    place.write("small.toml", with(SMALL, "time_s = 12", "time_s = 1000000"));
    let arguments = [
        "check",
        "small.toml",
        "results/labels.csv",
        "--memory",
        "8G",
    ];
    refused(&place, &arguments, &["small.toml:4: `time_s`: would take"]);
}

#[test]
fn the_limit_is_what_the_command_line_or_slurm_says() {
    let place = Workplace::with_small(&with(SMALL, "time_s = 12", "time_s = 100000"));
    let arguments = [&RUN[..], &["--dry-run", "--memory"]].concat();
    let with_limit = |limit| [&arguments[..], &[limit]].concat();
    refused(
        &place,
        &with_limit("100M"),
        &["more than 100 MiB, given by --memory"],
    );
    let answer = place.sweep(&with_limit("20GiB"));
    assert_eq!(answer.code, 0, "{answer:?}");
    let slurm = |mebibytes: &str, arguments: &[&str]| {
        let mut command = place.command(arguments);
        let output = command.env("SLURM_MEM_PER_NODE", mebibytes).output();
        String::from_utf8(output.unwrap().stderr).unwrap()
    };
    let dry = [&RUN[..], &["--dry-run"]].concat();
    let refusal = slurm("100", &dry);
    assert!(refusal.contains("100 MiB, allotted by Slurm"), "{refusal}");
    assert_eq!(slurm("100", &with_limit("20G")), "");
    for amount in ["8 parsecs", "0", "-1G"] {
        let answer = place.sweep(&["run", "small.toml", &format!("--memory={amount}")]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(
            answer.errors.contains("not an amount of memory"),
            "{answer:?}"
        );
    }
}

/// Where memory allows fewer strings at once, they are built one by one, and the
/// labels are the same.
#[test]
fn strings_are_built_one_by_one_where_memory_is_short() {
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 6\n[design.axes]\n\
                  bending_damping_ns_m2 = { from = 1000, to = 3000 }\n";
    let text = with(&lateral(4, 20.0), "time_s = 12", "time_s = 50") + design;
    let place = Workplace::with_small(&text);
    let least = peaks::estimate(&place, "run");
    let limit = format!("{}", least + 1024.0 * 1024.0);
    let mut tables = Vec::new();
    for (folder, limit) in [("one", limit.as_str()), ("many", "100G")] {
        let arguments = ["run", "small.toml", "--out", folder, "--memory", limit];
        let peak = peaks::peak(&place, &arguments);
        assert!(
            folder == "many" || peak.is_none_or(|peak| peak <= least),
            "{peak:?}"
        );
        tables.push(std::fs::read(place.path(&format!("{folder}/labels.csv"))).unwrap());
    }
    assert!(tables[0] == tables[1]);
}

/// A string that may touch at many sites is stepped by finite elements; one whose places are
/// two hundred would take gigabytes otherwise.
#[test]
fn a_string_that_is_stepped_takes_no_more_than_estimated() {
    let text = with(&lateral(200, 0.4), "time_s = 12", "time_s = 60");
    let text = with(&text, "\"quadrature\"", "\"finite-element\"");
    let place = Workplace::with_small(&text);
    let reported = peaks::estimate(&place, "run");
    assert!(reported < 1e9, "{reported}");
    let limit = format!("{}", reported + 1024.0 * 1024.0);
    let peak = peaks::peak(&place, &[&RUN[..], &["--memory", &limit]].concat());
    assert!(
        peak.is_none_or(|peak| peak <= reported),
        "{peak:?} {reported}"
    );
}

/// Of a string in many pieces that is held against a recording every node's motion is kept; where
/// its loss has a memory its responses last as long as a case.
#[test]
fn a_string_in_many_pieces_takes_no_more_than_estimated() {
    let setting = &SMALL[..SMALL.find("[bit]").unwrap()];
    let setting = with(setting, "repeat = 10", "repeat = 100");
    let compare = "[[compare]]\ntrace = \"bit_speed_rpm\"\nfile = \"recorded.csv\"\n\
                   column = \"speed_rpm\"\nfrom_s = 1\nto_s = 9\n";
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 4\n[design.axes]\n\
                  string_friction = { from = 0.1, to = 0.4 }\n";
    let friction = "[well]\nsurvey = \"survey.csv\"\n[string_friction]\npieces = 500\n";
    let text = format!("{setting}{friction}{compare}{design}");
    let text = with(
        &text,
        "surface_speed_rpm = 60",
        "surface_speed_rpm = 60\nsurface_speed_rise_s = 3",
    );
    let text = with(&text, "time_s = 12", "time_s = 60");
    let lossy = with(&text, "[string]", "[string]\nloss_factor = 0.001");
    for text in [text, lossy] {
        let place = Workplace::with_small(&text);
        place.write("recorded.csv", "time_s,speed_rpm\n0,0\n10,60\n");
        let survey = "measured_depth_m,inclination_deg,azimuth_deg\n0,10,0\n1000,40,0\n";
        place.write("survey.csv", survey);
        let reported = peaks::estimate(&place, "run");
        let limit = format!("{}", reported + 1024.0 * 1024.0);
        let peak = peaks::peak(&place, &[&RUN[..], &["--memory", &limit]].concat());
        assert!(
            peak.is_none_or(|peak| peak <= reported),
            "{peak:?} {reported}"
        );
    }
}

#[test]
fn a_dry_run_and_inspect_tell_memory_and_time() {
    let place = Workplace::with_small(SMALL);
    for arguments in [
        &["run", "small.toml", "--dry-run", "--jobs", "2"][..],
        &["inspect", "small.toml", "--jobs", "2"],
    ] {
        let answer = place.sweep(arguments);
        assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
        for words in [
            "memory: at most ",
            "; limit: ",
            "wall time: ",
            " on 2 threads",
        ] {
            assert!(answer.output.contains(words), "no {words:?} in {answer:?}");
        }
    }
}

/// A wall time is given for a sweep of days, and for one that takes no memory.
#[test]
fn a_sweep_of_days_gets_its_time_and_is_not_refused() {
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 900000\n[design.axes]\n\
                  friction = { from = 0.5, to = 3 }\n";
    let text = with(&lateral(2, 30.0), "friction = 1.5\n", "") + design;
    let text = with(&text, "time_s = 12", "time_s = 4000");
    let place = Workplace::with_small(&text);
    let options = ["--dry-run", "--full", "--memory", "8G", "--jobs", "1"];
    let answer = place.sweep(&[&RUN[..], &options].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    let mut lines = answer.output.lines();
    let line = lines.find(|line| line.starts_with("wall time")).unwrap();
    let is_long = [" days on 1 thread", " h on 1 thread", "too short"];
    assert!(
        is_long.iter().any(|words| line.contains(words)),
        "{answer:?}"
    );
}

/// Finer sampling takes more memory: the search for an accuracy stops there and says
/// so.
#[test]
fn an_accuracy_that_takes_too_much_memory_says_so() {
    let text = with(SMALL, "sampling_frequency_hz = 100\n", "");
    let text = with(&text, "methods = [\"quadrature\"]", "accuracy = \"0.1 %\"");
    let place = Workplace::with_small(&text);
    let words = [
        "small.toml:5: `accuracy`: 0.1 % cannot be estimated",
        " Hz the reference is too large for the memory: ",
        "more than 2 MiB, given by --memory",
    ];
    refused(&place, &[&RUN[..], &["--memory", "2M"]].concat(), &words);
}
