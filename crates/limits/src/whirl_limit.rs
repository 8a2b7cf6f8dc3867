//! The limit of backward whirl, from the exact waves. At each site: the curves of
//! steady rolling whirl over surface speed, of which several may cross one speed.
//! Over all sites: the least friction of any steady whirl, which slides where the
//! string turns faster than it would roll.

use std::iter;

use linear::bending_decay::BendingDecay;
use linear::waves::lateral::BendingNetwork;
use linear::{DrillstringError, parallel};
use serde::{Deserialize, Deserializer, de};
use sim::steady_whirl::MOST_FRICTION;
use sim::{SteadyWhirl, WhirlingSite};

use crate::envelope::Envelope;
use campaign::plan::{LateralSettings, Setting};
use campaign::records::to_rpm;

/// How the surfaces meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WhirlMotion {
    /// The string rolls along the wall.
    #[default]
    Rolling,
    /// It rolls or slides, whichever needs less friction.
    RollingOrSliding,
    /// Of any sites, alone or together, it rolls or slides.
    AnySites,
    /// Of sites that slide, alone or together: there is whirl with this friction.
    SlidingTogether,
}

impl WhirlMotion {
    /// The name in `boundary.csv`.
    pub fn name(self) -> &'static str {
        match self {
            WhirlMotion::Rolling => "rolling",
            WhirlMotion::RollingOrSliding => "rolling_or_sliding",
            WhirlMotion::AnySites => "any_sites",
            WhirlMotion::SlidingTogether => "sliding_together",
        }
    }
}

/// One point of the limit of backward whirl: steady whirl at one site alone, or the friction
/// below which there is none of any sites together.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct WhirlPoint {
    /// Surface speed, rpm.
    pub surface_speed_rpm: f64,
    /// The least friction that sustains it.
    pub friction: f64,
    /// The site, m from the bit; of several, that which does most of the work.
    pub site_from_bit_m: f64,
    /// Radius of the centre, mm; of one site.
    pub radius_mm: Option<f64>,
    /// Rate of precession, against the rotation.
    pub precession_turns_per_s: f64,
    /// Normal force, kN; of one site.
    pub normal_force_kn: Option<f64>,
    /// Of rolling whirl, the curve that the point lies on, counted from 0 at each
    /// site; its rows follow one another.
    #[serde(default)]
    pub branch: Option<usize>,
    /// How the surfaces meet.
    #[serde(default)]
    pub motion: WhirlMotion,
    /// Whether no other whirl of this motion needs less friction at this speed.
    #[serde(default = "yes")]
    pub least: bool,
    /// The sites that do the work, m from the bit.
    #[serde(default, deserialize_with = "distances")]
    pub sites_from_bit_m: Vec<f64>,
}

/// A table without that column has one point for a speed.
fn yes() -> bool {
    true
}

/// Reads numbers with `;` between them.
fn distances<'de, D: Deserializer<'de>>(field: D) -> Result<Vec<f64>, D::Error> {
    let field = String::deserialize(field)?;
    let numbers = field.split(';').filter(|number| !number.is_empty());
    let numbers = numbers.map(|number| number.parse().map_err(de::Error::custom));
    numbers.collect()
}

/// Numbers that differ by a smaller part are the same but for rounding.
const ROUNDING: f64 = 1e-9;

/// A curve of whirls, each of which follows from the one before without a jump.
type Curve = Vec<SteadyWhirl>;

/// The steady whirls of one site, the others free.
struct SiteWhirls {
    distance_from_bit: f64,
    /// Of all that roll at the slowest surface speed or a slower one, that which needs
    /// the least friction.
    slower: Option<SteadyWhirl>,
    /// All that roll within the range of surface speeds.
    rolling: Vec<Curve>,
}

