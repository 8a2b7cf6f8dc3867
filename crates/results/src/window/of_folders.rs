//! The limits that results folders hold: of simulated cases, and Eq. 74.

use std::path::PathBuf;

use anyhow::Context;
use sim::Motion;

use super::analytic::{below_estimate, below_limit};
use super::asked::WindowAsked;
use super::chart::{Drawn, Source};
use super::error::WindowError;
use super::simulated::{AXES, Simulated, Vibrates, simulated};
use crate::folder::{Manifest, ResultTables};
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::quantities::Units;
use campaign::sweep_file::DesignKind;
use campaign::words::{counted, short};
use limits::{Boundary, Curve, exact_stick_slip_limit};

/// What all folders span, and the limits that each holds.
///
/// # Errors
/// Where a folder says nothing of limits, or they have no range in common.
pub fn limits(
    sweep: &Sweep,
    all: &[(PathBuf, ResultTables)],
    asked: &WindowAsked,
) -> Result<([[f64; 2]; 2], Vec<Source<'static>>), WindowError> {
    let (mut sources, mut curves) = (Vec::new(), Vec::new());
    let mut ranges = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
    for (folder, tables) in all {
        let manifest = &tables.manifest;
        let lies = sweep.setting.lying.is_some();
        let with_snaking = |motion: Motion| match motion {
            Motion::Lateral if lies => &[false, true][..],
            _ => &[false],
        };
        let motions = manifest.tally.motions().into_iter();
        let all_of =
            motions.flat_map(|motion| with_snaking(motion).iter().map(move |it| (motion, *it)));
        for (motion, snaking_counts) in all_of {
            let vibrates = Vibrates {
                chatter_is_safe: asked.accept_chatter,
                snaking_counts,
            };
            let found = simulated(tables, motion, vibrates, asked)
                .with_context(|| folder.display().to_string())
                .map_err(WindowError::Results)?;
            for (range, edges) in ranges.iter_mut().zip(found.edges()) {
                let (first, last) = (edges[0], edges[edges.len() - 1]);
                *range = [range[0].max(first), range[1].min(last)];
            }
            let is_alone = all.len() == 1;
            sources.push(of_cases(
                found,
                manifest,
                (motion, vibrates),
                is_alone,
                asked,
            ));
        }
        curves.extend(curves_of(
            &tables.boundary().map_err(WindowError::Results)?,
            &manifest.axes,
        ));
    }
    if sources.is_empty() {
        return Err(WindowError::NoLabel);
    }
    if ranges.iter().any(|[least, most]| least >= most) {
        let folders = all.iter().map(|(folder, _)| folder.clone());
        return Err(WindowError::NothingInCommon(folders.collect()));
    }
    sources.extend(of_curves(sweep, curves, ranges[0])?);
    Ok((ranges, sources))
}

/// By cases.
fn of_cases(
    found: Simulated,
    manifest: &Manifest,
    (motion, vibrates): (Motion, Vibrates),
    is_alone: bool,
    asked: &WindowAsked,
) -> Source<'static> {
    let regime = match motion {
        Motion::Axial if vibrates.chatter_is_safe => "bit bounce",
        Motion::Torsion if manifest.sweep.motor.is_some() => "stick-slip or a stalled motor",
        Motion::Lateral if vibrates.snaking_counts => "snaking or sustained whirl",
        _ => motion.regimes()[0],
    };
    // Names without commas, for they stand in a table.
    let of = match is_alone {
        true => String::new(),
        false => format!(" in {}", manifest.name),
    };
    Source {
        name: format!("{regime} (simulated{of})"),
        description: describe(&found, manifest, vibrates, asked.risk),
        edges: found.edges(),
        standing: Box::new(move |ends| found.standing(ends)),
        drawn: Drawn::Edge,
    }
}

