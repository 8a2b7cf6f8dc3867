//! What `simulate` prints of each case.

use std::fmt::Write;
use std::path::Path;

use anyhow::Result;
use linear::elements::reconstruction::Reconstruction;
use sim::{Ended, Outcome};

use super::vibration::Vibration;
use campaign::engine::{Beyond, Case, Clearances, Simulation};

use campaign::plan::Sweep;
use campaign::quantities::{FORCE, LENGTH, RATE, TORQUE, Units, WIDTH};
use campaign::records::{Found, to_kn, to_m_h, to_mm, to_rpm};
use campaign::words::{counted, decimals, short, site_title, together, wrapped};

/// The sites that were found, every case with what a run answers to it by each method, what came
/// out later where that differs, and how far the whole string goes beyond the wall; then the files
/// that were written into a folder.
pub fn case_lines(
    sweep: &Sweep,
    found: Option<&Found>,
    cases: &[Case],
    simulations: &[Simulation],
    wholes: &[Reconstruction],
    (files, folder): (&str, &Path),
) -> Result<String> {
    let mut text = String::new();
    text += &found.map_or_else(String::new, |found| found_line(sweep, found));
    for case in cases {
        let rpm = to_rpm(case.scene.surface_speed);
        let unit = sweep.content.units.of(&TORQUE);
        let torque = case.torque_dynamic_nm.map_or_else(String::new, |torque| {
            format!(", T_d = {}", unit.text(torque, 1))
        });
        writeln!(text, "Ω = {rpm:.4} rpm{torque}")?;
        let own = |simulation: &&Simulation| simulation.case == case.index;
        for simulation in simulations.iter().filter(own) {
            text += &answer_lines(sweep, simulation);
            text += &vibration_line(sweep, simulation);
        }
        let clearances = Clearances::of(&sweep.setting, case);
        for (simulation, whole) in simulations.iter().zip(wholes) {
            let own = clearances
                .as_ref()
                .filter(|_| simulation.case == case.index);
            if let Some(clearances) = own {
                text += &beyond_line(sweep, clearances, simulation, whole);
            }
        }
    }
    let folder = together(&folder.display().to_string());
    text += &wrapped(&format!("{files} are in {folder}"), 0, 0);
    Ok(text)
}

/// Which sites were found, and in how many rounds.
fn found_line(sweep: &Sweep, Found { sites, rounds }: &Found) -> String {
    if sites.is_empty() {
        return "no sites were found other than those of the file\n".to_owned();
    }
    let length = sweep.content.units.of(&LENGTH);
    let places = sites.iter().map(|site| short(length.number(*site)));
    let words = format!(
        "{} found in {}, {} {} from the bit",
        counted(sites.len(), "site"),
        counted(*rounds, "round"),
        places.collect::<Vec<_>>().join(", "),
        length.name
    );
    wrapped(&words, 0, 2)
}

/// Where the whole string goes farthest beyond the wall away from its sites: there is no wall
/// there to keep it.
fn beyond_line(
    sweep: &Sweep,
    clearances: &Clearances,
    simulation: &Simulation,
    whole: &Reconstruction,
) -> String {
    let units = sweep.content.units;
    let width = |value: f64| together(&units.of(&WIDTH).text(1e3 * value, 2));
    let at_sites = clearances
        .farthest_at_sites(&simulation.trajectory)
        .max(0.0);
    let penetration = match clearances.farthest_beyond(whole) {
        Some(Beyond {
            depth,
            by,
            clearance,
        }) if by > at_sites => {
            let above = together(&units.of(&LENGTH).text(clearances.length() - depth, 1));
            format!(
                "goes {} beyond the wall {above} above the bit, where it has no site and a \
                 clearance of {}; {} at its sites",
                width(by),
                width(clearance),
                width(at_sites)
            )
        }
        Some(Beyond { by, .. }) if by > 0.0 => format!(
            "goes nowhere farther beyond the wall than at its sites, {}",
            width(at_sites)
        ),
        _ => "goes nowhere beyond the wall away from its sites".to_owned(),
    };
    wrapped(
        &format!("{}: the string {penetration}", simulation.name),
        2,
        4,
    )
}

/// How the bit vibrates at the end, where its torque falls with speed.
fn vibration_line(sweep: &Sweep, simulation: &Simulation) -> String {
    let vibration = Vibration::at_the_end(sweep, &simulation.trajectory);
    let lowest = sweep.setting.string.sections().last();
    let bit = lowest.and_then(|section| section.parts.last());
    let words = vibration.zip(bit).map(|(vibration, bit)| {
        let words = vibration.in_words(sweep.bit_radius().unwrap_or(bit.outer_radius));
        wrapped(&format!("{}: {words}", simulation.name), 2, 4)
    });
    words.unwrap_or_default()
}