/// The limit between two surface speeds (rpm), which may be the same: of rolling
/// whirl by site, from the bit up, and by branch; then of any whirl.
///
/// # Errors
/// Where a site is not on the string.
pub fn whirl_limit(
    setting: &Setting,
    lateral: &LateralSettings,
    range_rpm: [f64; 2],
) -> Result<Vec<WhirlPoint>, DrillstringError> {
    let range = range_rpm.map(|speed| speed / to_rpm(1.0));
    let sites = (0..setting.sites.len()).rev().collect();
    let decay = decay(setting, lateral);
    let whirls = parallel::each(sites, |site| {
        let whirling = whirling(setting, lateral, &decay, site)?;
        let distance_from_bit = setting.sites.distances_from_bit()[site];
        Ok::<_, DrillstringError>(of_site(&whirling, distance_from_bit, range))
    });
    let whirls = whirls.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut points: Vec<WhirlPoint> = whirls.iter().flat_map(rolling_points).collect();
    points.extend(of_any_motion(&whirls, range));
    for point in &mut points {
        snap(&mut point.surface_speed_rpm, range_rpm);
    }
    mark_least(&mut points);
    Ok(points)
}

/// Undoes the rounding of units at the ends of the range.
fn snap(speed: &mut f64, range: [f64; 2]) {
    for end in range {
        if (*speed - end).abs() <= ROUNDING * end {
            *speed = end;
        }
    }
}

/// The least friction of steady rolling whirl at a surface speed (rpm), at any site.
///
/// # Errors
/// As [`whirl_limit`].
pub fn rolling_bound(
    setting: &Setting,
    lateral: &LateralSettings,
    surface_speed_rpm: f64,
) -> Result<Option<f64>, DrillstringError> {
    let points = whirl_limit(setting, lateral, [surface_speed_rpm; 2])?;
    Ok(rolling_envelope(&points).least())
}

/// The lowest surface speed (rpm) between two from which on any steady whirl, rolling or sliding,
/// needs no more than a friction, at any site, for each of two frictions; none where it always needs
/// more.
///
/// # Errors
/// As [`whirl_limit`].
pub fn whirl_from(
    setting: &Setting,
    lateral: &LateralSettings,
    range_rpm: [f64; 2],
    frictions: [f64; 2],
) -> Result<[Option<f64>; 2], DrillstringError> {
    let points = whirl_limit(setting, lateral, range_rpm)?;
    let any = (points.iter()).filter(|it| it.motion == WhirlMotion::RollingOrSliding);
    let any: Vec<[f64; 2]> = any.map(|it| [it.surface_speed_rpm, it.friction]).collect();
    Ok(frictions.map(|friction| first_at_most(&any, friction)))
}

/// Where a falling curve comes down to a value.
fn first_at_most(curve: &[[f64; 2]], value: f64) -> Option<f64> {
    let place = curve.iter().position(|point| point[1] <= value)?;
    let [x, y] = curve[place];
    let Some(&[before, higher]) = place.checked_sub(1).map(|before| &curve[before]) else {
        return Some(x);
    };
    Some(before + (x - before) * (higher - value) / (higher - y))
}

/// The least friction of steady rolling whirl over surface speed (rpm).
pub fn rolling_envelope(points: &[WhirlPoint]) -> Envelope {
    let rolling = branches(points).filter(|curve| curve[0].motion == WhirlMotion::Rolling);
    let place = |point: &WhirlPoint| (point.surface_speed_rpm, point.friction);
    let curves = rolling.map(|curve| curve.iter().map(place).collect());
    Envelope::new(&curves.collect::<Vec<_>>())
}

/// The points by curve.
pub fn branches(points: &[WhirlPoint]) -> impl Iterator<Item = &[WhirlPoint]> {
    let curve = |point: &WhirlPoint| (point.motion, point.site_from_bit_m, point.branch);
    points.chunk_by(move |one, other| curve(one) == curve(other))
}

fn mark_least(points: &mut [WhirlPoint]) {
    let envelope = rolling_envelope(points);
    let points = points.iter_mut();
    for point in points.filter(|point| point.motion == WhirlMotion::Rolling) {
        let least = envelope.at(point.surface_speed_rpm);
        point.least = least.is_none_or(|least| point.friction <= least * (1.0 + ROUNDING));
    }
}

fn of_site(
    whirling: &WhirlingSite<impl Fn(f64) -> [f64; 2]>,
    distance_from_bit: f64,
    [slowest, fastest]: [f64; 2],
) -> SiteWhirls {
    let rolling = if slowest < fastest {
        let branches = whirling.branches([slowest, fastest]);
        let parts = |branch: &Curve| part_within(branch, [slowest, fastest]);
        branches.iter().flat_map(parts).collect()
    } else {
        let whirls = whirling.rolling_at(fastest).into_iter();
        let sustained = whirls.filter(|whirl| whirl.least_friction <= MOST_FRICTION);
        sustained.map(|whirl| vec![whirl]).collect()
    };
    SiteWhirls {
        distance_from_bit,
        slower: whirling.least_friction(slowest),
        rolling,
    }
}

