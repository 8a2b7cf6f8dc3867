//! Measures of the string in torsion: Figs. 7(a), 8(b) and 9.

use std::collections::BTreeMap;

use anyhow::Result;
use linear::estimates::{largest_undershoot, torsional_stiffness, torsional_travel_time};
use linear::waves::inversion::time_response;
use linear::waves::network::TorsionNetwork;
use linear::{Complex64, Method, RaisedCosine};
use sim::Outcome;

use super::history::{History, Input};
use super::measure::Measure;
use super::part::Part;
use super::row::Reference;
use crate::scenes::{Loss, shipped_with};
use crate::stick_slip;
use campaign::accuracy::methods::hilbert;
use campaign::accuracy::trial;
use campaign::engine::MethodSystem;
use campaign::plan::{Setting, Sweep};

/// A step is compared through a window of this length, s.
const STEP_WINDOW: RaisedCosine = RaisedCosine { duration: 0.1 };

/// Time compared after a step, s: eight round trips of a wave.
const STEP_TIME: f64 = 5.0;

/// The narrowest window through which the undershoot is measured, s. The string
/// has details down to the half metre of a joint, which a wave passes in 0.16 ms.
const UNDERSHOOT_WINDOW: f64 = 1e-4;

/// Samples in a window of the exact response.
const SAMPLES_PER_WINDOW: f64 = 8.0;

/// Where the limit of stick-slip is looked for on the paper's string and the tube, rpm per kN m.
const LIMIT_BRACKET: [f64; 2] = [0.03, 0.12];

/// Sampling frequency of the references, Hz: a wave moves by 2 cm in a sample.
const REFERENCE_FREQUENCY: f64 = 163_840.0;

/// Transform behind the reference filter, s.
const REFERENCE_TRANSFORM: f64 = 20.0;

/// The string in torsion, with what the measures wanted should be; `highest` is the
/// highest sampling frequency, Hz.
///
/// # Errors
/// Where a reference cannot be computed.
pub fn part(wanted: &[Measure], highest: f64, loss: Loss) -> Result<Part> {
    let sweep = shipped_with("fig08b.toml", loss)?;
    let (mut references, mut history) = (BTreeMap::new(), None);
    let mut simulated = Vec::new();
    for &measure in wanted {
        let reference = match measure {
            Measure::SurfaceStep => {
                let (input, setting) = (Input::SurfaceStep, &sweep.setting);
                let step = History::new(input, STEP_WINDOW, setting, highest, STEP_TIME)?;
                history = Some((measure, step));
                Reference::exact(1.0)
            }
            Measure::SteadySpeed => Reference::exact(1.0),
            Measure::StaticStiffness => {
                Reference::exact(torsional_stiffness(&sweep.setting.string))
            }
            Measure::Undershoot => exact_undershoot(&sweep.setting)?,
            _ => {
                simulated.push(measure);
                continue;
            }
        };
        references.insert(measure, reference);
    }
    let mut part = Part {
        longest: longest_time(&sweep, bracket(&sweep)?)?,
        sweep,
        impulse_duration: f64::INFINITY,
        highest: f64::INFINITY,
        whole_steps_of: None,
        history,
        references,
        number,
    };
    if !simulated.is_empty() {
        let references = simulated_references(&part, &simulated)?;
        part.references
            .extend(simulated.into_iter().zip(references));
    }
    Ok(part)
}

/// Δ of the exact response, through ever narrower windows.
fn exact_undershoot(setting: &Setting) -> Result<Reference> {
    let network = TorsionNetwork::new(&setting.string, &setting.sites)?;
    let round_trips = 6.0 * torsional_travel_time(&setting.string);
    let through = |duration: f64| {
        let (window, step) = (RaisedCosine { duration }, duration / SAMPLES_PER_WINDOW);
        let response = |s: Complex64| {
            let admittance = network.admittance(s).from_torque[(0, 0)];
            admittance * window.transform(s) / s
        };
        let count = (round_trips / step).ceil() as usize;
        let speeds = time_response(response, step, count, 2);
        -speeds.into_iter().fold(f64::INFINITY, f64::min)
    };
    let (wide, narrow) = (through(2.0 * UNDERSHOOT_WINDOW), through(UNDERSHOOT_WINDOW));
    Ok(Reference {
        value: narrow,
        uncertainty: (narrow / wide - 1.0).abs(),
    })
}

