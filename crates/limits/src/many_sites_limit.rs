//! The friction below which no steady whirl of any sites lasts, alone or together, from the exact
//! waves.

use linear::waves::lateral::BendingNetwork;
use linear::{Complex64, DrillstringError};
use sim::{SitesWhirl, WhirlingSites};

use crate::whirl_limit::{WhirlMotion, WhirlPoint, decay};
use campaign::plan::{LateralSettings, Setting};
use campaign::records::to_rpm;

/// With more sites it would take longer than the ten seconds that these take over threefold surface
/// speeds, as the cube of their number.
pub const MOST_SITES: usize = 300;

/// A site that does a smaller part of the work than this is not named.
const LEAST_SHARE: f64 = 0.05;

/// The limit between two surface speeds (rpm), which may be the same: a staircase that falls.
/// Without points where there is but one site or more than [`MOST_SITES`], or where any whirl needs
/// more friction than any wall has.
///
/// # Errors
/// Where a site is not on the string.
pub fn many_sites_limit(
    setting: &Setting,
    lateral: &LateralSettings,
    range_rpm: [f64; 2],
) -> Result<Vec<WhirlPoint>, DrillstringError> {
    let Setting { string, sites, .. } = setting;
    if !(2..=MOST_SITES).contains(&sites.len()) {
        return Ok(Vec::new());
    }
    let network = BendingNetwork::new(string, lateral.bending, lateral.support, sites)?;
    let whirling = whirling_sites(setting, lateral, &network);
    let [slowest, fastest] = range_rpm;
    let whirls = whirling.least_friction(range_rpm.map(|speed| speed / to_rpm(1.0)));
    let places = sites.distances_from_bit();
    let mut points: Vec<WhirlPoint> = Vec::new();
    let mut last: Option<&SitesWhirl> = None;
    for whirl in &whirls {
        let speed = to_rpm(whirl.surface_speed);
        if speed > slowest {
            // Down to it from what is the least at slower speeds, which begin with the range.
            if let Some(last) = last {
                if points.is_empty() {
                    points.push(point(last, slowest, places));
                }
                points.push(point(last, speed, places));
            }
            points.push(point(whirl, speed, places));
        }
        last = Some(whirl);
    }
    if let Some(last) = last {
        if points.is_empty() && slowest < fastest {
            points.push(point(last, slowest, places));
        }
        points.push(point(last, fastest, places));
    }
    Ok(points)
}

/// The sites of a string, by the receptance of its waves.
pub(super) fn whirling_sites<'a>(
    setting: &Setting,
    lateral: &LateralSettings,
    network: &'a BendingNetwork,
) -> WhirlingSites<impl Fn(f64) -> Vec<Complex64> + Sync + 'a> {
    WhirlingSites {
        // Friction plays no part.
        walls: (lateral.walls.iter())
            .map(|wall| wall.with_friction(0.0))
            .collect(),
        receptance: |rate: f64| network.at_rate(rate).entries().to_vec(),
        decay: decay(setting, lateral),
    }
}

/// The least at a surface speed (rpm), with sites at these distances from the bit (m).
fn point(whirl: &SitesWhirl, surface_speed_rpm: f64, places: &[f64]) -> WhirlPoint {
    let shares = || whirl.shares.iter().zip(places);
    // From the bit up.
    let working = (shares().rev()).filter(|(share, _)| **share >= LEAST_SHARE);
    let most = shares().max_by(|one, other| one.0.total_cmp(other.0));
    WhirlPoint {
        surface_speed_rpm,
        friction: whirl.least_friction,
        site_from_bit_m: most.map_or(f64::NAN, |(_, place)| *place),
        radius_mm: None,
        precession_turns_per_s: whirl.rate / std::f64::consts::TAU,
        normal_force_kn: None,
        branch: None,
        motion: WhirlMotion::AnySites,
        least: true,
        sites_from_bit_m: working.map(|(_, place)| *place).collect(),
    }
}