/// How many cases, and what is between right and wrong.
fn describe(found: &Simulated, manifest: &Manifest, vibrates: Vibrates, risk: f64) -> String {
    let methods = manifest.method_names().join(", ");
    let cases = manifest.tally.rows / manifest.methods.len().max(1);
    let cases = counted(cases, "case");
    let margin = match (
        found,
        manifest.sweep.design.as_ref().map(|design| design.kind),
    ) {
        (Simulated::In(_), _) => format!(
            "clear where at most {} % of a cell's cases have it, by the upper end of the 95 % \
             interval",
            short(100.0 * risk)
        ),
        (_, Some(DesignKind::Trace)) if vibrates.snaking_counts => {
            "snaking is not traced; margin: between cases of the trace that differ, and where methods do"
                .to_owned()
        }
        (_, Some(DesignKind::Trace)) => {
            "traced; margin: a step of the trace, where methods differ and where it is ragged"
                .to_owned()
        }
        _ => "margin: between neighbouring cases that differ, and where methods do".to_owned(),
    };
    format!("{cases} by {methods}; {margin}")
}

/// Curves of Eq. 74 over weight.
fn curves_of(boundary: &Boundary, axes: &[Axis]) -> Vec<Curve> {
    let is_over_weight =
        |curve: &Curve| curve.motion == Motion::Torsion && curve.along == Axis::WeightOnBitKn;
    // Their names, which may have units, are not shown.
    let curves = boundary.curves(axes, Units::default()).into_iter();
    curves.filter(is_over_weight).collect()
}

/// What is known of torsion without a case, where the bit's torque has it: where smooth rotation is lost,
/// as the torque falls with the bit's speed, and the one-slip estimate.
fn of_curves(
    sweep: &Sweep,
    curves: Vec<Curve>,
    weights: [f64; 2],
) -> Result<Vec<Source<'static>>, WindowError> {
    if !sweep.setting.has_stick_slip_limit() {
        return Ok(Vec::new());
    }
    let is_estimate = |curve: &Curve| curve.method.is_some();
    let (estimate, lost) = curves.into_iter().partition(is_estimate);
    let sources = [one_slip_estimate(sweep, estimate, weights)?, loss(lost)];
    Ok(sources.into_iter().flatten().collect())
}

/// The one-slip estimate of stick-slip (Eq. 74) by each method and by the exact undershoot: methods
/// may agree with one another on fronts that they smear alike.
fn one_slip_estimate(
    sweep: &Sweep,
    mut curves: Vec<Curve>,
    weights: [f64; 2],
) -> Result<Option<Source<'static>>, WindowError> {
    // Where the string rubs along its well, that has a part in it.
    if sweep.content.string_friction.is_none() {
        let exact = exact_stick_slip_limit(sweep, weights)?;
        curves.extend(curves_of(&exact, &AXES));
    }
    if curves.is_empty() {
        return Ok(None);
    }
    let names: Vec<&str> = (curves.iter())
        .filter_map(|curve| curve.method.as_deref())
        .collect();
    let description = format!(
        "by {}; margin: all below the highest, for cases decide how far stick-slip goes",
        names.join(", ")
    );
    Ok(Some(Source {
        name: "one-slip estimate of stick-slip (Eq. 74)".to_owned(),
        description,
        edges: Default::default(),
        drawn: lines(&curves),
        standing: Box::new(move |ends| below_estimate(&curves, ends)),
    }))
}

/// The limit below which small vibration grows until smooth rotation is lost, which may take longer than
/// a case.
fn loss(curves: Vec<Curve>) -> Option<Source<'static>> {
    (!curves.is_empty()).then(|| Source {
        name: "loss of smooth rotation".to_owned(),
        description: "by exact waves; it may take longer than a case".to_owned(),
        edges: Default::default(),
        drawn: lines(&curves),
        standing: Box::new(move |ends| below_limit(&curves, ends)),
    })
}

fn lines(curves: &[Curve]) -> Drawn {
    Drawn::Lines(
        curves
            .iter()
            .flat_map(|curve| curve.pieces.clone())
            .collect(),
    )
}
