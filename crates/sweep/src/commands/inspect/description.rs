//! The linear system of a sweep in words and numbers.

use anyhow::Result;
use linear::estimates::{
    largest_undershoot, torsional_decay_rate, torsional_stiffness, torsional_travel_time,
    torsional_wave_left,
};

use campaign::design::Design;
use campaign::engine::{MethodSystem, Survey, is_unstable};
use campaign::plan::{Choice, POUND_PER_FOOT, Sweep};
use campaign::quantities::{FORCE, IMPULSE, INCH, LENGTH, TORQUE, Unit, Units};
use campaign::sweep_file::{AutoOr, per_cent};
use campaign::words::{counted, short, wrapped};
use limits::ForwardContact;

/// A title and a value, which stand below those of other depths.
pub(super) fn row(depth: usize, title: &str, value: &str) -> String {
    let width = 29 - depth;
    format!("{:depth$}{title:<width$}{value}\n", "")
}

/// The string, from the surface to the bit.
pub fn describe_string(sweep: &Sweep) -> String {
    let string = &sweep.setting.string;
    let mut text = wrapped(&format!("{}: {}", sweep.name, sweep.title), 0, 2) + "\nstring\n";
    let units = sweep.content.units;
    let (length, torque) = (units.of(&LENGTH), units.of(&TORQUE));
    let [second, radian] = ["s", "rad"].map(Unit::unchanged);
    text += &row(2, "length", &length.text(string.length(), 3));
    text += &part_lines(sweep);
    text += &sheet_lines(sweep);
    let stiffness = torsional_stiffness(string);
    let speed = string.torsional_wave_speed();
    let travel = torsional_travel_time(string);
    let decay = torsional_decay_rate(string);
    let left = 100.0 * torsional_wave_left(string);
    let frequency = sweep.setting.sampling_frequency;
    let decimals = if frequency < 1e4 { 2 } else { 0 };
    let why = match sweep.choice {
        Some(_) => "by the accuracy asked for",
        None => &match sweep.setting.steps_per_travel {
            Some(steps) => format!("by rule, {steps:.0} steps a travel time"),
            None => "given in the sweep file".to_owned(),
        },
    };
    for (title, value) in [
        (
            "torsional stiffness k_eff",
            torque.per(&radian).text(stiffness, 1),
        ),
        ("torsional wave speed", length.per(&second).text(speed, 1)),
        (
            "travel time to the bit",
            format!("{travel:.4} s, and back {:.4} s", 2.0 * travel),
        ),
        ("torsional decay rate", format!("{decay:.3} 1/s")),
        (
            "of a wave, damping leaves",
            format!("{left:.3} % of its amplitude at the bit"),
        ),
        (
            "sampling frequency f_s",
            format!("{frequency:.decimals$} Hz ({why})"),
        ),
    ] {
        text += &row(2, title, &value);
    }
    if let Some(choice) = &sweep.choice {
        text += &describe_choice(choice);
    }
    text
}

/// How the string lies in its well, where it rubs there.
pub fn describe_well(sweep: &Sweep) -> String {
    let Some(friction) = &sweep.setting.friction else {
        return String::new();
    };
    let units = sweep.content.units;
    let (force, torque) = (units.of(&FORCE), units.of(&TORQUE).kilo());
    let weight = sweep.conditions.weight_on_bit_kn.unwrap_or(0.0);
    let [off_bottom, on_bottom] =
        [0.0, 1e3 * weight].map(|weight| 1e-3 * friction.torque_to_turn(weight));
    let mut rows = vec![
        (
            "inclination at the bit",
            format!("{:.1}°", friction.inclination_at_bit().to_degrees()),
        ),
        (
            "weight along the well",
            format!("{} off bottom", force.text(1e-3 * friction.hook_load(), 1)),
        ),
        (
            "torque to turn it",
            format!(
                "{} off bottom, per coefficient of friction",
                torque.text(off_bottom, 2)
            ),
        ),
    ];
    if weight > 0.0 {
        let (torque, weight) = (torque.text(on_bottom, 2), force.rounded(weight));
        let value = format!("{torque} at {weight} {} on the bit", force.name);
        rows.push(("", value));
    }
    rows.push((
        "pieces that slip as wholes",
        format!(
            "{}, off by {} % of the torque that turns all at most, where friction does not fall",
            friction.pieces(),
            per_cent(friction.off_by())
        ),
    ));
    let lines = rows.iter().map(|(title, value)| row(2, title, value));
    "\nwell\n".to_owned() + &lines.collect::<String>()
}

