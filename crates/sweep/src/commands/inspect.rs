//! `sweep inspect`: the linear system of a sweep, in words, numbers and a
//! picture (Fig. 6).

use std::f64::consts::TAU;
use std::fmt::Write;
use std::time::Instant;

use anyhow::Result;
use linear::estimates::{
    largest_undershoot, torsional_decay_rate, torsional_stiffness, torsional_travel_time,
    torsional_wave_left,
};
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;

use super::cost::{Cost, of_built};
use super::plot::{axis, save_picture};
use super::{
    Status, build_systems, make_folder, read_sweep, results_folder, say, site_title, survey_cases,
    use_threads, warn_of_string,
};
use crate::cli::InspectArguments;
use crate::engine::{MethodSystem, Survey, is_unstable};
use crate::memory::{Purpose, admit, estimate};
use crate::plan::Choice;
use crate::plan::{INCH, LateralSettings, POUND_PER_FOOT, Sweep, Time};
use crate::plot::{Axis, Panel, Panels, Series, panels};
use crate::sweep_file::per_cent;
use crate::words::{counted, short, wrapped};

/// Points of the frequency response drawn.
const FREQUENCIES: usize = 4000;

/// Time shown of the step responses, in round trips of a wave.
const ROUND_TRIPS_SHOWN: f64 = 5.0;

/// Points of a curve.
type Curve = Vec<(f64, f64)>;

/// Shows the linear system.
pub fn inspect(arguments: &InspectArguments) -> Result<Status> {
    use_threads(arguments.work.jobs)?;
    let sweep = read_sweep(&arguments.file, &arguments.work, false, false)?;
    warn_of_string(&sweep);
    let folder = results_folder(arguments.out.as_ref(), &sweep);
    let survey = survey_cases(&arguments.file, &sweep)?;
    // Those that a run builds.
    let setting = sweep.setting.for_labels();
    let limit = arguments.work.memory.limit();
    admit(&sweep, &setting, &survey, Purpose::Look, &limit)?;
    let start = Instant::now();
    let systems = build_systems(&arguments.file, &sweep, &setting, survey.longest)?;
    let built = start.elapsed().as_secs_f64();
    let cost = Cost {
        memory: estimate(&sweep, &setting, &survey, Purpose::Labels, &limit)?,
        limit,
        time: of_built(&sweep, &survey, &systems, built),
    };
    make_folder(&folder)?;
    let picture = panels(&Panels {
        title: format!("{}: linear responses", sweep.title),
        panels: response_panels(&sweep, &systems)?,
    })?;
    save_picture(&folder, "inspect", &picture)?;
    say(&[
        describe_string(&sweep)?,
        describe_methods(&systems)?,
        describe_scene(&sweep, &survey, &systems)?,
        (cost.to_string().lines().map(|line| format!("  {line}\n"))).collect(),
        format!("\npicture: {}\n", folder.join("inspect.png").display()),
    ]
    .concat())?;
    Ok(Status::Complete)
}

fn describe_string(sweep: &Sweep) -> Result<String, std::fmt::Error> {
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

fn describe_methods(systems: &[MethodSystem]) -> Result<String, std::fmt::Error> {
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
    }
    Ok(text)
}

