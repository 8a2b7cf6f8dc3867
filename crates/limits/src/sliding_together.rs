//! Steady whirl of sites that slide, alone or together, that is known to balance: what friction is
//! enough for one, from the exact waves.

use linear::waves::lateral::BendingNetwork;
use linear::{DrillstringError, Sites, parallel};
use sim::steady_whirl::WhirlTogether;

use crate::many_sites_limit::whirling_sites;
use crate::whirl_limit::{WhirlMotion, WhirlPoint};
use campaign::plan::{LateralSettings, Setting};
use campaign::records::to_rpm;

/// With more sites it takes more than two seconds at a surface speed.
const MOST_SITES: usize = 32;

/// Surface speeds at which it is looked for, from the slowest to the fastest, evenly in their
/// logarithm.
const SPEEDS: usize = 5;

/// The least friction found between two surface speeds (rpm), which may be the same: what whirls and
/// slides at one does so at any faster one. Without points where there is but one site or more than
/// [`MOST_SITES`], where none is found, or where friction falls with the speed of sliding, so that
/// what slides has less than the static friction of an axis.
///
/// # Errors
/// Where a site is not on the string.
pub fn sliding_together(
    setting: &Setting,
    lateral: &LateralSettings,
    [slowest, fastest]: [f64; 2],
) -> Result<Vec<WhirlPoint>, DrillstringError> {
    let falls = (lateral.walls.iter()).any(|wall| wall.dynamic_ratio < 1.0);
    if !(2..=MOST_SITES).contains(&setting.sites.len()) || falls {
        return Ok(Vec::new());
    }
    let Setting { string, sites, .. } = setting;
    let network = BendingNetwork::new(string, lateral.bending, lateral.support, sites)?;
    let whirling = whirling_sites(setting, lateral, &network);
    let found = parallel::each(speeds([slowest, fastest]), |speed| {
        (speed, whirling.least_together(speed / to_rpm(1.0)))
    });
    let mut least: Option<WhirlTogether> = None;
    let mut points = Vec::new();
    for (speed, found) in found {
        if let Some(least) = &least {
            points.push(point(least, speed, sites));
        }
        let is_less = |found: &WhirlTogether| {
            (least.as_ref()).is_none_or(|least| found.friction < least.friction)
        };
        if let Some(found) = found.filter(is_less) {
            points.push(point(&found, speed, sites));
            least = Some(found);
        }
    }
    Ok(points)
}

fn speeds([slowest, fastest]: [f64; 2]) -> Vec<f64> {
    if slowest == fastest {
        return vec![fastest];
    }
    let part = |step: usize| step as f64 / (SPEEDS - 1) as f64;
    let between = (0..SPEEDS - 1).map(|step| slowest * (fastest / slowest).powf(part(step)));
    between.chain([fastest]).collect()
}

/// A whirl at a surface speed (rpm).
fn point(whirl: &WhirlTogether, surface_speed_rpm: f64, sites: &Sites) -> WhirlPoint {
    let place = |site: usize| sites.distances_from_bit()[site];
    let contacts = whirl.contacts.iter();
    let hardest =
        (contacts.clone()).max_by(|one, other| one.normal_force.total_cmp(&other.normal_force));
    WhirlPoint {
        surface_speed_rpm,
        friction: whirl.friction,
        site_from_bit_m: hardest.map_or(f64::NAN, |contact| place(contact.site)),
        radius_mm: None,
        precession_turns_per_s: whirl.rate / std::f64::consts::TAU,
        normal_force_kn: None,
        branch: None,
        motion: WhirlMotion::SlidingTogether,
        least: true,
        // From the bit up.
        sites_from_bit_m: contacts.rev().map(|contact| place(contact.site)).collect(),
    }
}
