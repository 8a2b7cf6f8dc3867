//! The modes of a string, in torsion and, where that is modelled, in bending.

use std::f64::consts::TAU;

use anyhow::Result;
use linear::modes::damped_modes;
use linear::natural_frequencies::{NaturalFrequencies, Shape};
use linear::{BuildError, Channel};

use super::speeds::Excitation;
use crate::commands::status::UsageError;
use campaign::plan::Sweep;

/// More of them are not listed: they are too dense to tell apart.
const MOST: usize = 500;

/// Places along the string at which shapes are told.
const PLACES: usize = 201;

/// Pieces that are gone through in about a minute.
const MOST_PIECES: f64 = 3e8;

/// Those of one way to swing.
pub struct Modes {
    /// Which.
    pub channel: Channel,
    /// Motions that nothing brings back.
    pub unrestored: usize,
    /// Natural frequencies from the lowest up, Hz.
    pub frequencies: Vec<f64>,
    /// How many more are below the highest that is excited.
    pub left_out: usize,
    /// Damping ratios, where they are known.
    pub damping: Vec<Option<f64>>,
    /// Shapes of the lowest.
    pub shapes: Vec<Shape>,
}

/// All modes up to the highest frequency that is excited, and at least so many.
///
/// # Errors
/// Where that takes too long.
pub fn find(sweep: &Sweep, count: usize, excitation: &Excitation) -> Result<Vec<Modes>> {
    let setting = &sweep.setting;
    let torsion = NaturalFrequencies::torsion(&setting.string)?;
    let mut found = vec![modes(Channel::Torsion, &torsion, count, excitation)?];
    let frequencies: Vec<f64> = found[0].frequencies.iter().map(|it| TAU * it).collect();
    let damped = damped_modes(&setting.string, &frequencies)?.into_iter();
    found[0].damping = damped
        .map(|mode| mode.map(|mode| mode.damping_ratio()))
        .collect();
    if let Some(lateral) = &setting.lateral {
        let bending =
            NaturalFrequencies::bending(&setting.string, &lateral.bending, lateral.support)?;
        found.push(modes(Channel::Bending, &bending, count, excitation)?);
    }
    Ok(found)
}

fn modes(
    channel: Channel,
    natural: &NaturalFrequencies,
    count: usize,
    excitation: &Excitation,
) -> Result<Modes> {
    let highest = TAU * excitation.highest();
    let once = natural.pieces(highest);
    // Before counting those below, which goes through all once.
    check_work(channel, highest, once, count)?;
    let unrestored = natural.unrestored()?;
    let below = natural.below(highest)?.saturating_sub(unrestored);
    let listed = below.clamp(count, MOST);
    check_work(channel, highest, once, listed)?;
    let frequencies = if listed == below {
        natural.all_below(highest)?
    } else {
        natural.lowest(listed)?
    };
    let shapes = frequencies.iter().take(count);
    let shapes = shapes.map(|&frequency| natural.shape(frequency, PLACES));
    Ok(Modes {
        channel,
        unrestored,
        left_out: below.saturating_sub(listed),
        damping: vec![None; frequencies.len()],
        shapes: shapes.collect::<Result<_, BuildError>>()?,
        frequencies: frequencies.iter().map(|it| it / TAU).collect(),
    })
}

/// Refuses to find so many modes where that would take more than about a minute.
fn check_work(channel: Channel, highest: f64, once: f64, modes: usize) -> Result<()> {
    let pieces = once * (modes * NaturalFrequencies::COUNTS) as f64;
    if pieces <= MOST_PIECES {
        return Ok(());
    }
    let message = format!(
        "natural frequencies in {channel} up to {:.4} Hz would go through {pieces:.1e} pieces of \
         string, more than {MOST_PIECES:.0e}: ask for lower `--orders`, or for a lower surface \
         speed in the sweep file",
        highest / TAU
    );
    Err(UsageError(message).into())
}
