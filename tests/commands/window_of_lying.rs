//! `sweep window` of a string on the low side of its hole: no bound says where whirl, once triggered, cannot
//! last, so that no cell is plain safe; swing resonances and snaking are limits.

use std::f64::consts::PI;
use std::sync::Mutex;

use campaign::engine::{RunOptions, Shard};
use campaign::memory::Limit;
use campaign::quantities::Axis;
use campaign::{Campaign, Run};
use rayon::prelude::*;
use results::analysis::wilson;
use sim::{Label, LateralRegime, Motion};

use crate::support::{Workplace, with};
use crate::window::{Cell, Numbers, cells, done, held, refused, table};

const OUTER: f64 = 0.1;
const INNER: f64 = 0.04;
const HOLE: f64 = 0.15;
const FRICTION: f64 = 0.3;

/// From site to site, m.
const SPACING: f64 = 7.4;

/// Pipe at 60° on nine sites from the bit up, which starts from a motion.
pub fn pipe(start: &str) -> String {
    let site = |number: usize| {
        let distance = number as f64 * SPACING;
        format!("[[sites]]\ndistance_from_bit_m = {distance}\n")
    };
    format!(
        "methods = [\"finite-element\"]\ntime_s = 3\nsampling_frequency_hz = 640\nstart = \"{start}\"\n\
         [string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\ntorsional_damping_nms_rad_m = 1\n\
         bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = 200, surface = \"free\" }}\n\
         sections = [{{ repeat = 1, parts = [{{ length_m = 60, inner_radius_m = {INNER}, \
         outer_radius_m = {OUTER} }}] }}]\n[bit]\nrock = \"sandstone\"\n\
         [well]\nhole_radius_m = {HOLE}\ninclination_deg = 60\n\
         [wall]\nclearance = \"hole\"\nstiffness_gn_m15 = 1\nfriction = {FRICTION}\n{}\
         [design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = {{ values = [5, 20] }}\n\
         surface_speed_rpm = {{ values = [50, 80, 120] }}\n",
        (0..9).map(site).collect::<String>()
    )
}

fn windowed(text: &str) -> (Workplace, String, Vec<Cell>) {
    let place = Workplace::with_small(text);
    done(&place, &["run", "small.toml", "--quiet"]);
    let said = done(&place, &["window", "small.toml"]);
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    let found = cells(&place, "results/small/window.csv");
    (place, said, found)
}

/// Where nothing moves that is not triggered, cells are safe unless whirl is triggered, but around
/// √(√(1 + μ²) g′/c)/2π turns a second, where rotation meets the swing of the whole pipe.
#[test]
fn a_string_that_lies_is_safe_at_most_unless_whirl_is_triggered_and_off_its_swings() {
    let (place, said, found) = windowed(&pipe("smooth"));
    let no_bound = "no bound is known for a string on the low side of its hole";
    let how_often = "on 200 random strings that lie, hit at the bit";
    let json = done(&place, &["window", "small.toml", "--json"]);
    for words in [no_bound, how_often] {
        assert!(said.contains(words), "{said}");
        assert!(json.contains(words), "{json}");
    }
    let svg = std::fs::read_to_string(place.path("results/small/window.svg")).unwrap();
    assert!(svg.contains("no bound is known"), "not in the picture");
    let inspected = done(&place, &["inspect", "small.toml"]);
    assert!(inspected.contains("whirl, if triggered: no bound excludes it"));
    assert!(inspected.contains("how often words of safety were wrong\n  on 200 random strings"));
    let (safe, near): (Vec<&Cell>, Vec<&Cell>) =
        (found.iter()).partition(|cell| cell.standing == "safe_unless_begun");
    assert!(
        safe.len() > found.len() / 4,
        "{} of {}",
        safe.len(),
        found.len()
    );
    // Each of nine sites gives way under its part of the weight.
    let load = 7850.0 * 9.80665 * PI * (OUTER * OUTER - INNER * INNER) * 60f64.to_radians().sin();
    let clearance = HOLE - OUTER + (load * SPACING / 1e9).powf(2.0 / 3.0);
    let pressed = 9.80665 * 60f64.to_radians().sin() * (1.0 + FRICTION * FRICTION).sqrt();
    let swing = 60.0 * (pressed / clearance).sqrt() / (2.0 * PI);
    let lowest = near
        .iter()
        .map(|cell| cell.ends[1][0])
        .fold(f64::INFINITY, f64::min);
    assert!(
        (lowest / (0.9 * swing) - 1.0).abs() < 0.01,
        "{lowest} {swing}"
    );
    for cell in &near {
        assert!(cell.standing == "near" && cell.limits.contains("swing resonance 1×"));
    }
    refused(
        &place,
        &["window", "small.toml", "--held-at", "0"],
        "--held-at: the string lies on the low side of its hole",
    );
}

