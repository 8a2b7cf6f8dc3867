//! Measures of the string in bending: Figs. 7(b), 12 and 14.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use anyhow::{Context, Result};
use linear::method::FiniteElement;
use linear::{Method, RaisedCosine};
use sim::{LateralRegime, Outcome, Stopping};

use super::history::{History, Input};
use super::measure::Measure;
use super::part::Part;
use super::row::Reference;
use crate::scenes::{Loss, shipped_with};
use campaign::accuracy::bisection::limit_between;
use campaign::accuracy::trial;
use campaign::engine::MethodSystem;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::sweep_file::AutoOr;
use limits::rolling_whirls;

/// Where the limit of whirl is looked for, coefficient of friction.
const LIMIT_BRACKET: [f64; 2] = [0.8, 3.0];

/// Sampling frequencies of the references, Hz.
const QUADRATURE_FREQUENCY: f64 = 10_240.0;
const ELEMENT_FREQUENCY: f64 = 5120.0;

/// Elements in a cell of the drillpipe, for the reference.
const REFERENCE_ELEMENTS: usize = 40;

/// The string in bending, with what the measures wanted should be; `highest` is the
/// highest sampling frequency, Hz. The exact waves give the impulse response and, by the
/// balance of forces in steady whirl, all that Fig. 12 shows.
///
/// # Errors
/// Where a reference cannot be computed.
pub fn part(wanted: &[Measure], highest: f64, loss: Loss) -> Result<Part> {
    let sweep = shipped_with("fig12.toml", loss)?;
    let lateral = sweep.setting.lateral.as_ref();
    let lateral = lateral.context("fig12 has a wall")?;
    let impulse = lateral.impulses.first().context("fig12 has an impulse")?;
    let impulse_duration = impulse.duration;
    let AutoOr::Given(time) = sweep.time else {
        anyhow::bail!("fig12 has a time");
    };
    let surface_speed = sweep.conditions.surface_speed();
    let surface_speed = surface_speed.context("fig12 has a surface speed")?;
    let whirls = rolling_whirls(&sweep.setting, lateral, 0, surface_speed)?;
    let whirl = whirls.first().context("there is no steady whirl")?;
    let (mut references, mut history) = (BTreeMap::new(), None);
    for &measure in wanted {
        let value = match measure {
            Measure::LateralImpulse => {
                let duration = impulse_duration;
                let (input, window) = (Input::BitImpulse, RaisedCosine { duration });
                let response = History::new(input, window, &sweep.setting, highest, time)?;
                history = Some((measure, response));
                1.0
            }
            Measure::WhirlRadius => whirl.radius,
            Measure::WhirlRate => whirl.rate / TAU,
            Measure::WhirlForce => whirl.normal_force,
            _ => continue,
        };
        references.insert(measure, Reference::exact(value));
    }
    let mut part = Part {
        sweep,
        longest: time,
        impulse_duration,
        highest: f64::INFINITY,
        whole_steps_of: None,
        history,
        references,
        number,
    };
    if wanted.contains(&Measure::WhirlLimit) {
        let reference = whirl_limit_reference(&part)?;
        part.references.insert(Measure::WhirlLimit, reference);
    }
    Ok(part)
}

/// What quadrature and finite elements agree on, both extrapolated.
fn whirl_limit_reference(part: &Part) -> Result<Reference> {
    let limit = |method, sampling_frequency, order| {
        let limit = [Measure::WhirlLimit];
        let found = part.extrapolated_numbers(method, sampling_frequency, order, &limit)?;
        anyhow::Ok(found[0])
    };
    let elements = Method::FiniteElement(FiniteElement {
        elements_per_cell: REFERENCE_ELEMENTS,
        ..FiniteElement::default()
    });
    let one = limit(Method::Quadrature, QUADRATURE_FREQUENCY, 2)?;
    // Numerical damping makes Newmark's scheme one of first order.
    let other = limit(elements, ELEMENT_FREQUENCY, 1)?;
    Ok(Reference::agreed(one, other))
}

fn number(
    sweep: &Sweep,
    system: &MethodSystem,
    outcome: Option<Outcome>,
    measure: Measure,
) -> Option<f64> {
    let whirl = outcome
        .and_then(|outcome| outcome.lateral())
        .filter(|lateral| lateral.regime == LateralRegime::BackwardWhirl);
    match measure {
        Measure::WhirlRadius => Some(whirl?.mean_radius),
        Measure::WhirlRate => Some(-whirl?.precession_rate / TAU),
        Measure::WhirlForce => Some(whirl?.mean_normal_force),
        Measure::WhirlLimit => whirl_limit(sweep, system),
        _ => None,
    }
}

/// The friction above which whirl starts, the impulse being that of Fig. 12.
fn whirl_limit(sweep: &Sweep, system: &MethodSystem) -> Option<f64> {
    limit_between(LIMIT_BRACKET, |friction| {
        let conditions = sweep.conditions.with(Axis::FRICTION, friction);
        let outcome = trial::outcome(sweep, system, &conditions, Stopping::Early).ok()?;
        Some(outcome.lateral()?.regime == LateralRegime::BackwardWhirl)
    })
}