fn answer_lines(sweep: &Sweep, simulation: &Simulation) -> String {
    let units = sweep.content.units;
    let answers = measures(&simulation.answer, simulation.site_from_bit_m, units);
    let push = simulation.wall_push.map(|push| push.sentence(units));
    let name = &simulation.name;
    let mut text: String = (answers.iter().chain(&push))
        .map(|answer| wrapped(&format!("{name}: {answer}"), 2, 4))
        .collect();
    let followed = &simulation.followed;
    let distances = sweep.setting.sites.distances_from_bit();
    let site = followed.lateral().map(|lateral| distances[lateral.site]);
    let to_end = measures(followed, site, units);
    if to_end != answers {
        let why = match simulation.answer.ended {
            Ended::Settled => "settled",
            Ended::Certain => "certain",
            Ended::End => "at its end",
            other => other.name(),
        };
        let (early, late) = (simulation.answer.simulated, followed.simulated);
        for measures in to_end {
            let words = format!(
                "a run stops at {} s as {why}; followed to {} s: {measures}",
                short(early),
                short(late)
            );
            text += &wrapped(&words, 4, 6);
        }
    }
    text
}

/// What came out, in bending and in torsion.
fn measures(outcome: &Outcome, site_from_bit_m: Option<f64>, units: Units) -> Vec<String> {
    let mut found = Vec::new();
    let mut add = |measures: &[String]| {
        let measures: Vec<String> = measures.iter().map(|words| together(words)).collect();
        found.push(measures.join(", "));
    };
    if let (Some(lateral), Some(distance)) = (outcome.lateral(), site_from_bit_m) {
        let turns = lateral.precession_rate / std::f64::consts::TAU;
        let in_units = |twin, value| {
            let unit = units.of(twin);
            let number = decimals(unit.number(value), unit.decimals(2));
            format!("{number} {}", unit.name)
        };
        add(&[
            lateral.regime.name().to_owned(),
            format!(
                "at {} in contact {:.0} % of the closing window",
                site_title(distance, units),
                100.0 * lateral.contact_fraction
            ),
            format!("r = {}", in_units(&WIDTH, 1e3 * lateral.mean_radius)),
            format!("{} turns/s", decimals(turns, 2)),
            format!(
                "F_N = {}",
                in_units(&FORCE, 1e-3 * lateral.mean_normal_force)
            ),
        ]);
    }
    if let Some(torsion) = outcome.torsion() {
        let seconds = |value: Option<f64>| {
            value.map_or_else(|| "–".to_owned(), |value| format!("{value:.3} s"))
        };
        add(&[
            torsion.regime.name().to_owned(),
            format!("first slip {}", seconds(torsion.first_slip)),
            format!("period {}", seconds(torsion.period)),
            format!("slipping {}", seconds(torsion.slip_time)),
            counted(torsion.sticks, "stick"),
            format!("peak {} rpm", short(to_rpm(torsion.peak_speed))),
            (torsion.severity).map_or_else(
                || "no severity".to_owned(),
                |severity| format!("severity {severity:.2}"),
            ),
        ]);
        if let Some(part) = torsion.motor_stalled_fraction {
            let words = format!(
                "mud motor stalls for {:.0} % of the closing window",
                100.0 * part
            );
            add(&[words]);
        }
    }
    if let Some(axial) = outcome.axial() {
        let per_cent = |part: f64| format!("{:.1} %", 100.0 * part);
        let rate = units.of(&RATE);
        let steady = axial
            .part_of_steady
            .map(|part| format!("{part:.2} of steady drilling"));
        let weight = units.of(&FORCE);
        let measures: Vec<String> = [
            axial.regime.name().to_owned(),
            rate.text(to_m_h(axial.rate_of_penetration), 1),
        ]
        .into_iter()
        .chain(steady)
        .chain([
            format!("off bottom {}", per_cent(axial.off_bottom)),
            format!("W to {}", weight.text(to_kn(axial.peak_weight), 1)),
            format!(
                "cut to {}",
                units.of(&WIDTH).text(to_mm(axial.peak_depth_of_cut), 2)
            ),
        ])
        .collect();
        add(&measures);
    }
    if found.is_empty() {
        found.push("the bit is free".to_owned());
    }
    if let Some(along) = outcome.string_torque {
        let torque = units.of(&TORQUE).kilo().text(1e-3 * along.peak_torque, 3);
        let place = units.of(&LENGTH).text(along.from_bit, 1);
        found.push(format!(
            "greatest torque along the string {torque}, {place} above the bit"
        ));
    }
    found
}