/// All steady rolling whirls at a surface speed (rad/s) at one site, the others free.
///
/// # Errors
/// Where the site is not on the string.
pub fn rolling_whirls(
    setting: &Setting,
    lateral: &LateralSettings,
    site: usize,
    surface_speed: f64,
) -> Result<Vec<SteadyWhirl>, DrillstringError> {
    let decay = decay(setting, lateral);
    Ok(whirling(setting, lateral, &decay, site)?.rolling_at(surface_speed))
}

/// How fast oscillations of a string with its eccentric masses decay.
pub(super) fn decay(setting: &Setting, lateral: &LateralSettings) -> BendingDecay {
    BendingDecay::with_masses(&setting.string, &lateral.bending, &setting.sites)
}

/// A site as the only one: others that are free and carry no mass change nothing.
fn whirling(
    setting: &Setting,
    lateral: &LateralSettings,
    decay: &BendingDecay,
    site: usize,
) -> Result<WhirlingSite<impl Fn(f64) -> [f64; 2]>, DrillstringError> {
    let (alone, number) = setting.sites.alone(site);
    let network = BendingNetwork::new(&setting.string, lateral.bending, lateral.support, &alone)?;
    Ok(WhirlingSite {
        // Friction plays no part.
        wall: lateral.walls[site].with_friction(0.0),
        dynamic_stiffness: move |rate| network.dynamic_stiffness(number, rate),
        decay: decay.clone(),
    })
}

/// The parts of a curve within a range of surface speeds.
fn part_within(curve: &[SteadyWhirl], range: [f64; 2]) -> Vec<Curve> {
    let mut parts: Vec<Curve> = Vec::new();
    for ends in curve.windows(2) {
        let [start, end] = [ends[0].surface_speed, ends[1].surface_speed];
        let within = inside(start, end, range).filter(|[enter, leave]| enter < leave);
        let Some([enter, leave]) = within else {
            continue;
        };
        let first = between(ends, enter);
        match parts.last_mut() {
            Some(part) if part.last() == Some(&first) => {}
            _ => parts.push(vec![first]),
        }
        if let Some(part) = parts.last_mut() {
            part.push(between(ends, leave));
        }
    }
    parts
}

/// The part of the way from one value to another that is within a range.
pub fn inside(from: f64, to: f64, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    if from == to {
        return (low..=high).contains(&from).then_some([0.0, 1.0]);
    }
    let [one, two] = [low, high].map(|end| (end - from) / (to - from));
    let (enters, leaves) = (one.min(two).max(0.0), one.max(two).min(1.0));
    (enters <= leaves).then_some([enters, leaves])
}

/// A point of the chord between two.
fn between(ends: &[SteadyWhirl], place: f64) -> SteadyWhirl {
    if place == 0.0 {
        return ends[0];
    }
    if place == 1.0 {
        return ends[1];
    }
    let mean = |of: fn(&SteadyWhirl) -> f64| of(&ends[0]) + place * (of(&ends[1]) - of(&ends[0]));
    SteadyWhirl {
        surface_speed: mean(|whirl| whirl.surface_speed),
        radius: mean(|whirl| whirl.radius),
        rate: mean(|whirl| whirl.rate),
        normal_force: mean(|whirl| whirl.normal_force),
        least_friction: mean(|whirl| whirl.least_friction),
    }
}

fn rolling_points(site: &SiteWhirls) -> impl Iterator<Item = WhirlPoint> {
    (site.rolling.iter().enumerate()).flat_map(move |(branch, curve)| {
        curve.iter().map(move |whirl| WhirlPoint {
            branch: Some(branch),
            ..point(whirl, whirl.surface_speed, site.distance_from_bit)
        })
    })
}

/// A whirl at the speed at which the string rolls, or a higher one.
fn point(whirl: &SteadyWhirl, surface_speed: f64, site_from_bit_m: f64) -> WhirlPoint {
    WhirlPoint {
        surface_speed_rpm: to_rpm(surface_speed),
        friction: whirl.least_friction,
        site_from_bit_m,
        radius_mm: Some(1e3 * whirl.radius),
        precession_turns_per_s: whirl.rate / std::f64::consts::TAU,
        normal_force_kn: Some(1e-3 * whirl.normal_force),
        branch: None,
        motion: WhirlMotion::Rolling,
        least: true,
        sites_from_bit_m: vec![site_from_bit_m],
    }
}

