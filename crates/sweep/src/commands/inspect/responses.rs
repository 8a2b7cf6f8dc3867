//! The picture of the linear system of a sweep: its responses over frequency and time.

use std::f64::consts::TAU;

use anyhow::Result;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{DrillstringError, Sites};

use campaign::engine::MethodSystem;
use campaign::plan::{LateralSettings, Setting, Sweep};
use campaign::quantities::{FORCE, IMPULSE, LENGTH, TORQUE, Unit};
use campaign::words::site_title;
use plot::{Axis, Look, Panel, Picture, Series, method_style, panels};

/// Points of the frequency response drawn.
const FREQUENCIES: usize = 4000;

/// Points of a curve.
type Curve = Vec<(f64, f64)>;

/// The exact responses, and those of each method.
pub fn response_picture(look: &Look, sweep: &Sweep, responses: &[Panel]) -> Picture {
    let title = format!("{}: linear responses", sweep.title);
    panels(look, &title, responses)
}

/// What it shows.
///
/// # Errors
/// Where the string has no exact response.
pub fn response_panels(sweep: &Sweep, systems: &[MethodSystem]) -> Result<Vec<Panel>> {
    let mut list = vec![
        frequency_panel(sweep)?,
        time_panel("t", "Bit speed / surface speed", systems, &|system| {
            let torsion = system.responses.torsion()?;
            Some(step_response(
                torsion.from_surface.last()?,
                1.0,
                &system.setting,
            ))
        }),
    ];
    if sweep.bit.is_some() {
        let unit = Unit::unchanged("rad/s").per(&sweep.content.units.of(&TORQUE));
        let label = format!("Bit speed / torque (10⁻⁵ {})", unit.name);
        let factor = unit.number(1e5);
        list.push(time_panel("t", &label, systems, &|system| {
            Some(step_response(
                system.driving_point()?,
                factor,
                &system.setting,
            ))
        }));
    }
    if let Some(lateral) = &sweep.setting.lateral {
        let bit = sweep.setting.sites.len() - 1;
        let units = sweep.content.units;
        let site = site_title(sweep.setting.sites.distances_from_bit()[bit], units);
        list.push(receptance_panel(sweep, lateral, &site)?);
        let unit = units.of(&LENGTH).per(&units.of(&IMPULSE));
        let label = format!("Displacement at {site} (10⁻⁵ {})", unit.name);
        let factor = unit.number(1e5);
        // Longer than the steps above, so with its own range.
        list.push(time_panel(
            "after the impulse t",
            &label,
            systems,
            &|system| {
                let taps = system.responses.bending()?.taps_between(bit, bit)?;
                Some(impulse_response(taps, factor, &system.setting))
            },
        ));
    }
    Ok(list)
}

/// Each method's response over time.
fn time_panel(
    time: &str,
    label: &str,
    systems: &[MethodSystem],
    points: &dyn Fn(&MethodSystem) -> Option<Curve>,
) -> Panel {
    let of_method = |system: &MethodSystem| {
        Some(Series {
            name: system.method.name().to_owned(),
            style: method_style(system.method.name()),
            points: points(system)?,
        })
    };
    Panel {
        axes: [&format!("Time {time} (s)"), label].map(Axis::linear),
        series: systems.iter().filter_map(of_method).collect(),
        references: Vec::new(),
        walls: Vec::new(),
        is_difference: false,
    }
}

/// The lowest site alone: what is between all of thousands takes minutes, and is not drawn.
fn lowest_site(sweep: &Sweep) -> Result<Sites, DrillstringError> {
    let setting = &sweep.setting;
    let distances = setting.sites.distances_from_bit();
    Sites::new(&setting.string, &distances[distances.len() - 1..])
}

/// Fig. 6(a): the exact response of the bit to the surface.
fn frequency_panel(sweep: &Sweep) -> Result<Panel> {
    let network = TorsionNetwork::new(&sweep.setting.string, &lowest_site(sweep)?)?;
    Ok(exact_panel(
        "|bit speed / surface speed|",
        sweep,
        &|frequency| network.at_frequency(frequency).from_surface[0].norm(),
    ))
}

/// Fig. 6(b): the exact displacement of the lowest site per lateral force there.
fn receptance_panel(sweep: &Sweep, lateral: &LateralSettings, site: &str) -> Result<Panel> {
    let network = BendingNetwork::new(
        &sweep.setting.string,
        lateral.bending,
        lateral.support,
        &lowest_site(sweep)?,
    )?;
    let units = sweep.content.units;
    let unit = units.of(&LENGTH).per(&units.of(&FORCE).without_kilo());
    let label = format!("|displacement / force| at {site} ({})", unit.name);
    Ok(exact_panel(&label, sweep, &|frequency| {
        unit.number(network.at_rate(TAU * frequency)[(0, 0)].norm())
    }))
}

/// An exact response up to half the sampling frequency.
fn exact_panel(label: &str, sweep: &Sweep, response: &dyn Fn(f64) -> f64) -> Panel {
    let highest = 0.5 * sweep.setting.sampling_frequency;
    let points = (1..=FREQUENCIES).map(|index| {
        let frequency = highest * index as f64 / FREQUENCIES as f64;
        (frequency, response(frequency))
    });
    Panel {
        axes: [Axis::linear("Frequency f (Hz)"), Axis::logarithmic(label)],
        series: vec![Series {
            name: "exact".to_owned(),
            style: method_style("exact"),
            points: points.collect(),
        }],
        references: Vec::new(),
        walls: Vec::new(),
        is_difference: false,
    }
}

/// The response to a unit step, times `factor`.
fn step_response(taps: &[f64], factor: f64, setting: &Setting) -> Curve {
    let mut sum = 0.0;
    (0..setting.steps_shown())
        .map(|index| {
            sum += taps.get(index).copied().unwrap_or(0.0);
            let time = index as f64 / setting.sampling_frequency;
            (time, factor * sum)
        })
        .collect()
}

/// The response to a unit impulse, times `factor`.
fn impulse_response(taps: &[f64], factor: f64, setting: &Setting) -> Curve {
    let frequency = setting.sampling_frequency;
    (taps.iter().enumerate())
        .map(|(index, tap)| (index as f64 / frequency, factor * frequency * tap))
        .collect()
}