/// Let go as at rest it still swings after three seconds, about the angle to which it climbs. A trace follows
/// whirl alone, and simulates few of its points.
#[test]
fn where_a_string_snakes_it_is_not_safe() {
    let grid = pipe("turning");
    let trace = with(
        &grid,
        "kind = \"grid\"",
        "kind = \"trace\"\ntolerance = 0.1",
    );
    let trace = with(&trace, "values = [5, 20]", "from = 5, to = 20");
    let trace = with(&trace, "values = [50, 80, 120]", "from = 50, to = 120");
    for text in [grid, trace] {
        let (_, said, found) = windowed(&text);
        assert!(said.contains("nothing on the map is safe"), "{said}");
        for cell in &found {
            assert_eq!(cell.standing, "against", "{said}");
            // In quotes, for its commas.
            let limits = cell.limits.trim_start_matches('"');
            let is_first = limits.starts_with("snaking or sustained whirl (simulated)");
            assert!(is_first, "{}", cell.limits);
        }
    }
}

/// Nor is a bound known below a motor, or where cases find their sites.
#[test]
fn what_has_no_bound_of_whirl_is_safe_at_most_unless_that_is_triggered() {
    let motor = "[motor]\nspeed_rpm = 120\nstall_torque_kn_m = 10\n[design]\n";
    let changes = [
        ("[design]\n", motor),
        ("[wall]\n", "[wall]\nsites = \"auto\"\n"),
    ];
    for (from, to) in changes {
        let (_, said, found) = windowed(&with(&held(), from, to));
        assert!(
            said.contains("from which speed on whirl lasts, once triggered"),
            "{said}"
        );
        assert!(found.iter().all(|cell| cell.standing != "safe"), "{said}");
        assert!(
            found
                .iter()
                .any(|cell| cell.standing == "safe_unless_begun"),
            "{said}"
        );
    }
}

/// A collar on three to seven sites, the bit among them, in a hole of some size and inclination: its text up to
/// the impulses and the axes, and what 10 m of it weigh, kg.
pub fn random_collar(numbers: &mut Numbers) -> (String, f64) {
    let hole = [0.108, 0.1556, 0.2223][(3.0 * numbers.next()) as usize];
    let outer = hole * numbers.between(0.5, 0.8);
    let inner = 0.3 * outer;
    let top = numbers.between(25.0, 70.0);
    let mut at = 0.0;
    let mut sites = String::new();
    while at < top {
        // Bit and blades, or a collar.
        let clearance = match at == 0.0 || numbers.next() < 0.6 {
            true => numbers.between(0.8, 8.0),
            false => numbers.between(8.0, 1e3 * (hole - outer)),
        };
        sites += &format!("[[sites]]\ndistance_from_bit_m = {at}\nclearance_mm = {clearance}\n");
        at += numbers.between(5.0, 15.0) * (outer / 0.09).sqrt();
    }
    let text = format!(
        "start = \"smooth\"\n[string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\ntorsional_damping_nms_rad_m = 1\n\
         bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = {} }}\n\
         sections = [{{ repeat = 1, parts = [{{ length_m = {at}, inner_radius_m = {inner}, \
         outer_radius_m = {outer} }}] }}]\n[bit]\nrock = \"sandstone\"\n[mud]\ndensity_kg_m3 = 1200\n\
         [well]\nhole_radius_m = {hole}\ninclination_deg = {}\n\
         [wall]\nclearance = \"hole\"\nstiffness_gn_m15 = {}\nfriction = {}\n{sites}",
        numbers.between(100.0, 400.0),
        numbers.between(20.0, 90.0),
        10f64.powf(numbers.between(-0.5, 0.5)),
        numbers.between(0.1, 0.6)
    );
    (text, 10.0 * 7850.0 * PI * (outer * outer - inner * inner))
}

/// Weight, speed and whether it whirls of each case of a sweep; none where its method may chatter.
fn whirls(text: &str) -> Option<Vec<([f64; 2], bool)>> {
    let campaign = Campaign::open("hit.toml".as_ref(), &[], &|_, _| Ok(text.to_owned())).unwrap();
    let survey = campaign.survey().unwrap();
    let systems = campaign
        .build(&survey, RunOptions::default(), &Limit::of(None))
        .ok()?;
    let run = Run {
        shard: Shard::WHOLE,
        options: RunOptions::default(),
        is_done: &|_, _| false,
        earlier: &|_| Ok(()),
        expect: &|_| {},
        stops: &|| false,
    };
    let found = Mutex::new(Vec::new());
    let keep = |record: campaign::records::Record| {
        let outcome = record
            .outcome
            .map_err(|failure| anyhow::anyhow!("{}", failure.text()))?;
        let label = outcome.labels()[Motion::Lateral];
        let whirls = label == Some(Label::Lateral(LateralRegime::BackwardWhirl));
        let at = [Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm].map(|axis| {
            let place = campaign
                .sweep
                .design
                .axes()
                .iter()
                .position(|known| *known == axis);
            record.values[place.unwrap()]
        });
        found.lock().unwrap().push((at, whirls));
        Ok(())
    };
    campaign.run(&systems, &run, &keep).unwrap();
    Some(found.into_inner().unwrap())
}