/// The least friction of any steady whirl over surface speed. A string that turns
/// faster than one that rolls can whirl like it and slide: so the least over all
/// speeds up to this one.
fn of_any_motion(sites: &[SiteWhirls], [slowest, fastest]: [f64; 2]) -> Vec<WhirlPoint> {
    let mut whirls: Vec<Candidate> = Vec::new();
    for site in sites {
        let rolling = site.rolling.iter().map(Vec::as_slice);
        for curve in iter::once(site.slower.as_slice()).chain(rolling) {
            // With a gap between curves.
            let first = whirls.last().map_or(0, |last| last.place + 2);
            whirls.extend(curve.iter().zip(first..).map(|(whirl, place)| Candidate {
                whirl,
                site_from_bit_m: site.distance_from_bit,
                place,
            }));
        }
    }
    whirls.sort_by(|one, other| (one.whirl.surface_speed).total_cmp(&other.whirl.surface_speed));
    let mut least: Option<Candidate> = None;
    let mut points = Vec::new();
    for candidate in whirls {
        if least.is_some_and(|least| least.whirl.least_friction <= candidate.whirl.least_friction) {
            continue;
        }
        let speed = candidate.whirl.surface_speed;
        if speed > slowest && slowest < fastest {
            if let Some(least) = least {
                if points.is_empty() {
                    points.push(least.at(slowest));
                }
                // Unless the curve leads from one to the other.
                if least.place.abs_diff(candidate.place) != 1 {
                    points.push(least.at(speed));
                }
            }
            points.push(candidate.at(speed));
        }
        least = Some(candidate);
    }
    if let Some(least) = least {
        // One of slower whirls may stay the least to the end.
        if points.is_empty() && slowest < fastest {
            points.push(least.at(slowest));
        }
        points.push(least.at(fastest));
    }
    points
}

/// A whirl on a curve.
#[derive(Clone, Copy)]
struct Candidate<'a> {
    whirl: &'a SteadyWhirl,
    site_from_bit_m: f64,
    /// Neighbours on a curve have neighbouring places.
    place: usize,
}

impl Candidate<'_> {
    fn at(&self, surface_speed: f64) -> WhirlPoint {
        WhirlPoint {
            motion: WhirlMotion::RollingOrSliding,
            ..point(self.whirl, surface_speed, self.site_from_bit_m)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whirl(surface_speed: f64, least_friction: f64) -> SteadyWhirl {
        SteadyWhirl {
            surface_speed,
            radius: 0.02,
            rate: -9.0,
            normal_force: 1e3,
            least_friction,
        }
    }

    #[test]
    fn a_falling_curve_comes_down_to_a_value_once() {
        let curve = [
            [10.0, 3.0],
            [20.0, 2.0],
            [20.0, 1.5],
            [40.0, 1.5],
            [50.0, 0.5],
        ];
        for (value, expected) in [
            (4.0, Some(10.0)),
            (3.0, Some(10.0)),
            (2.5, Some(15.0)),
            (1.7, Some(20.0)),
            (1.0, Some(45.0)),
            (0.4, None),
        ] {
            assert_eq!(first_at_most(&curve, value), expected, "{value}");
        }
    }

    #[test]
    fn whirl_that_slides_and_stays_the_least_is_so_from_the_slowest_speed_on() {
        let site = SiteWhirls {
            distance_from_bit: 50.0,
            slower: Some(whirl(3.0, 0.5)),
            rolling: vec![vec![whirl(5.0, 1.1), whirl(6.0, 1.2)]],
        };
        let least = |range| {
            let points = of_any_motion(std::slice::from_ref(&site), range);
            let speeds = points.iter().map(|point| point.surface_speed_rpm);
            assert!(points.iter().all(|point| point.friction == 0.5));
            speeds.collect::<Vec<_>>()
        };
        assert_eq!(least([5.0, 6.0]), [5.0, 6.0].map(to_rpm));
        assert_eq!(least([6.0; 2]), [to_rpm(6.0)]);
    }
}
