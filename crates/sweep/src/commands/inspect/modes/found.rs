//! The modes of a string, in torsion and, where that is modelled, along its axis and in bending.

use std::f64::consts::TAU;

use anyhow::Result;
use linear::modes::{TorsionalMode, damped_modes, damped_modes_below_drive};
use linear::natural_frequencies::{NaturalFrequencies, Shape};
use linear::{BuildError, Sites, SurfaceSupport};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::speeds::Excitation;
use crate::commands::status::UsageError;
use campaign::plan::Sweep;

/// More of them are not listed: they are too dense to tell apart.
const MOST: usize = 500;

/// Places along the string at which shapes are given.
const PLACES: usize = 201;

/// Pieces that are gone through in about a minute.
const MOST_PIECES: f64 = 3e8;

/// What swings.
#[derive(Debug, Clone, PartialEq)]
pub enum ModeFamily {
    /// The string in torsion.
    Torsion,
    /// The string along its axis, its upper end held or, with this mass (kg), free.
    Axial(Option<f64>),
    /// The string in bending below the uppermost of the places (m from the bit, from there down)
    /// that hold it.
    BetweenHeld(Vec<f64>),
    /// The whole string in bending, as the surface holds it.
    Bending(SurfaceSupport),
    /// What is below a place (m from the bit) above which it is held sideways.
    BelowHeld(f64),
}

impl ModeFamily {
    /// Its name in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Torsion => "torsion",
            Self::Axial(_) => "axial",
            Self::BetweenHeld(_) => "bending_between_sites",
            Self::Bending(_) | Self::BelowHeld(_) => "bending",
        }
    }

    /// Its name in words.
    pub fn words(&self) -> &'static str {
        match self {
            Self::Torsion => "torsion",
            Self::Axial(_) => "along the axis",
            Self::BetweenHeld(_) => "bending between the sites",
            Self::Bending(_) => "bending of the whole string",
            Self::BelowHeld(_) => "bending, without its wall",
        }
    }

    /// Its name above a picture of one of its modes.
    pub fn short_words(&self) -> &'static str {
        match self {
            Self::Torsion => "torsion",
            Self::Axial(_) => "along the axis",
            Self::BetweenHeld(_) => "between the sites",
            Self::Bending(_) => "whole string",
            Self::BelowHeld(_) => "without its wall",
        }
    }

    /// Rigid-body modes of a rod, unless the string is pulled.
    fn as_rigid_rod(&self) -> usize {
        match self {
            Self::Torsion | Self::Axial(None) | Self::Bending(SurfaceSupport::Clamped) => 0,
            Self::Axial(Some(_)) => 1,
            Self::BetweenHeld(places) => usize::from(places.len() == 1),
            Self::Bending(SurfaceSupport::Pinned) | Self::BelowHeld(_) => 1,
            Self::Bending(SurfaceSupport::Free) => 2,
        }
    }
}

/// Those of one way to swing.
#[derive(Serialize)]
pub struct Modes {
    /// Which.
    #[serde(flatten)]
    pub of: ModeFamily,
    /// Motions as a rigid rod.
    #[serde(rename = "rigid_body_modes")]
    pub rigid: usize,
    /// Ways in which the string buckles.
    #[serde(rename = "buckled_modes")]
    pub buckled: usize,
    /// Natural frequencies from the lowest up, Hz.
    #[serde(rename = "frequencies_hz")]
    pub frequencies: Vec<f64>,
    /// How many more are below the highest that is excited.
    #[serde(rename = "not_listed")]
    pub left_out: usize,
    /// Damping ratios, where they are known.
    #[serde(rename = "damping_ratios")]
    pub damping: Vec<Option<f64>>,
    /// Shapes of the lowest.
    #[serde(skip)]
    pub shapes: Vec<Shape>,
}

/// The modes with damping of natural frequencies without it (rad/s).
type Damped<'a> = &'a dyn Fn(&[f64]) -> Result<Vec<Option<TorsionalMode>>, BuildError>;

impl Modes {
    /// Adds what is known of their damping.
    fn damp(&mut self, damped: Damped) -> Result<()> {
        let frequencies: Vec<f64> = self.frequencies.iter().map(|it| TAU * it).collect();
        let modes = damped(&frequencies)?.into_iter();
        self.damping = modes
            .map(|mode| mode.map(|mode| mode.damping_ratio()))
            .collect();
        Ok(())
    }
}