/// The parts of the string from the surface down, as on a BHA sheet.
fn part_lines(sweep: &Sweep) -> String {
    let length = sweep.content.units.of(&LENGTH);
    let mut text = format!(
        "    outer diameter      inner diameter      mass               length\n    \
         mm         in       mm         in       kg/m      lb/ft    {}\n",
        length.name
    );
    let sections = sweep.setting.string.sections().iter();
    for (section, table) in sections.zip(&sweep.content.string.sections) {
        let cell = length.text(section.cell_length(), 3);
        let mut title = format!("{} × {cell}", section.repeat);
        if let Some(name) = &table.name {
            title += &format!(", {name}");
        }
        text += &wrapped(&title, 2, 4);
        for part in &section.parts {
            text += "  ";
            for diameter in [2.0 * part.outer_radius, 2.0 * part.inner_radius] {
                text += &format!("  {:<9.1}{:<9.3}", 1e3 * diameter, diameter / INCH);
            }
            let mass = sweep.mass_per_length(part);
            let pounds = mass / POUND_PER_FOOT;
            let (length, decimals) = (length.number(part.length), length.decimals(3));
            text += &format!("  {mass:<8.1}  {pounds:<7.1}  {length:.decimals$}\n");
        }
    }
    text
}

/// What the weights of a BHA sheet say of its dimensions.
fn sheet_lines(sweep: &Sweep) -> String {
    let Some(sheet) = &sweep.sheet else {
        return String::new();
    };
    let title = format!(
        "rows of {} whose weight is not that of their dimensions",
        sheet.file
    );
    let lines = sheet.lines(sweep.content.units);
    let lines: String = lines.map(|line| wrapped(&line, 4, 6)).collect();
    match lines.is_empty() {
        true => lines,
        false => wrapped(&title, 2, 4) + &lines,
    }
}

/// What was chosen for an accuracy, and what else was tried.
fn describe_choice(choice: &Choice) -> String {
    let mut text = format!("\n{}", choice.lines(0));
    for tried in &choice.tried {
        let error = (tried.error).map_or_else(
            || "refused".to_owned(),
            |error| format!("{} %", per_cent(error)),
        );
        text += &wrapped(&format!("{}: {error}, {}", tried.candidate, tried.of), 2, 4);
    }
    text
}

/// Each method's responses, and whether they are stable in sticking.
pub fn describe_methods(systems: &[MethodSystem], units: Units) -> String {
    let lines = systems.iter().map(|system| method_lines(system, units));
    "\nmethods\n".to_owned() + &lines.collect::<String>()
}

fn method_lines(system: &MethodSystem, units: Units) -> String {
    let (torque, impulse) = (units.of(&TORQUE), units.of(&IMPULSE));
    let mobility = Unit::unchanged("rad/s").per(&torque);
    let mut text = format!(
        "  {}: response of {} ({:.2} s), built in {:.3} s\n",
        system.method.name(),
        counted(system.torsion_taps(), "step"),
        system.torsion_taps() as f64 / system.responses.sampling_frequency,
        system.build_seconds,
    );
    if let Some(taps) = system.driving_point() {
        for (title, value) in [
            ("A(0) at the bit", taps[0]),
            ("undershoot Δ (Eq. 75)", largest_undershoot(taps)),
        ] {
            let value = format!("{:.4e} {}", mobility.number(value), mobility.name);
            text += &row(4, title, &value);
        }
    }
    if let Some(front) = system.front {
        let value = format!(
            "{:.4e}: {:+.1} % here",
            mobility.number(front.exact),
            100.0 * front.overshoot()
        );
        text += &row(4, "exactly", &value);
    }
    for least in &system.least_impulses {
        text += &row(4, "least impulse I₀", &impulse.text(*least, 1));
    }
    for (margin, what) in [
        (system.torsion_margin, "torsion"),
        (system.bending_margin, "bending"),
    ] {
        if let Some(margin) = margin {
            let verdict = if is_unstable(margin) {
                "a stuck site chatters"
            } else {
                "stable in sticking"
            };
            let value = format!("{} in {what}: {verdict}", short(margin));
            text += &row(4, "positive-real margin", &value);
        }
    }
    text
}