fn describe_scene(
    sweep: &Sweep,
    survey: &Survey,
    systems: &[MethodSystem],
) -> Result<String, std::fmt::Error> {
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

fn response_panels(sweep: &Sweep, systems: &[MethodSystem]) -> Result<Vec<Panel>> {
    let mut list = vec![frequency_panel(sweep)?];
    let bit = sweep.setting.sites.len() - 1;
    let series = |points: &dyn Fn(&MethodSystem) -> Option<Curve>| -> Vec<Series> {
        (systems.iter())
            .filter_map(|system| {
                Some(Series {
                    name: system.method.name().to_owned(),
                    points: points(system)?,
                })
            })
            .collect()
    };
    list.push(Panel {
        x: axis("Time t (s)"),
        y: axis("Bit speed / surface speed"),
        series: series(&|system| {
            let torsion = system.responses.torsion()?;
            Some(step_response(torsion.from_surface.last()?, 1.0, sweep))
        }),
        references: Vec::new(),
    });
    if sweep.bit.is_some() {
        list.push(Panel {
            x: axis("Time t (s)"),
            y: axis("Bit speed / torque (10⁻⁵ rad/s per N m)"),
            series: series(&|system| Some(step_response(system.driving_point()?, 1e5, sweep))),
            references: Vec::new(),
        });
    }
    if let Some(lateral) = &sweep.setting.lateral {
        let site = site_title(sweep.setting.sites.distances_from_bit()[bit]);
        list.push(receptance_panel(sweep, lateral, &site)?);
        list.push(Panel {
            // Longer than the steps above, so with a range of its own.
            x: axis("Time after the impulse t (s)"),
            y: axis(&format!("Displacement at {site} (10⁻⁵ m per N s)")),
            series: series(&|system| {
                let taps = system.responses.bending()?.taps_between(bit, bit)?;
                let samples = taps.iter().enumerate();
                let per_impulse = 1e5 * sweep.setting.sampling_frequency;
                Some(
                    samples
                        .map(|(index, tap)| {
                            (
                                index as f64 / sweep.setting.sampling_frequency,
                                per_impulse * tap,
                            )
                        })
                        .collect(),
                )
            }),
            references: Vec::new(),
        });
    }
    Ok(list)
}

/// Fig. 6(a): the exact response of the bit to the surface, up to half the
/// sampling frequency.
fn frequency_panel(sweep: &Sweep) -> Result<Panel> {
    let network = TorsionNetwork::new(&sweep.setting.string, &sweep.setting.sites)?;
    let bit = sweep.setting.sites.len() - 1;
    let highest = 0.5 * sweep.setting.sampling_frequency;
    let points = (1..=FREQUENCIES).map(|index| {
        let frequency = highest * index as f64 / FREQUENCIES as f64;
        let response = network.at_frequency(frequency);
        (frequency, response.from_surface[bit].norm())
    });
    Ok(Panel {
        x: axis("Frequency f (Hz)"),
        y: Axis {
            label: "|bit speed / surface speed|".to_owned(),
            logarithmic: true,
        },
        series: vec![Series {
            name: "exact".to_owned(),
            points: points.collect(),
        }],
        references: Vec::new(),
    })
}

/// Fig. 6(b): the exact displacement of the lowest site per lateral force there.
fn receptance_panel(sweep: &Sweep, lateral: &LateralSettings, site: &str) -> Result<Panel> {
    let network = BendingNetwork::new(
        &sweep.setting.string,
        lateral.bending,
        lateral.support,
        &sweep.setting.sites,
    )?;
    let lowest = sweep.setting.sites.len() - 1;
    let highest = 0.5 * sweep.setting.sampling_frequency;
    let points = (1..=FREQUENCIES).map(|index| {
        let frequency = highest * index as f64 / FREQUENCIES as f64;
        let receptance = network.at_rate(TAU * frequency);
        (frequency, receptance[(lowest, lowest)].norm())
    });
    Ok(Panel {
        x: axis("Frequency f (Hz)"),
        y: Axis {
            label: format!("|displacement / force| at {site} (m/N)"),
            logarithmic: true,
        },
        series: vec![Series {
            name: "exact".to_owned(),
            points: points.collect(),
        }],
        references: Vec::new(),
    })
}

/// The response to a unit step, times `factor`.
fn step_response(taps: &[f64], factor: f64, sweep: &Sweep) -> Curve {
    let shown = ROUND_TRIPS_SHOWN * 2.0 * torsional_travel_time(&sweep.setting.string);
    let count = (shown * sweep.setting.sampling_frequency).ceil() as usize;
    let mut sum = 0.0;
    (0..count)
        .map(|index| {
            sum += taps.get(index).copied().unwrap_or(0.0);
            (
                index as f64 / sweep.setting.sampling_frequency,
                factor * sum,
            )
        })
        .collect()
}