/// What two methods that share no discretisation agree on at a frequency far above the
/// ladder: quadrature, extrapolated, and the digital filter.
fn simulated_references(part: &Part, measures: &[Measure]) -> Result<Vec<Reference>> {
    // Where the torque jumps, the order is the first.
    let quadrature =
        part.extrapolated_numbers(Method::Quadrature, REFERENCE_FREQUENCY, 1, measures)?;
    let filter = part.numbers(hilbert(REFERENCE_TRANSFORM), REFERENCE_FREQUENCY, measures)?;
    let pairs = quadrature.into_iter().zip(filter);
    Ok(pairs
        .map(|(one, other)| {
            let agreed = Reference::agreed(one, other);
            Reference {
                uncertainty: agreed.uncertainty + 1.0 / REFERENCE_FREQUENCY,
                ..agreed
            }
        })
        .collect())
}

/// A measure in torsion, of any string.
pub fn number(
    sweep: &Sweep,
    system: &MethodSystem,
    outcome: Option<Outcome>,
    measure: Measure,
) -> Option<f64> {
    let bit = outcome.and_then(|outcome| outcome.torsion());
    match measure {
        Measure::SteadySpeed => Some(system.responses.torsion()?.from_surface[0].iter().sum()),
        Measure::StaticStiffness => {
            let frequency = system.setting.sampling_frequency;
            let turned = system.driving_point()?.iter().scan(0.0, |speed, tap| {
                *speed += tap;
                Some(*speed / frequency)
            });
            Some(1.0 / turned.sum::<f64>())
        }
        Measure::Undershoot | Measure::TubeUndershoot | Measure::JointedUndershoot => {
            Some(largest_undershoot(system.driving_point()?))
        }
        Measure::FirstSlip => bit?.first_slip,
        Measure::Period => bit?.period,
        Measure::StickSlipLimit | Measure::TubeStickSlipLimit | Measure::TubeFittedLimit => {
            stick_slip_limit(sweep, system, bracket(sweep).ok()?)
        }
        Measure::JointedStickSlipLimit => {
            stick_slip_limit(sweep, system, stick_slip::bracket(sweep).ok()?)
        }
        _ => None,
    }
}

/// The ratio of speed to torque (rpm per kN m) above which the motion is smooth.
fn stick_slip_limit(sweep: &Sweep, system: &MethodSystem, bracket: [f64; 2]) -> Option<f64> {
    per_torque(sweep, stick_slip::limit(sweep, system, bracket)?)
}

/// Where it is looked for on the paper's string and the tube, rpm.
pub fn bracket(sweep: &Sweep) -> Result<[f64; 2]> {
    let torque = stick_slip::exact::torque(sweep)?.torque_dynamic;
    Ok(LIMIT_BRACKET.map(|ratio| ratio * torque / 1e3))
}

/// A surface speed in rpm as a ratio to the torque, rpm per kN m.
pub fn per_torque(sweep: &Sweep, speed: f64) -> Option<f64> {
    let torque = stick_slip::exact::torque(sweep).ok()?.torque_dynamic;
    Some(1e3 * speed / torque)
}

/// The longest time that any case lasts with a limit in a bracket (rpm), s.
pub fn longest_time(sweep: &Sweep, bracket: [f64; 2]) -> Result<f64> {
    let own = trial::case(sweep, &sweep.setting, &sweep.conditions)?;
    let of_limit = stick_slip::longest_time(sweep, bracket)?;
    Ok(own.scene.timing.duration.max(of_limit))
}
