//! The estimate of memory against the largest memory of real processes, as Linux
//! counts it.

use std::process::Stdio;
use std::time::Duration;

use numerics::random::Stream;

use crate::resources::lateral;
use crate::support::{CUTTING, SMALL, Workplace, small_with_design, with};

const MIB: f64 = 1024.0 * 1024.0;

/// The estimate is at most this multiple of the real peak, beyond what small runs take.
const MOST: f64 = 3.5;
const SMALL_RUN: f64 = 80.0 * MIB;

/// What a command would take, bytes, as its refusal says.
pub fn estimate(place: &Workplace, command: &str) -> f64 {
    let answer = place.sweep(&[command, "small.toml", "--memory", "1M"]);
    let reported = answer.errors.split("would take ").nth(1);
    size(reported.unwrap_or_else(|| panic!("{answer:?}")))
}

/// What a dry run says, bytes.
fn said(output: &str) -> f64 {
    size(output.split("memory: at most ").nth(1).unwrap())
}

/// The amount of memory that a text begins with, bytes.
fn size(text: &str) -> f64 {
    let mut words = text.split([' ', ';', ',', '\n']);
    let amount: f64 = words.next().unwrap().parse().unwrap();
    match words.next().unwrap() {
        "MiB" => amount * MIB,
        "GiB" => amount * 1024.0 * MIB,
        unit => panic!("{unit}"),
    }
}

/// The largest memory of a command while it ran, bytes; `None` where the system does
/// not tell.
pub fn peak(place: &Workplace, arguments: &[&str]) -> Option<f64> {
    let mut command = place.command(arguments);
    let silent = command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut process = silent.spawn().unwrap();
    let path = format!("/proc/{}/status", process.id());
    let mut largest = None;
    while process.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kibibytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
        largest = kibibytes.map(|count| 1024.0 * count).or(largest);
        std::thread::sleep(Duration::from_millis(1));
    }
    assert_eq!(process.wait().unwrap().code(), Some(0));
    largest
}

#[track_caller]
fn holds(command: &str, text: &str) {
    let place = Workplace::with_small(text);
    let estimate = estimate(&place, command);
    // A run that may take more looks at what its labels depend on.
    let limit = format!("{}", estimate + MIB);
    let mut arguments = vec![command, "small.toml", "--out", "out", "--memory", &limit];
    if command == "run" {
        arguments.extend(["--full", "--allow-unstable"]);
    }
    let Some(peak) = peak(&place, &arguments) else {
        return;
    };
    let [reported, took] = [estimate / MIB, peak / MIB];
    assert!(
        estimate >= peak,
        "{command}: {reported:.0} MiB estimated, {took:.0} taken\n{text}"
    );
    let most = SMALL_RUN + MOST * peak;
    assert!(
        estimate <= most,
        "{command}: {reported:.0} MiB estimated, {took:.0} taken\n{text}"
    );
}

fn by(method: &str, text: &str) -> String {
    with(text, "[\"quadrature\"]", &format!("[\"{method}\"]"))
}

