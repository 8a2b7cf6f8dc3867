//! The surface speed from which on an eccentric mass brings the string to its wall in steady forward
//! motion, from the exact waves: contact or none.
//!
//! It stands in `manifest.json`: a speed is no friction, and `boundary.csv` has columns of frictions,
//! or of another limit where friction is no axis.

use anyhow::Result;
use linear::Complex64;
use linear::bending_decay::BendingDecay;
use linear::waves::lateral::BendingNetwork;
use serde::{Deserialize, Serialize};
use sim::EccentricMass;
use sim::steady_whirl::EccentricString;

use crate::axes::{position, range_of_axis};
use crate::curves::{Curve, each_once, places};
use campaign::plan::{LateralSettings, Sweep};
use campaign::quantities::{Axis, LENGTH, StringAxis, Units, WallQuantity};
use campaign::records::to_rpm;
use campaign::words::short;
use sim::Motion;

/// Values along an axis, between its ends.
const STEPS: usize = 40;

/// Contact is looked for from this part of the greatest surface speed on.
const SLOWEST: f64 = 1e-3;

/// From which surface speed on an eccentric mass brings the string to its wall.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ForwardContact {
    /// What of the mass the design varies; else its offset.
    pub along: Axis,
    /// The greatest surface speed of the design, rpm, up to which contact is looked for.
    pub fastest_rpm: f64,
    /// Where there is contact up to that, by rising values.
    pub points: Vec<ForwardTouch>,
}

/// The lowest surface speed at which an eccentric mass brings the string to its wall: it certainly
/// does not at a lower one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ForwardTouch {
    /// Of what the design varies of the mass.
    pub value: f64,
    /// rpm.
    pub surface_speed_rpm: f64,
    /// The site that is brought there, m from the bit.
    pub site_from_bit_m: f64,
}

impl ForwardContact {
    /// Of a sweep with one eccentric mass; `None` where other axes give each case its own limit,
    /// where sites are found, which may touch first, where the bit turns faster than the string, or damping
    /// is too light to decide.
    ///
    /// # Errors
    /// Where a site is not on the string.
    pub fn of(sweep: &Sweep) -> Result<Option<Self>> {
        let lateral = sweep.setting.whirling_with_string();
        let Some(lateral) = lateral.filter(|lateral| lateral.finding.is_none()) else {
            return Ok(None);
        };
        let (&[mass], Some(along)) = (&lateral.eccentric_masses[..], varied(sweep)) else {
            return Ok(None);
        };
        let fastest_rpm = match position(sweep, |axis| axis == Axis::SurfaceSpeedRpm) {
            Some(position) => Some(range_of_axis(sweep, position)[1]),
            None => sweep.conditions.surface_speed_rpm,
        };
        let Some(fastest_rpm) = fastest_rpm else {
            return Ok(None);
        };
        let is_mass = along == Axis::String(StringAxis::EccentricMass { mass: 0 });
        let values = match position(sweep, |axis| axis == along) {
            Some(position) => values_between(range_of_axis(sweep, position)),
            None => vec![mass.offset],
        };
        let masses = values.into_iter().map(|value| {
            let mass = EccentricMass {
                mass: if is_mass { value } else { mass.mass },
                offset: if is_mass { mass.offset } else { value },
                ..mass
            };
            (value, mass)
        });
        let points = touches(sweep, lateral, masses, fastest_rpm)?;
        Ok(points.map(|points| Self {
            along,
            fastest_rpm,
            points,
        }))
    }

    /// The curve of the speed over what the design varies, its name with the sites that are brought
    /// to their walls in these units; none without contact.
    pub fn curve(&self, units: Units) -> Option<Curve> {
        let points = self.points.iter();
        let piece: Vec<_> = points
            .map(|point| [point.value, point.surface_speed_rpm])
            .collect();
        let sites = each_once(self.points.iter().map(|point| point.site_from_bit_m));
        (!piece.is_empty()).then(|| Curve {
            name: format!(
                "speed from which the eccentric mass brings the string to its wall in steady motion, first {}",
                places(&sites, units)
            ),
            method: None,
            motion: Motion::Lateral,
            along: self.along,
            limited: Axis::SurfaceSpeedRpm,
            pieces: vec![piece],
            is_least: true,
        })
    }

