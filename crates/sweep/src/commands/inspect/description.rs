//! The linear system of a sweep in words and numbers.

use std::fmt::Write;

use linear::estimates::{
    largest_undershoot, torsional_decay_rate, torsional_stiffness, torsional_travel_time,
    torsional_wave_left,
};

use crate::accuracy::Choice;
use crate::engine::{MethodSystem, Survey, is_unstable};
use crate::sweep_file::{INCH, POUND_PER_FOOT, Sweep, Time, per_cent};
use crate::words::{counted, short, wrapped};

/// The string, from the surface to the bit.
pub fn describe_string(sweep: &Sweep) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let string = &sweep.setting.string;
    let travel = torsional_travel_time(string);
    text += &wrapped(&format!("{}: {}", sweep.name, sweep.title), 0, 2);
    text.push('\n');
    writeln!(text, "string")?;
    writeln!(
        text,
        "  length                     {:.3} m",
        string.length()
    )?;
    text += &part_lines(sweep)?;
    writeln!(
        text,
        "  torsional stiffness k_eff  {:.1} N m/rad",
        torsional_stiffness(string)
    )?;
    writeln!(
        text,
        "  torsional wave speed       {:.1} m/s",
        string.torsional_wave_speed()
    )?;
    writeln!(
        text,
        "  travel time to the bit     {travel:.4} s, and back {:.4} s",
        2.0 * travel
    )?;
    writeln!(
        text,
        "  torsional decay rate       {:.3} 1/s",
        torsional_decay_rate(string)
    )?;
    writeln!(
        text,
        "  of a wave, damping leaves  {:.3} % of its amplitude at the bit",
        100.0 * torsional_wave_left(string)
    )?;
    let why = if sweep.setting.sampling_by_rule {
        "four times the first mode of one cell"
    } else {
        "given in the sweep file"
    };
    let why = match sweep.choice {
        Some(_) => "by the accuracy asked for",
        None => why,
    };
    writeln!(
        text,
        "  sampling frequency f_s     {:.2} Hz ({why})",
        sweep.setting.sampling_frequency
    )?;
    if let Some(choice) = &sweep.choice {
        text += &describe_choice(choice);
    }
    Ok(text)
}

/// The parts of the string from the surface down, as on a BHA sheet.
fn part_lines(sweep: &Sweep) -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        "    outer diameter      inner diameter      mass               length\n    \
         mm         in       mm         in       kg/m      lb/ft    m\n",
    );
    let sections = sweep.setting.string.sections().iter();
    for (section, table) in sections.zip(&sweep.content.string.sections) {
        let mut title = format!("{} × {:.3} m", section.repeat, section.cell_length());
        if let Some(name) = &table.name {
            title += &format!(", {name}");
        }
        text += &wrapped(&title, 2, 4);
        for part in &section.parts {
            text += "  ";
            for diameter in [2.0 * part.outer_radius, 2.0 * part.inner_radius] {
                write!(text, "  {:<9.1}{:<9.3}", 1e3 * diameter, diameter / INCH)?;
            }
            let mass = sweep.mass_per_length(part);
            let pounds = mass / POUND_PER_FOOT;
            writeln!(text, "  {mass:<8.1}  {pounds:<7.1}  {:.3}", part.length)?;
        }
    }
    Ok(text)
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
pub fn describe_methods(systems: &[MethodSystem]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    writeln!(text, "\nmethods")?;
    for system in systems {
        writeln!(
            text,
            "  {}: {} ({:.2} s), built in {:.3} s",
            system.method.name(),
            counted(system.torsion_taps(), "tap"),
            system.torsion_taps() as f64 / system.responses.sampling_frequency,
            system.build_seconds,
        )?;
        if let Some(taps) = system.driving_point() {
            writeln!(
                text,
                "    A(0) at the bit          {:.4e} rad/s per N m",
                taps[0]
            )?;
            writeln!(
                text,
                "    undershoot Δ (Eq. 75)    {:.4e} rad/s per N m",
                largest_undershoot(taps)
            )?;
        }
        for least in &system.least_impulses {
            writeln!(text, "    least impulse I₀         {least:.1} N s")?;
        }
        text += &margin_lines(system)?;
    }
    Ok(text)
}

/// Whether a method is stable where a site sticks.
fn margin_lines(system: &MethodSystem) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
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
            writeln!(
                text,
                "    positive-real margin     {} in {what}: {verdict}",
                short(margin)
            )?;
        }
    }
    Ok(text)
}

/// What is left out of the scene.
pub fn describe_left_out(sweep: &Sweep) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    writeln!(text, "\nleft out, because the scene does not need it")?;
    if sweep.setting.lateral.is_none() {
        writeln!(
            text,
            "  bending and the borehole wall: no lateral contact is modelled"
        )?;
        if sweep.setting.sites.len() > 1 {
            writeln!(
                text,
                "  sites other than the bit, in a run: labels are of the bit alone"
            )?;
        }
    }
    writeln!(text, "  the torque at the surface: nothing depends on it")?;
    if sweep.bit.is_none() {
        writeln!(text, "  torque at the bit: the bit is free")?;
    }
    Ok(text)
}

/// What the cases of a run take.
pub fn describe_work(
    sweep: &Sweep,
    survey: &Survey,
    systems: &[MethodSystem],
) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let rule = match sweep.time {
        Time::Auto => "until the regime can be told",
        Time::Given(_) => "given in the sweep file",
    };
    writeln!(text, "\ncost")?;
    writeln!(
        text,
        "  {} by {}, the longest {} s ({rule})",
        counted(sweep.design.cases(), "case"),
        counted(systems.len(), "method"),
        short(survey.longest)
    )?;
    let terms: f64 = (systems.iter())
        .map(|system| history_terms(sweep, survey, system))
        .sum();
    if terms > 0.0 {
        writeln!(
            text,
            "  about {terms:.1e} terms of the history sum (Eq. 17)"
        )?;
    }
    Ok(text)
}

/// Terms of the history sums of cases of mean length: between all sites in
/// torsion and in two planes of bending, or from the torque at the bit to its
/// speed.
fn history_terms(sweep: &Sweep, survey: &Survey, system: &MethodSystem) -> f64 {
    let cases = sweep.design.cases() as f64;
    let steps = survey.simulated / cases * sweep.setting.sampling_frequency;
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