/// From which surface speed on an eccentric mass brings the string to its wall, where that is known.
///
/// # Errors
/// Where a site is not on the string.
pub fn describe_forward_contact(sweep: &Sweep) -> Result<String> {
    let words = ForwardContact::of(sweep)?.map(|contact| contact.words(sweep.content.units));
    let text = |words: String| format!("\neccentric mass\n{}", wrapped(&words, 2, 2));
    Ok(words.map_or_else(String::new, text))
}

/// What is left out of the scene.
pub fn describe_left_out(sweep: &Sweep) -> String {
    let mut text = String::from("\nleft out, because the scene does not need it\n");
    if sweep.setting.lateral.is_none() {
        text += "  bending and the borehole wall: no lateral contact is modelled\n";
        if sweep.setting.sites.len() > 1 {
            text += "  sites other than the bit, in a run: labels are of the bit alone\n";
        }
    }
    if sweep.setting.lateral.is_some() && sweep.setting.hanging.is_none() {
        text += "  weight and tension of the string, in bending: no [axial_force] is given\n";
    }
    if sweep.setting.friction.is_none() {
        text += "  friction along the string: no [string_friction] is given\n";
        text += "  the torque at the surface, in a run: nothing depends on it\n";
    }
    if sweep.bit.is_none() {
        text += "  torque at the bit: the bit is free\n";
    }
    text
}

/// What the cases of a run take.
pub fn describe_work(sweep: &Sweep, survey: &Survey, systems: &[MethodSystem]) -> String {
    let rule = match sweep.time {
        AutoOr::Auto => "until the regime is decided",
        AutoOr::Given(_) => "given in the sweep file",
    };
    let mut text = format!(
        "\ncost\n  {} by {}, the longest {} s ({rule})\n",
        words_of_cases(&sweep.design),
        counted(systems.len(), "method"),
        short(survey.longest)
    );
    let terms: f64 = (systems.iter())
        .map(|system| history_terms(sweep, survey, system))
        .sum();
    if terms > 0.0 {
        text += &format!("  about {terms:.1e} terms of the history sum (Eq. 17)\n");
    }
    text
}

fn words_of_cases(design: &Design) -> String {
    let cases = counted(design.likely_cases(), "case");
    match design {
        Design::Trace(_) => format!("perhaps {cases} of a trace"),
        _ => cases,
    }
}

/// Terms of the history sums of cases of mean length: between all sites in
/// torsion and in two planes of bending, or from the torque at the bit to its
/// speed.
fn history_terms(sweep: &Sweep, survey: &Survey, system: &MethodSystem) -> f64 {
    let cases = sweep.design.likely_cases() as f64;
    let steps = survey.simulated / sweep.design.cases() as f64 * sweep.setting.sampling_frequency;
    let terms = |taps: usize| {
        let reach = steps.min(taps as f64);
        cases * reach * (steps - 0.5 * reach)
    };
    let torsion = terms(system.torsion_taps());
    let pairs = sweep.setting.sites.len().pow(2) as f64;
    match system.responses.bending() {
        Some(bending) => pairs * (torsion + 2.0 * terms(bending.taps())),
        None if sweep.bit.is_some() => torsion,
        None => 0.0,
    }
}