    /// The same in a sentence.
    pub fn words(&self, units: Units) -> String {
        let slowest = (self.points.iter())
            .min_by(|one, other| one.surface_speed_rpm.total_cmp(&other.surface_speed_rpm));
        let Some(slowest) = slowest else {
            return format!(
                "in steady motion the eccentric mass brings no site to its wall up to {} rpm",
                short(self.fastest_rpm)
            );
        };
        let place = units.of(&LENGTH).text(slowest.site_from_bit_m, 3);
        let varied = match self.points.len() {
            1 => "",
            _ => ", in the case in which it does so at the lowest speed",
        };
        format!(
            "in steady motion the eccentric mass brings the string to its wall from {} rpm on, \
             first {place} from the bit{varied}",
            short(slowest.surface_speed_rpm)
        )
    }
}

/// What the design varies of the eccentric mass, else its offset; none where it varies both, or
/// anything else that decides where the string goes, or how far it may.
fn varied(sweep: &Sweep) -> Option<Axis> {
    let [mass, offset] = [
        StringAxis::EccentricMass { mass: 0 },
        StringAxis::EccentricOffset { mass: 0 },
    ]
    .map(Axis::String);
    let axes = sweep.design.axes();
    let weight_pushes = sweep.setting.hanging.is_some();
    let is_clearance = |axis: Axis| {
        let quantity = WallQuantity::Clearance;
        axis == Axis::Wall(quantity)
            || matches!(axis, Axis::WallAtSite { quantity: of_one, .. } if of_one == quantity)
    };
    let decides = |axis: &&Axis| axis.changes_string(weight_pushes) || is_clearance(**axis);
    let decisive: Vec<Axis> = axes.iter().filter(decides).copied().collect();
    match decisive[..] {
        [] => Some(offset),
        [axis] if axis == mass || axis == offset => Some(axis),
        _ => None,
    }
}

fn values_between([from, to]: [f64; 2]) -> Vec<f64> {
    if from == to {
        return vec![from];
    }
    let step = |step: usize| from + (to - from) * step as f64 / STEPS as f64;
    (0..=STEPS).map(step).collect()
}

/// The first touches of masses up to a surface speed, each with what the design varies of it; none
/// where the string is not damped enough to tell.
fn touches(
    sweep: &Sweep,
    lateral: &LateralSettings,
    masses: impl Iterator<Item = (f64, EccentricMass)>,
    fastest_rpm: f64,
) -> Result<Option<Vec<ForwardTouch>>> {
    let (string, sites) = (&sweep.setting.string, &sweep.setting.sites);
    let is_carried = (sweep.content.eccentric_masses.iter()).all(|mass| mass.form.is_carried());
    let fastest = fastest_rpm / to_rpm(1.0);
    let mut touches = Vec::new();
    for (value, mass) in masses {
        let mut carried = vec![0.0; sites.len()];
        carried[mass.site] = if is_carried { mass.mass } else { 0.0 };
        let sites = sites.clone().carrying(carried)?;
        let network = BendingNetwork::new(string, lateral.bending, lateral.support, &sites)?;
        let eccentric = EccentricString {
            // Friction plays no part before there is contact.
            walls: (lateral.walls.iter())
                .map(|wall| wall.with_friction(0.0))
                .collect(),
            mass,
            receptance: |rate: f64| -> Vec<Complex64> { network.at_rate(rate).entries().to_vec() },
            is_carried,
            decay: BendingDecay::with_masses(string, &lateral.bending, &sites),
        };
        let Ok(touch) = eccentric.first_touch([SLOWEST * fastest, fastest]) else {
            return Ok(None);
        };
        touches.extend(touch.map(|touch| ForwardTouch {
            value,
            surface_speed_rpm: to_rpm(touch.surface_speed),
            site_from_bit_m: sites.distances_from_bit()[touch.site],
        }));
    }
    Ok(Some(touches))
}