#[test]
fn no_run_takes_more_memory_than_its_limit() {
    let long = with(&small_with_design(""), "time_s = 12", "time_s = 30000");
    let long = with(
        &long,
        "\"sandstone\"",
        "\"sandstone\"\nweight_on_bit_kn = 30",
    );
    let fast = with(
        SMALL,
        "sampling_frequency_hz = 100",
        "sampling_frequency_hz = 20000",
    );
    let few = with(&lateral(2, 30.0), "time_s = 12", "time_s = 300");
    let many = with(&lateral(12, 7.0), "time_s = 12", "time_s = 30");
    holds("run", SMALL);
    holds("run", &long);
    for method in ["quadrature", "hilbert", "direct-idft"] {
        holds("run", &by(method, &fast));
        holds("run", &by(method, &few));
        holds("run", &by(method, &many));
    }
    let some = with(&lateral(4, 20.0), "time_s = 12", "time_s = 20");
    holds("run", &by("finite-element", &some));
    let stressed = |text: &str| {
        let text = with(text, "friction = 1.5", "friction = 1.5\nstress_every_m = 2");
        text + "\n[[tools]]\ndistance_from_bit_m = 3\n[[tools]]\ndistance_from_bit_m = 5\n"
    };
    for method in ["held", "quadrature", "finite-element"] {
        holds("run", &by(method, &stressed(&some)));
    }
    holds("run", &stressed(&few));
    // Elements that are stepped.
    let dense = with(&lateral(45, 2.0), "time_s = 12", "time_s = 60");
    holds("run", &by("finite-element", &stressed(&dense)));
    let all = r#"["quadrature", "hilbert", "finite-element"]"#;
    holds("run", &with(&some, r#"["quadrature"]"#, all));
}

/// It moves in torsion and along the axis, and below a hook load as a whole.
#[test]
fn no_bit_that_cuts_takes_more_memory_than_its_limit() {
    let long = with(CUTTING, "time_s = 20", "time_s = 3000");
    let fast = with(
        CUTTING,
        "sampling_frequency_hz = 200",
        "sampling_frequency_hz = 20000",
    );
    let tools = "[[tools]]\ndistance_from_bit_m = 3\n[[tools]]\ndistance_from_bit_m = 5\n";
    for method in ["held", "quadrature", "finite-element"] {
        holds("run", &by(method, &long));
        holds("run", &by(method, &fast));
        let tools = with(&long, "[design]\n", &format!("{tools}\n[design]\n"));
        holds("run", &by(method, &tools));
    }
    holds("simulate", &long);
    holds("inspect", &fast);
    let rubs = format!(
        "{CUTTING}\n[well]\ninclination_deg = 40\n[string_friction]\nstatic_coefficient = 0.2\n\
         dynamic_ratio = 0.8\npieces = 4\n"
    );
    let rubs = with(&rubs, "time_s = 20", "time_s = 200");
    let rubs = with(
        &rubs,
        "sampling_frequency_hz = 200",
        "sampling_frequency_hz = 400",
    );
    for method in ["held", "quadrature", "finite-element"] {
        holds("run", &by(method, &rubs));
    }
    holds("simulate", &rubs);
}

/// What a run says beforehand has room for looking at what labels depend on, which takes the most
/// where the sampling frequency is doubled.
#[test]
fn a_run_that_sees_dependences_takes_no_more_memory_than_it_says() {
    let long = with(&small_with_design(""), "time_s = 12", "time_s = 20000");
    let long = with(
        &long,
        "\"sandstone\"",
        "\"sandstone\"\nweight_on_bit_kn = 30",
    );
    for text in [long, with(&lateral(3, 30.0), "time_s = 12", "time_s = 100")] {
        let place = Workplace::with_small(&text);
        let run = ["run", "small.toml", "--out", "out", "--memory", "100G"];
        let answer = place.sweep(&[&run[..], &["--dry-run"]].concat());
        let said = said(&answer.output);
        let peak = peak(&place, &run);
        let manifest = std::fs::read_to_string(place.path("out/manifest.json")).unwrap();
        assert!(
            manifest.contains("\"sampling_frequency_hz\": 200"),
            "{manifest}"
        );
        assert!(peak.is_none_or(|peak| peak <= said), "{peak:?} {said}");
    }
}

#[test]
fn no_history_or_look_takes_more_memory_than_its_limit() {
    let torsion = with(SMALL, "time_s = 12", "time_s = 3000");
    holds("simulate", &torsion);
    holds("inspect", &torsion);
    let lateral = with(&lateral(3, 30.0), "time_s = 12", "time_s = 100");
    holds("simulate", &lateral);
    holds("inspect", &lateral);
}

#[test]
fn a_fine_mesh_takes_no_more_memory_than_its_limit() {
    let elements = "\n[method.finite-element]\nelements_per_cell = 2000\n";
    let torsion = with(&by("finite-element", SMALL), "time_s = 12", "time_s = 1");
    holds("run", &(torsion + elements));
    let bending = with(
        &by("finite-element", &lateral(1, 0.0)),
        "time_s = 12",
        "time_s = 2",
    );
    holds("run", &(bending + elements));
}

/// A number between two, by its logarithm.
fn drawn(stream: &mut Stream, [least, most]: [f64; 2]) -> f64 {
    least * f64::powf(most / least, stream.part())
}

/// A string of a few sections below a light drive that is held weakly or strongly, in a hole that
/// rubs, in mud, or in neither.
fn random_drive_and_well(number: u64) -> String {
    let mut stream = Stream::new(74, number);
    let mut draw = |ends| drawn(&mut stream, ends);
    let [method, frequency, drive, well] = [(); 4].map(|()| draw([1.0, 3.999]) as usize);
    let method = ["quadrature", "held", "finite-element"][method - 1];
    let frequency = [
        "",
        "sampling_frequency_hz = 60\n",
        "sampling_frequency_hz = 300\n",
    ][frequency - 1];
    let sections: String = (0..2)
        .map(|_| {
            let outer = draw([0.06, 0.12]);
            format!(
                "[[string.sections]]\nrepeat = {:.0}\nparts = [{{ length_m = {:.3}, \
                 inner_radius_m = {:.4}, outer_radius_m = {outer:.4} }}]\n",
                draw([3.0, 10.0]),
                draw([10.0, 30.0]),
                draw([0.4, 0.8]) * outer
            )
        })
        .collect();
    let gains = format!(
        "[top_drive]\ninertia_kg_m2 = {}\ncontroller = \"gains\"\n\
         proportional_gain_knms_rad = {}\nintegral_gain_knm_rad = {}\n",
        draw([20.0, 500.0]),
        draw([0.02, 10.0]),
        draw([0.002, 1.0])
    );
    let limit = "torque_limit_kn_m = 50\nsaturates = true\n";
    let limited = gains.clone() + limit;
    let drive = ["", &gains, &limited][drive - 1];
    let rubs = "[well]\ninclination_deg = 40\n[string_friction]\nstatic_coefficient = 0.2\n\
                dynamic_ratio = 0.8\npieces = 8\n";
    let mud = "[well]\nhole_diameter_mm = 311\n[mud]\ndensity_kg_m3 = 1200\nviscosity_cp = 20\n";
    let well = ["", mud, rubs][well - 1];
    let damping = draw([0.05, 10.0]);
    format!(
        "surface_speed_rpm = 60\nstart = \"ramp\"\ntime_s = 5\nmethods = [\"{method}\"]\n{frequency}\
         [string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7840\n\
         torsional_damping_nms_rad_m = {damping}\n{sections}\
         [bit]\ntorque_dynamic_nm = 1000\n{drive}{well}"
    )
}

/// A light drive below weak gains takes minutes to settle, and its lattice has millions of steps until
/// then, by which fronts are compared; of a long file what was read counts.
#[test]
fn no_random_drive_well_or_file_takes_more_memory_than_is_said() {
    let sites = |site: usize| format!("[[sites]]\ndistance_from_bit_m = {}\n", 0.004 * site as f64);
    let long = (1..12_000).map(sites).collect::<String>() + "[design]\n";
    let long = with(SMALL, "[design]\n", &long);
    let texts = (0..6).map(random_drive_and_well);
    let mut compared = 0;
    for text in texts.chain([long]) {
        let place = Workplace::with_small(&text);
        let run = [
            "run",
            "small.toml",
            "--out",
            "out",
            "--fresh",
            "--allow-unstable",
        ];
        let answer =
            |limit: &str| place.sweep(&[&run[..], &["--dry-run", "--memory", limit]].concat());
        let least = answer("1M").errors;
        let Some(least) = least.split("would take ").nth(1).map(size) else {
            continue;
        };
        // With room for the cases alone, and with some for what is optional.
        for limit in [format!("{}", least + MIB), "200M".to_owned()] {
            let answer = answer(&limit);
            if answer.code == 2 || least > 200.0 * MIB {
                continue;
            }
            let said = said(&answer.output);
            let peak = peak(&place, &[&run[..], &["--memory", &limit]].concat());
            assert!(
                peak.is_none_or(|peak| peak <= said),
                "{peak:?} {said}\n{text}"
            );
            compared += 1;
        }
    }
    assert!(compared > 6, "{compared}");
}