/// A random collar that does not move, run over weight and speed.
fn run_at_rest(string: &str) -> Workplace {
    let place = Workplace::with_small(&format!(
        "methods = [\"finite-element\"]\nsampling_frequency_hz = 640\ntime_s = 1\n{string}\
         [design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = {{ values = [5, 20] }}\n\
         surface_speed_rpm = {{ values = [60, 180] }}\n"
    ));
    done(&place, &["run", "small.toml", "--quiet", "--jobs", "1"]);
    place
}

/// Cases of it after a hit that gives 10 m of it (`mass`, kg) a speed of 1 m/s, sideways at the bit.
fn hit(string: &str, mass: f64, design: &str) -> Vec<([f64; 2], bool)> {
    let by = |method: &str, frequency: f64| {
        whirls(&format!(
            "methods = [\"{method}\"]\nsampling_frequency_hz = {frequency}\ntime_s = 5\n{string}\
             [[impulses]]\ndistance_from_bit_m = 0\namount_ns = {mass}\n{design}"
        ))
    };
    // Elements damp fast whirl at longer steps.
    let found = by("held", 800.0).or_else(|| by("finite-element", 2560.0));
    found.unwrap()
}

/// The speeds from which rolling reaches the top of the hole are no bound of whirl.
#[test]
fn whirl_lasts_at_half_the_speed_at_which_rolling_reaches_the_top_of_the_hole() {
    let strings = std::env::var("STRINGS").map_or(3, |text| text.parse::<u64>().unwrap());
    let of_string = |seed: u64| {
        let (string, mass) = random_collar(&mut Numbers(74_000 + seed));
        let place = run_at_rest(&string);
        let (_, boundary) = table(&place, "results/small/boundary.csv");
        let line = boundary.iter().find(|row| row[0] == "goes_round").unwrap();
        let speed = 0.5 * line[4].parse::<f64>().unwrap();
        let axes = format!(
            "[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = {{ values = [5] }}\n\
             surface_speed_rpm = {{ values = [{speed}] }}\n"
        );
        hit(&string, mass, &axes)[0].1
    };
    let whirled: Vec<bool> = (0..strings).into_par_iter().map(of_string).collect();
    let whirled = whirled.into_iter().filter(|whirls| *whirls).count();
    println!("{whirled} of {strings} whirl below the line when hit");
    assert!(whirled > 0);
}

/// Of random cases of a random string that is hit, those that its window would call safe but for swings,
/// snaking and triggered whirl, and those that it calls safe unless whirl is triggered; with how many of them whirl.
fn hit_cases(seed: u64) -> [[usize; 2]; 2] {
    let mut numbers = Numbers(73_000 + seed);
    let (string, mass) = random_collar(&mut numbers);
    let place = run_at_rest(&string);
    done(&place, &["window", "small.toml", "--jobs", "1"]);
    let cells = cells(&place, "results/small/window.csv");
    assert!(cells.iter().all(|cell| cell.standing != "safe"), "{string}");
    let design = format!(
        "[design]\nkind = \"monte-carlo\"\ncases = 3\nseed = {seed}\n[design.axes]\n\
         weight_on_bit_kn = {{ from = 5, to = 20 }}\nsurface_speed_rpm = {{ from = 60, to = 180 }}\n"
    );
    let mut counts = [[0; 2]; 2];
    for (at, whirls) in hit(&string, mass, &design) {
        let cell = cells.iter().find(|cell| cell.has(at)).unwrap();
        let of_lying = ["swing", "snaking", "backward whirl"];
        let is_of_lying = |limit: &str| {
            let limit = limit.trim_start_matches('"');
            of_lying.iter().any(|name| limit.starts_with(name))
        };
        let calls = [
            cell.limits.split("; ").all(is_of_lying),
            cell.standing == "safe_unless_begun",
        ];
        for (count, is_safe) in counts.iter_mut().zip(calls) {
            count[0] += usize::from(is_safe);
            count[1] += usize::from(is_safe && whirls);
        }
    }
    counts
}

/// How often what a window calls safe unless whirl is triggered whirls after a hit: on a number of random
/// strings, `STRINGS`, three random cases each. The hit gives 10 m of the collar a speed of 1 m/s, sideways at
/// the bit: 3 kN s of a collar of 300 kg/m.
#[test]
fn what_is_safe_unless_whirl_is_triggered_often_whirls_when_hit() {
    let strings = std::env::var("STRINGS").map_or(3, |text| text.parse::<u64>().unwrap());
    let counts: Vec<[[usize; 2]; 2]> = (0..strings).into_par_iter().map(hit_cases).collect();
    let total = |call: usize, count: usize| counts.iter().map(|it| it[call][count]).sum::<usize>();
    let names = [
        "safe but for what is of strings that lie",
        "safe unless whirl is triggered",
    ];
    for (call, name) in names.iter().enumerate() {
        let [all, whirled] = [total(call, 0), total(call, 1)];
        println!(
            "{name}: {whirled} of {all} whirl when hit, {:?}",
            wilson(whirled, all)
        );
    }
    let [all, whirled] = [total(0, 0), total(0, 1)];
    assert!(all as u64 > strings && 5 * whirled > all, "{counts:?}");
}