/// By its name, with the places that hold the string, where it is held.
impl Serialize for ModeFamily {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("motion", self.name())?;
        match self {
            Self::BetweenHeld(places) => map.serialize_entry("held_from_bit_m", places)?,
            Self::BelowHeld(place) => map.serialize_entry("held_above_from_bit_m", place)?,
            Self::Axial(Some(mass)) => map.serialize_entry("hanging_mass_kg", mass)?,
            _ => {}
        }
        map.end()
    }
}

/// All modes up to the highest frequency that is excited, and at least a given number.
///
/// # Errors
/// Where that takes too long.
pub fn find(sweep: &Sweep, count: usize, excitation: &Excitation) -> Result<Vec<Modes>> {
    let setting = &sweep.setting;
    let torsion = NaturalFrequencies::torsion(&setting.string)?;
    let mut found = vec![modes(ModeFamily::Torsion, &torsion, count, excitation)?];
    found[0].damp(&|frequencies| damped_modes(&setting.string, frequencies))?;
    if let Some(cutting) = &setting.cutting {
        let rod = &cutting.rod;
        let of = ModeFamily::Axial(rod.top_drive().map(|hoist| hoist.inertia));
        let mut axial = modes(of, &NaturalFrequencies::axial(rod)?, count, excitation)?;
        axial.damp(&|frequencies| damped_modes_below_drive(rod, frequencies))?;
        found.push(axial);
    }
    if let Some(lateral) = &setting.lateral {
        let (string, bending) = (&setting.string, &lateral.bending);
        let places = lateral.held_places(&setting.sites);
        if places.iter().any(|place| *place > 0.0) {
            let natural = NaturalFrequencies::held(string, bending, &Sites::new(string, &places)?)?;
            let of = ModeFamily::BetweenHeld(places);
            found.push(modes(of, &natural, count, excitation)?);
        }
        let natural = NaturalFrequencies::bending(string, bending, lateral.support)?;
        let bends = string.bending_length();
        let of = match bends < string.length() {
            true => ModeFamily::BelowHeld(bends),
            false => ModeFamily::Bending(lateral.support),
        };
        found.push(modes(of, &natural, count, excitation)?);
    }
    Ok(found)
}

fn modes(
    of: ModeFamily,
    natural: &NaturalFrequencies,
    count: usize,
    excitation: &Excitation,
) -> Result<Modes> {
    let highest = TAU * excitation.highest();
    let once = natural.pieces(highest);
    // Before counting those below, which goes through all once.
    check_work(&of, highest, once, count)?;
    let unrestored = natural.unrestored()?;
    let below = natural.below(highest)?.saturating_sub(unrestored);
    let listed = below.clamp(count, MOST);
    check_work(&of, highest, once, listed)?;
    let frequencies = if listed == below {
        natural.all_below(highest)?
    } else {
        natural.lowest(listed)?
    };
    let shapes = frequencies.iter().take(count);
    let shapes = shapes.map(|&frequency| natural.shape(frequency, PLACES));
    let rigid = unrestored.min(of.as_rigid_rod());
    Ok(Modes {
        of,
        rigid,
        buckled: unrestored - rigid,
        left_out: below.saturating_sub(listed),
        damping: vec![None; frequencies.len()],
        shapes: shapes.collect::<Result<_, BuildError>>()?,
        frequencies: frequencies.iter().map(|it| it / TAU).collect(),
    })
}

/// Refuses to find modes where that would take more than about a minute.
fn check_work(of: &ModeFamily, highest: f64, once: f64, modes: usize) -> Result<()> {
    let pieces = once * (modes * NaturalFrequencies::COUNTS) as f64;
    if pieces <= MOST_PIECES {
        return Ok(());
    }
    let message = format!(
        "natural frequencies in {} up to {:.4} Hz would go through {pieces:.1e} pieces of \
         string, more than {MOST_PIECES:.0e}: ask for lower `--orders`, or for a lower surface \
         speed in the sweep file",
        of.words(),
        highest / TAU
    );
    Err(UsageError(message).into())
}
