//! Failures in bending that no margin is about: responses that are passive and
//! wrong, and chains that cannot be computed.

use std::f64::consts::TAU;

use anyhow::{Context, Result};
use linear::waves::lateral::BendingNetwork;
use linear::waves::transfer::tip_receptance;
use linear::{Drillstring, Method, Section};

use super::families::{Approach, Cell};
use super::verdict::Findings;
use crate::scenes::{Loss, shipped, shipped_with};
use campaign::engine::Recipe;

/// When the displacement after an impulse is compared, s.
const COMPARED_AT: f64 = 9.0;

/// The frequency at which chains are compared, Hz: within the band, and high
/// enough that waves in bending are short.
const CHAIN_FREQUENCY: f64 = 100.0;

/// How much of the displacement at the bit is left 9 s after an impulse, against
/// quadrature.
pub fn tail(cell: &Cell, method: Method, loss: Loss) -> Result<Findings> {
    let setting = (shipped_with("fig12.toml", loss)?.setting).sampled_at(cell.sampling_frequency);
    let build = |method| Recipe::alone(&setting, method, false, COMPARED_AT).build();
    let (found, reference) = (build(method)?, build(Method::Quadrature)?);
    let [found_last, true_last] = [&found, &reference].map(|system| {
        let taps = (system.responses.bending()).and_then(|bending| bending.taps_between(0, 0));
        taps.and_then(<[f64]>::last).copied().unwrap_or(f64::NAN)
    });
    Ok(Findings {
        margin_bending: found.bending_margin,
        error: Some((found_last / true_last - 1.0).abs()),
        ..Findings::default()
    })
}

/// Receptance at the end of a row of drillpipe, by products of transfer matrices
/// against joined stiffnesses; of these, doubled, against the same row joined one
/// section at a time.
pub fn chain(cell: &Cell) -> Result<Findings> {
    let setting = &shipped("fig12.toml")?.setting;
    let lateral = setting.lateral.as_ref();
    let lateral = lateral.context("the scene has no lateral motion")?;
    let count = cell.sections.unwrap_or(1);
    let pipe = &setting.string.sections()[0];
    let row = |sections: Vec<Section>| Drillstring::new(setting.string.material(), sections, 0.0);
    let string = row(vec![Section {
        repeat: count,
        ..pipe.clone()
    }])?;
    let rate = TAU * CHAIN_FREQUENCY;
    let joined = |string: &Drillstring| {
        let bit = linear::Sites::bit();
        BendingNetwork::new(string, lateral.bending, lateral.support, &bit)
            .map(|network| network.at_rate(rate)[(0, 0)])
    };
    let other = if cell.approach == Approach::TransferProducts {
        tip_receptance(&string, &lateral.bending, rate)
    } else {
        let one = Section {
            repeat: 1,
            ..pipe.clone()
        };
        joined(&row(vec![one; count])?)?
    };
    let error = (other / joined(&string)? - 1.0).norm();
    Ok(Findings {
        error: Some(error),
        no_answer: (!error.is_finite())
            .then(|| "the products overflow, or hold the growing wave alone".to_owned()),
        ..Findings::default()
    })
}
